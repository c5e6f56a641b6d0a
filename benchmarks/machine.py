"""Where the benchmark runs."""

from __future__ import annotations

import os
import platform
from pathlib import Path

from .peers import PACKAGES, installed
from .results import Machine


def this_machine() -> Machine:
    """Processor, system and the versions that matter."""
    return Machine(
        processor=_processor(),
        cores=os.cpu_count() or 1,
        system=f"{platform.system()} {platform.machine()}",
        python=platform.python_version(),
        versions={name: installed(name) for name in ("gearlash", "numpy", "llvmlite", *PACKAGES)},
    )


def _processor() -> str:
    """As Linux names it, else as Python does."""
    listed = Path("/proc/cpuinfo")
    if listed.exists():
        for line in listed.read_text(encoding="utf-8", errors="replace").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()
