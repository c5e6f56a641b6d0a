"""One gear pair with its numbers."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.case.errors import Problem
from gearlash.case.scales import Scales
from gearlash.case.units import NUMBER, TORQUE, unit
from gearlash.system import Family

from . import drawn, play
from .carried import Completing, carried, least_play_added
from .checks import contradictions, missing
from .estimated import Completed, complete, is_drawn, is_estimable
from .excitation import Curves, Reconstructed, reconstructed
from .keys import REFERENCE
from .loaded import unloaded
from .numbers import numbers
from .phases import assumed_phases
from .places import Places
from .recomputed import Pair, recomputed
from .records import Numbers
from .rules import EntriesByKey, PairRules
from .units import to_physical


@dataclass(frozen=True)
class GearPair:
    """Stated values by key, the rules of their kind, curves by name, the paths of values that vary although
    they are no parameters of the model, and the stems of harmonics that are estimated beside stated ones."""

    rules: PairRules
    stated: EntriesByKey
    curves: Curves = field(default_factory=dict)
    varied: tuple[str, ...] = ()
    kept: tuple[str, ...] = ()

    def with_stated(self, stated: EntriesByKey) -> GearPair:
        """The pair with these stated values, of which none varies."""
        return replace(self, stated=stated, varied=())

    @cached_property
    def completed(self) -> Completed:
        """With what is estimated."""
        found = complete(self.rules, self.stated, self.curves, self.kept)
        phased = {**found.entries, **{e.key: e for e in assumed_phases(found.entries, self.curves)}}
        entries, problems = unloaded(self.rules, phased, self.curves, found.drawing)
        return replace(found, entries=entries, refused=tuple(problems))

    @property
    def entries(self) -> EntriesByKey:
        """Stated and estimated values by key."""
        return self.completed.entries

    @cached_property
    def ranged(self) -> EntriesByKey:
        """The same, estimates with ranges as wide as stated limits make them."""
        return carried(cast("Completing", self))

    @property
    def least_play_added(self) -> float:
        """What the backlash at work has more than the stated one at the tight end of stated limits, m."""
        return least_play_added(cast("Completing", self))

    def lacks(self, present: Collection[str] = ()) -> list[Problem]:
        """What is missing, and why nothing can be estimated; ``present`` are paths known to be stated, if
        wrongly."""
        found = missing(self.rules, self.entries, present)
        needing = self.completed.toothless
        if self.completed.problems or needing or is_drawn({*self.stated, *present}):
            nothing = "D" in self.stated  # of which half would be D_c
            found = [p for p in found if not is_estimable(p.path) or (p.path == REFERENCE and nothing)]
        refused = [p for p in self.completed.refused if not (p.missing and p.path in present)]
        told = needing if drawn.TEETH.isdisjoint(present) else ()  # those are at fault
        return [*self.completed.problems, *told, *refused, *found]

    def contradicted(self) -> list[Problem]:
        """What of a pair that lacks nothing contradicts what else it states."""
        return contradictions(self.rules, self.entries, self.curves)

    @cached_property
    def numbers(self) -> Numbers:
        """Parameters, fixed numbers, scales and body."""
        done = self.completed
        return numbers(self.rules, self.entries, done.drawing, self.curves, done.play_added)

    @property
    def places(self) -> Places:
        return self.rules.places

    @property
    def scales(self) -> Scales:
        return self.numbers.scales

    @property
    def reconstructed(self) -> dict[str, Reconstructed]:
        """Stated curves with the series that stand for them."""
        return reconstructed(self.curves, self.entries, self.scales, self.completed.drawing)

    def family(self) -> Family:
        """Its family of systems, made once."""
        return self._family

    @cached_property
    def _family(self) -> Family:
        """With estimates made again where a member of the family is not at the torque of the case, and where
        what they rest on varies."""
        own = self.rules.family(self.numbers)
        if not self.varied and not self.completed.follows_torque:
            return own
        # a cached property is no property to type checkers, but is one to whoever reads it
        return recomputed(cast("Pair", self), own)

    def physical(self, short: str, value: ArrayLike) -> list[tuple[str, NDArray[np.float64], str]]:
        """(path, values, unit) for every physical way to name a parameter with these values."""
        if not self.scales.physical:
            return []
        ways = [path for path in self.places.two_way.get(short, ()) if not path.startswith("dimensionless.")]
        ways += [path for path in self.varied if path == short]
        gap = self.entries.get("D")
        if play.act_on(self.entries) or (gap is not None and gap.path == play.AT_WORK):
            ways = [play.AT_WORK if path == play.STATED and short == "D" else path for path in ways]
        found = []
        for path in ways:
            place = self.places.quantities[path]
            if place.dimension != NUMBER and (place.dimension != TORQUE or self.scales.radii is not None):
                si = np.asarray(value) if path == short else to_physical(self.scales, path, value)
                found.append((path, np.asarray(si) * float(unit(place.unit).express(1.0)), place.unit))
        return found
