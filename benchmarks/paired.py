"""Two versions of the package on the same work, turn by turn: ``python -m benchmarks.paired SRC [REPEATS]``.

SRC is the `src` folder of the other version. Each version has a process of its own; they take turns, so that
what else the machine does meets both. Told are the least times of each, of the processor and not of the
clock, and their ratio."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parents[1] / "src"
PROGRAM = """
import json, sys, time
import numpy as np
import gearlash as gl

def pair(case, **values):
    family = gl.load_case(case).family()[0]
    system = family.system(values)
    props = gl.propagators(system)
    start = np.asarray(family.start(values))
    return system, props, gl.march(props, start, 600).states[-1]

def march(found, periods, calls=1):
    def work():
        for _ in range(calls):
            gl.march(found[1], found[2], periods)
    return work

crossing = pair("article", omega=0.8)
often = pair("article", omega=1.8, D=0.3)
clear = pair("article", omega=1.0)
small = pair("kahraman-singh", omega=0.9)
quiet = pair("kahraman-singh", omega=0.75)
starts = crossing[2] + np.random.default_rng(1).normal(scale=0.1, size=(64, len(crossing[2])))
WORKS = {
    "helical, impacts: 1,000 periods": march(crossing, 1000),
    "helical, many impacts: 1,000 periods": march(often, 1000),
    "helical, no impacts: 1,000 periods": march(clear, 1000),
    "helical, no impacts: 5,000 periods": march(clear, 5000),
    "helical, impacts: 1 period, 200 calls": march(crossing, 1, 200),
    "helical, impacts: 20 periods, 50 calls": march(crossing, 20, 50),
    "helical, no impacts: 1 period, 200 calls": march(clear, 1, 200),
    "one degree of freedom, impacts: 1,000 periods": march(small, 1000),
    "one degree of freedom, no impacts: 1,000 periods": march(quiet, 1000),
    "one degree of freedom, no impacts: 5,000 periods": march(quiet, 5000),
    "64 motions, impacts: 100 periods": lambda: gl.march_many(crossing[1], starts, 100, threads=1),
    "derivative: 20 calls": lambda: [gl.variational(crossing[1], crossing[2], 1.0) for _ in range(20)],
    "trace: 20 calls": lambda: [gl.trace(crossing[1], crossing[2], 1.0) for _ in range(20)],
    "building, helical": lambda: gl.propagators(crossing[0]),
    "building, one degree of freedom": lambda: gl.propagators(small[0]),
}
for work in WORKS.values():
    work()
pairs = {"crossing": crossing, "often": often, "clear": clear, "small": small, "quiet": quiet}
print({name: int(gl.march(*found[1:], 50).contacts.sum()) for name, found in pairs.items()}, flush=True)
for _ in sys.stdin:
    times = {}
    for name, work in WORKS.items():
        best = 1e9
        for _ in range(20):
            began = time.process_time()
            work()
            best = min(best, time.process_time() - began)
        times[name] = best
    print(json.dumps(times), flush=True)
"""


def started(source: Path) -> subprocess.Popen[str]:
    """A process that imports gearlash from this folder and waits to be asked for its times."""
    return subprocess.Popen(
        [sys.executable, "-c", PROGRAM],
        env={**os.environ, "PYTHONPATH": str(source)},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )


def asked(process: subprocess.Popen[str]) -> dict[str, float]:
    """Seconds of processor time for each work, done once."""
    assert process.stdin is not None
    assert process.stdout is not None
    process.stdin.write("\n")
    process.stdin.flush()
    return json.loads(process.stdout.readline())


def main(other: Path, repeats: int = 15) -> None:
    """Prints the least time of each work, there and here, and their ratio; the two take turns."""
    pair = [started(other), started(HERE)]
    for process in pair:
        assert process.stdout is not None
        print(process.stdout.readline().strip())
    turns = [[asked(process) for process in pair] for _ in range(repeats)]
    print(f"{'ms of the processor':<50}{'there':>9}{'here':>9}{'ratio':>7}")
    for name in turns[0][0]:
        there, here = (1e3 * min(turn[which][name] for turn in turns) for which in (0, 1))
        print(f"{name:<50}{there:>9.2f}{here:>9.2f}{here / there:>7.2f}")
    for process in pair:
        assert process.stdin is not None
        process.stdin.close()
        process.wait()


if __name__ == "__main__":
    main(Path(sys.argv[1]), *map(int, sys.argv[2:]))
