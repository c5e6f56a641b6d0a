"""``make oracles``: AUTO-07p on smoothed systems, its special points kept in ``kept.json``.

AUTO-07p is a package of Debian (`apt-get install auto-07p`); without it nothing is changed.
E. J. Doedel et al., AUTO-07P: Continuation and Bifurcation Software for Ordinary Differential Equations.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from orbits.members import orbit

from .cases import CASES, WIDTHS, Asked
from .problem import write

HERE = Path(__file__).parent
KEPT = HERE / "kept.json"
KINDS = {"LP": "fold", "PD": "doubling", "BP": "branch point", "TR": "Neimark-Sacker", "UZ": "grazing"}
TOUCHES = 1e-7  # how near to the boundary AUTO's grazing is


def main(names: Iterable[str]) -> int:
    if shutil.which("auto-07p") is None or shutil.which("gfortran") is None:
        print("make oracles needs AUTO-07p and gfortran (Debian: apt-get install auto-07p gfortran)")
        return 1
    kept: dict[str, Any] = json.loads(KEPT.read_text()) if KEPT.exists() else {"cases": {}}
    kept["program"] = f"AUTO-07p {_version()}"
    wanted = list(names) or list(CASES)
    tasks = [(name, CASES[name].width / 2**k) for name in wanted for k in range(WIDTHS)]
    with tempfile.TemporaryDirectory() as root, ThreadPoolExecutor(os.cpu_count()) as pool:
        running = []
        for name, width in tasks:  # one after another: the integrator that samples the start is shared
            folder = Path(root) / f"{len(running)}"
            prepare(folder, CASES[name], width)
            running.append(pool.submit(special_points, folder))
        answers = [each.result() for each in running]
    for name in wanted:
        kept["cases"][name] = {}
    for (name, width), found in zip(tasks, answers, strict=True):
        kept["cases"][name][repr(width)] = found
        print(f"{name}, width {width:g}:", *(f"{kind} {value:.10g}" for kind, value in found), flush=True)
    KEPT.write_text(json.dumps(kept, indent=1) + "\n")
    return 0


def prepare(folder: Path, asked: Asked, width: float) -> None:
    """Writes all that AUTO reads."""
    folder.mkdir()
    family, values = asked.family(), {**asked.values, "omega": asked.omega}
    write(folder, family, orbit(family, **values), values, width)
    wanted = {
        "size": len(family.states), "free": 1, "mesh": asked.mesh, "steps": asked.steps,
        "lower": asked.lower, "upper": asked.upper, "longest": asked.longest, "tolerance": asked.tolerance,
    }  # fmt: skip
    (folder / "wanted.json").write_text(json.dumps(wanted))
    for file in ("smoothed.f90", "branch.auto"):
        shutil.copy(HERE / file, folder)


def special_points(folder: Path) -> list[tuple[str, float]]:
    """(kind, ω) in the order in which AUTO met them, both ways from the start."""
    done = subprocess.run(
        ["auto-07p", "branch.auto"], cwd=folder, capture_output=True, text=True,
        env={**os.environ, "OMP_NUM_THREADS": "1"}, check=False,
    )  # fmt: skip
    answer = folder / "found.json"
    if not answer.exists():
        raise RuntimeError(f"AUTO-07p says:\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}")
    found = json.loads(answer.read_text())
    touching = [row for row in found if row[0] != "UZ" or min(abs(row[2]), abs(row[3])) < TOUCHES]
    return [(KINDS[kind], value) for kind, value, *_ in touching if kind in KINDS]


def _version() -> str:
    asked = ["dpkg-query", "--show", "--showformat", "${Version}", "auto-07p"]
    return subprocess.run(asked, capture_output=True, text=True, check=False).stdout or "of unknown version"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
