"""From a pixel of the map to its neighbour: the stable motion of one is followed to where the other lies.

What it meets on the way is solved for there. Where it arrives it coexists with what the other pixel shows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gearlash import flow
from gearlash.branches.continuation import EndKind, EndOfBranch, Node, SpecialPoint, walk
from gearlash.jobs import Part, stopping
from gearlash.orbits import Orbit, Settings, Verdict, attractor
from gearlash.studies.model import Source
from gearlash.system import GearlashError, Signature

MOST_ORBITS = 400  # of one walk


@dataclass(frozen=True, eq=False)
class Between:
    """A task: from the ``values`` of one pixel, whose motion is followed in ``name``, to the value ``to``."""

    source: Source
    values: tuple[tuple[str, float], ...]
    name: str
    to: float
    start: tuple[float, ...] | None
    settings: Settings
    longest: int


@dataclass(frozen=True, eq=False)
class Walked:
    """``specials`` in order; ``arrived``: the label of the motion with which it arrives, certified, or None;
    ``certified``: whether the motion it began with is; ``why``: why it ends before, or was not begun."""

    specials: tuple[SpecialPoint, ...] = ()
    arrived: Signature | None = None
    certified: bool = False
    why: str = ""


def walk_between(task: Between, carry: object) -> Part:
    """The walk of a task."""
    family, values = task.source.family(), dict(task.values)
    try:
        values = family.complete(values)
        props = flow.propagators(family.system(values))
        start = family.start(values) if task.start is None else task.start
        found = attractor(props, np.array(start), task.settings)
        if not isinstance(found, Orbit):
            return Part((Walked(why=f"its motion is {found.label}"),))
        if found.signature.period > task.longest:
            return Part((Walked(why=f"its period of {found.signature.period} is longer than is followed"),))
        return Part((_walked(task, values, found),))
    except (GearlashError, np.linalg.LinAlgError) as error:
        return Part((Walked(why=str(error)),))


def _walked(task: Between, values: Mapping[str, float], orbit: Orbit) -> Walked:
    specials: list[SpecialPoint] = []
    last, certified = orbit, orbit.certificate.verdict is Verdict.CERTIFIED
    items = walk(task.source.family(), values, task.name, orbit, task.to, longest=task.longest)
    for count, item in enumerate(items):
        if isinstance(item, SpecialPoint):
            specials.append(item)
        elif isinstance(item, Node):
            last = item.orbit
        elif isinstance(item, EndOfBranch):
            if item.kind is not EndKind.ARRIVED:
                return Walked(tuple(specials), None, certified, item.note or str(item.kind))
            there = last.certificate.verdict is Verdict.CERTIFIED
            arrived = last.signature if there else None
            return Walked(tuple(specials), arrived, certified, "" if there else "not certified there")
        if count > MOST_ORBITS or stopping():
            break
    return Walked(tuple(specials), None, certified, f"not there after {MOST_ORBITS} orbits")
