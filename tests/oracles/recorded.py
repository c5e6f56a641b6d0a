"""Keeps what the kernels compute, and compares: ``cd tests && python -m oracles.recorded FILE [SYSTEMS]``.

Where FILE is not there it is written; where it is, every number is compared with it, byte for byte. Run it
before and after a change that must not change a bit: another compiler, other decorators.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from gearlash import flow
from gearlash.flow._cells import spectral_radius
from gearlash.system import System

from .dense import random_dense
from .members import random_member
from .pairs import KINDS, random_system

PERIODS = 40


def systems(count: int) -> Iterator[tuple[str, System, np.ndarray]]:
    """Names, systems and starts: gear pairs of every kind, members of the whole class, dense linear ones."""
    for number in range(count):
        rng = np.random.default_rng([29, number])
        kind = number % 4
        if kind < 2:
            pair, which = ("spur", "helical")[kind], KINDS[number // 4 % len(KINDS)]
            yield f"{number} {pair} {which}", *random_system(rng, pair, which)
        elif kind == 2:
            size, clearances = 2 + number // 4 % 11, 1 + number // 8 % 3
            yield f"{number} member", *random_member(rng, size, clearances)
        else:
            yield f"{number} dense", *random_dense(rng, 2 + number // 4 % 9)


def numbers(system: System, start: np.ndarray) -> dict[str, np.ndarray]:
    """Everything that kernels return for one system, by name."""
    rng = np.random.default_rng(7)
    props = flow.propagators(system)
    one = flow.march(props, start, PERIODS)
    starts = np.array([start, *(start + rng.normal(scale=0.3, size=(10, len(start))))])
    many = flow.march_many(props, starts, PERIODS // 2, 2)
    span = 2.0 * system.cycles
    moved = flow.variational(props, start, span, 0.3)
    trace = flow.trace(props, start, span, 0.1)
    found = {
        "strobes": one.states,
        "contacts": one.contacts,
        "many": many.states,
        "many contacts": many.contacts,
        "state": moved.state,
        "jacobian": moved.jacobian if moved.jacobian is not None else np.empty(0),
        "pieces": trace.polynomials,
        "positions": trace.positions,
        "event phases": trace.events.phase,
        "event states": trace.events.state,
        "tables": props.tables.memory,
        "radius": np.array(spectral_radius(np.array(system.matrix), 8)),
        "status": np.array([str(one.status), str(moved.status), str(trace.status), *map(str, many.statuses)]),
    }
    for clearance in range(len(system.clearances)):
        extrema = trace.extrema_of(clearance)
        found[f"extrema {clearance}"] = np.array([extrema.phase, extrema.displacement, extrema.curvature])
    tangent = np.eye(len(start))[0]
    grown = flow.growth(props, start, tangent, 6, 2)
    found["growth"] = np.array([*grown.logarithms, *grown.tangent, *grown.states[-1]])
    return found


def main(file: Path, count: int = 200) -> int:
    """Writes or compares; returns how many arrays differ."""
    found = {
        f"{name}: {what}": np.frombuffer(value.tobytes(), dtype=np.uint8)
        for name, system, start in systems(count)
        for what, value in numbers(system, start).items()
    }
    if not file.exists():
        np.savez_compressed(file, **found)  # pyright: ignore[reportArgumentType]
        print(f"{len(found)} arrays written")
        return 0
    before = np.load(file)
    others = [name for name in found if name not in before or found[name].tobytes() != before[name].tobytes()]
    print(f"{len(found)} arrays, {len(others)} differ", *others[:40], sep="\n")
    return len(others)


if __name__ == "__main__":
    sys.exit(min(1, main(Path(sys.argv[1]), *map(int, sys.argv[2:]))))
