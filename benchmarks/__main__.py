"""`python -m benchmarks FOLDER [--quick]`: runs everything and writes the page benchmarks.md with its figure.

On a machine that does nothing else, please. `--quick` goes once through small work; its times mean little.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from gearlash import plots
from gearlash.results.store import write_whole

from .cost import cost
from .page import FIGURE, page
from .results import Benchmark
from .run import benchmark
from .words import aim, measured, verdict


def main(arguments: list[str] | None = None) -> int:
    """Prints the bars, met or missed, at the end."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("folder", type=Path, metavar="FOLDER")
    parser.add_argument("--quick", action="store_true")
    asked = parser.parse_args(arguments)
    found = benchmark(asked.quick, lambda stage: print(stage, file=sys.stderr, flush=True))
    write(found, asked.folder)
    for bar in found.bars:
        where = f" ({bar.where})" if bar.where else ""
        print(f"{verdict(bar)}: {bar.sentence}{where}: {measured(bar)}, aim {aim(bar)}")
    return 0


def write(found: Benchmark, folder: Path) -> None:
    """The page and its figure."""
    picture = folder / FIGURE
    picture.parent.mkdir(parents=True, exist_ok=True)
    plots.save(cost(found.curves), picture.with_suffix(""), ("png",), dpi=200.0)
    write_whole(folder / "benchmarks.md", page(found).encode("utf-8"))


if __name__ == "__main__":
    raise SystemExit(main())
