"""From the arcs of branches, and motion that has none, to zones."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from gearlash.orbits.contraction import contracts
from gearlash.results import Axis, Sweep
from gearlash.results.physical import physical_axis
from gearlash.system import GearlashError, Label

from .arcs import Arc
from .assured import assured
from .chased import chased
from .followed import MEET, Followed
from .intervals import union, without
from .model import Model
from .seen import Onsets, Stretch, stretches
from .zone import Physical, Zone, ZoneMotion, Zones
from .zone_end import Interval, Quiet, ZoneEnd

FOLLOWED = "along its branch"  # how a motion was found that no start led to


@dataclass(frozen=True, eq=False)
class Found:
    """All that was found along an axis; ``starts``: from how many starts; ``assure``: whether what lies
    between computed orbits is looked at."""

    model: Model
    axis: Axis
    sweeps: tuple[Sweep, ...]
    followed: Followed
    onsets: Onsets
    starts: int
    assure: bool = True
    sure: dict[tuple[int, float, float], tuple[float, float] | None] = field(default_factory=dict)

    @property
    def near(self) -> float:
        return MEET * self.followed.question.width

    @cached_property
    def seen(self) -> list[Stretch]:
        return stretches(self.sweeps, self.followed)

    @cached_property
    def chased(self) -> list[ZoneMotion]:
        return chased(self.followed, self.seen)

    @cached_property
    def exists(self) -> list[Interval]:
        """Of every branch, where it exists."""
        rows = [
            [arc for arc in self.followed.arcs if arc.branch == i] for i in range(len(self.followed.branches))
        ]
        return [
            Interval(
                min((arc.lower for arc in row), key=lambda end: end.value),
                max((arc.upper for arc in row), key=lambda end: end.value),
            )
            for row in rows
        ]

    def zones(self, quiet: Quiet) -> Zones:
        """Zones of one kind."""
        arcs = self.followed.stable
        calm = [arc for arc in arcs if quiet.holds_signature(arc.label)]
        noisy = [arc for arc in arcs if not quiet.holds_signature(arc.label)]
        wide = [self.told(one) for one in union([calm], self.near) if one.width > self.near]
        certain = wide
        for arc in noisy:
            taken = self.told(Interval(arc.lower, arc.upper))
            certain = without(certain, taken, self.from_outside(arc.label, calm), self.near)
        certain = self.without_seen(quiet, certain, calm) if self.all_followed else []
        every = [self.zone(quiet, one, True) for one in certain]
        some = [
            self.zone(quiet, one, False) for one in wide if not any(self.same(one, sure) for sure in certain)
        ]
        reason = self.followed.reason
        return Zones(
            quiet, self.axis, tuple(every), tuple(some), self.sweeps, not reason, reason, self.axis.step,
            self.step(certain), tuple(self.followed.branches), self.starts, self.followed.not_followed,
            self.followed.work.left_out,
        )  # fmt: skip

    @property
    def all_followed(self) -> bool:
        """Whether every motion that was found was followed: where that was stopped nothing holds for all."""
        return not self.followed.reason

    def without_seen(self, quiet: Quiet, certain: list[Interval], calm: Sequence[Arc]) -> list[Interval]:
        """What is left where motion without a branch was seen. Its ends are asked for where they matter."""
        for stretch in self.seen:
            low, high = self.onsets.cell(stretch, -1)[0], self.onsets.cell(stretch, 1)[1]
            if not any(one.lower.value <= high and low <= one.upper.value for one in certain):
                continue
            lower, upper = self.onsets.of([(stretch, -1), (stretch, 1)])
            outside = self.from_outside(stretch.label, calm)
            certain = without(certain, Interval(lower, upper), outside, self.near)
        for motion in self.chased:
            if motion.stable is None or quiet.holds_label(motion.label):
                continue
            certain = without(certain, motion.stable, self.from_outside(motion.label, calm), self.near)
        return certain

    def from_outside(self, label: Label | None, calm: Sequence[Arc]) -> Callable[[ZoneEnd], ZoneEnd]:
        """The ends of what is not quiet, as those of what is."""

        def opposite(end: ZoneEnd) -> ZoneEnd:
            inside = next((arc.label for arc in calm if arc.contains(end.value)), end.outside)
            return replace(end, inside=inside, outside=label, reason=end.reason if label is None else "")

        return opposite

    def told(self, one: Interval) -> Interval:
        """With what motion goes on as beyond its ends, and how its own was found."""
        return Interval(self.told_end(one.lower, False), self.told_end(one.upper, True))

    def told_end(self, end: ZoneEnd, up: bool) -> ZoneEnd:
        owners = [
            (i, arc)
            for i, arc in enumerate(self.followed.arcs)
            if arc.stable and (arc.upper if up else arc.lower) is end
        ]
        if not owners:
            return end
        (number, arc) = owners[0]
        end = replace(end, direction=", ".join(self.ways(arc)))
        beyond = self.followed.beyond.get((number, up))
        if end.outside is None and beyond is not None:
            reason = str(beyond.status) if beyond.label is None else ""
            end = replace(end, outside=beyond.label, reason=reason)
        return end

    def ways(self, arc: Arc) -> tuple[str, ...]:
        """How the motion of an arc was found."""
        found = self.followed.ways.get(id(arc), set())
        sweeps = dict.fromkeys(way for sweep in self.sweeps if (way := sweep.way) in found)
        return tuple(sweeps or sorted(found)) or (FOLLOWED,)

    def same(self, one: Interval, other: Interval) -> bool:
        pairs = ((one.lower, other.lower), (one.upper, other.upper))
        return all(abs(a.value - b.value) <= a.uncertainty + b.uncertainty + self.near for a, b in pairs)

    def step(self, certain: Sequence[Interval]) -> float:
        """The widest step between neighbouring orbits inside the zones."""
        widest = 0.0
        for one in certain:
            for arc, low, high in self.inside(one):
                inner = arc.values[(arc.values > low) & (arc.values < high)]
                widest = max(widest, float(np.diff([low, *inner, high]).max()))
        return widest

    def zone(self, quiet: Quiet, one: Interval, every: bool) -> Zone:
        name = self.axis.name
        ends = Axis(name, np.unique([one.lower.value, one.upper.value]))
        physical = tuple(
            Physical(n, float(v[0]), float(v[-1]), unit) for n, v, unit in physical_axis(self.model, ends)
        )
        motions = sorted(self.motions(quiet, one, every), key=lambda t: (t.lower, t.upper, str(t.label)))
        unique = every and self.unique(one)
        return Zone(one.lower, one.upper, name, quiet, every, tuple(motions), physical, unique)

    def unique(self, one: Interval) -> bool:
        """Whether the contraction test holds at all values of the axis inside, and at both ends."""
        question, values = self.followed.question, self.axis.values
        family = question.source.family()
        low, high = one.lower.value, one.upper.value
        inside = values[(values > low) & (values < high)].tolist()
        try:
            return all(contracts(family.system(question.values(family, v))) for v in (low, high, *inside))
        except GearlashError:  # an end beyond which no system can be built
            return False

    def inside(self, one: Interval) -> Iterator[tuple[Arc, float, float]]:
        """Stable arcs in an interval, and between which values they lie in it."""
        for arc in self.followed.stable:
            low, high = max(arc.lower.value, one.lower.value), min(arc.upper.value, one.upper.value)
            if high - low > self.near:
                yield arc, low, high

    def assured(self, calm: Sequence[tuple[Arc, float, float]]) -> dict[int, tuple[float, float]]:
        """Between which values a stable orbit is assured on each arc, by its number: computed once where
        zones of several kinds hold the same part of it, and not where nobody asks."""
        if not self.assure:
            return {}
        of = {(self.followed.arcs.index(arc), low, high): (arc, low, high) for arc, low, high in calm}
        new = {key: each for key, each in of.items() if key not in self.sure}
        found = assured(self.followed, new.values())
        self.sure.update({key: found.get(key[0]) for key in new})
        return {key[0]: part for key in of if (part := self.sure[key]) is not None}

    def motions(self, quiet: Quiet, one: Interval, every: bool) -> Iterator[ZoneMotion]:
        """All that were found in an interval."""
        inside = list(self.inside(one))
        calm = [each for each in inside if quiet.holds_signature(each[0].label)]
        sure = self.assured(calm) if every else {}
        for arc, _, _ in inside:
            yield ZoneMotion(
                arc.label, self.ways(arc), arc.lower.value, arc.upper.value,
                quiet.holds_signature(arc.label), self.told(Interval(arc.lower, arc.upper)),
                self.exists[arc.branch], arc.branch, sure.get(self.followed.arcs.index(arc)),
            )  # fmt: skip
        for motion in self.chased:
            if min(motion.upper, one.upper.value) - max(motion.lower, one.lower.value) > self.near:
                yield replace(motion, quiet=quiet.holds_label(motion.label))
        for stretch in self.seen:
            known = stretch.label is not None and not stretch.missing
            if known and max(stretch.lower, one.lower.value) <= min(stretch.upper, one.upper.value):
                holds = all(quiet.holds(point) for point in stretch.points)
                assert stretch.label is not None
                yield ZoneMotion(stretch.label, (stretch.sweep.way,), stretch.lower, stretch.upper, holds)
