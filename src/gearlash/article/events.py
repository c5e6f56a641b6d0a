"""The article's events: the nearest special point with the same labels, or what is there instead."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gearlash import Branch, GrazingLaw, SpecialPoint, grazing_law
from gearlash.flow import propagators
from gearlash.orbits import Orbit, attractor, orbit_at
from gearlash.plots.regimes import short
from gearlash.results import Direction
from gearlash.studies.motion import Motion, motion, touching
from gearlash.system import Family, GearlashError, Label

from .claims import Claim
from .judge import FAR, NOT_FOUND, coincides, deviation, same_label, verdict, worst
from .kinds import table2_type
from .opening import Beside
from .reproduction import NAN, Coincidence, Event, Explained
from .rows import STUDY_SETTINGS

PICTURED = 0.008  # relative distance of the motions before and after; halved until the labels agree
NOT_ON_A_BRANCH = "Solved for along the sweeps; none of the followed branches has it."
SAME = 1e-12  # relative distance of the values of one touch
ZERO = 1e-3  # |λ ± 1|, |X ∓ D| and |X'| below which a condition counts as met


def match(claim: Claim, found: Sequence[Explained]) -> Explained | None:
    """The grazing with the claim's boundary and labels, met along the sweeps, that lies nearest to its value,
    within 10 %."""
    near = [each for each in found if _fits(claim, each)]
    return min(near, key=lambda each: abs(each.point.value - _value(claim)), default=None)


def _value(claim: Claim) -> float:
    assert claim.value is not None
    return claim.value


def _fits(claim: Claim, event: Explained) -> bool:
    if not event.point.is_grazing or event.point.touch.boundary != claim.boundary:
        return False
    close = abs(deviation(event.point.value, _value(claim))) <= FAR
    return close and _labelled(claim, (event.before, event.after))


def _labelled(claim: Claim, labels: tuple[Label | None, Label | None]) -> bool:
    orders = [labels, labels[::-1]] if claim.either_order else [labels]
    return any(same_label(a, claim.below) and same_label(b, claim.above) for a, b in orders)


def match_coincidence(claim: Claim, found: Sequence[Beside]) -> Beside | None:
    """The doubling with a grazing beside it, of the claim's boundary and labels, that lies nearest to its
    value, within 10 %."""
    near = [
        pair
        for pair in found
        if pair[0].grazing.touch.boundary == claim.boundary
        and _labelled(claim, pair[0].labels)
        and abs(deviation(pair[0].doubling.value, _value(claim))) <= FAR
    ]
    return min(near, key=lambda pair: abs(pair[0].doubling.value - _value(claim)), default=None)


@dataclass(frozen=True, eq=False)
class EventSearch:
    """Finds a claim's event among what the sweeps located, and computes the motions around it.

    ``values`` are those of the family with what the claim fixes; ``found`` the changes along the axis, as
    special points of ``branches``, ``coincidences`` the doublings on it with a grazing beside them."""

    family: Family
    values: dict[str, float]
    found: Sequence[Explained]
    coincidences: Sequence[Beside] = ()
    branches: Sequence[Branch] = ()

    def event(self, claim: Claim) -> Event:
        """The claim's event, found or not."""
        if claim.kind == "codimension-2":
            beside = match_coincidence(claim, self.coincidences)
            return self.coincident(claim, *beside) if beside is not None else self.missing(claim)
        event = match(claim, self.found)
        return self.solved(claim, event) if event is not None else self.missing(claim)

    def solved(self, claim: Claim, event: Explained) -> Event:
        point, directions = event.point, tuple(map(Direction, event.directions))
        apart = deviation(point.value, _value(claim))
        before, after = (self.beside(claim, point, side) for side in (-1, 1))
        at = touching(self.family, point)
        return Event(
            **_reported(claim),
            found=True,
            value=point.value,
            deviation=apart,
            label_below=event.before,
            label_above=event.after,
            kind=point.touch_kind,
            boundary=point.touch.boundary,
            a0=point.touch.a0,
            phase=point.touch.phase,
            type=table2_type(point),
            leading_below=before.leading,
            leading_above=after.leading,
            exponent=point.exponent(self.family.system(point.values)),
            distance_to_fold=point.to_fold,
            distance_to_doubling=point.to_doubling,
            conditions=_conditions(self.family, point),
            residual=point.residual,
            method="a special point of a followed branch, solved for together with its orbit"
            if event.special is not None
            else "solved for together with its orbit along the sweeps",
            branch=_branch(directions),
            verdict=verdict([apart], labels_equal=True),
            note="" if event.special is not None else NOT_ON_A_BRANCH,
            motions=(before, at, after),
            everywhere=len(directions) == len(Direction),
            law=self.law(point),
        )

    def coincident(self, claim: Claim, both: Coincidence, directions: tuple[Direction, ...]) -> Event:
        """A doubling and a grazing beside it. Value and exponent are those of the doubling, the conditions
        those of the touch."""
        point, graze = both.doubling, both.grazing
        apart = deviation(point.value, _value(claim))
        at = touching(self.family, graze)
        near = [each.point.state for each in sorted((graze, point), key=lambda each: each.value)]
        values = sorted((graze.value, point.value))
        before, after = (
            self.settled(claim.parameter, values[i], side, near[i], both.labels[i])
            for i, side in ((0, -1), (1, 1))
        )
        return Event(
            **_reported(claim),
            found=True,
            value=point.value,
            deviation=apart,
            label_below=both.labels[0],
            label_above=both.labels[1],
            kind=graze.touch_kind,
            boundary=graze.touch.boundary,
            a0=graze.touch.a0,
            phase=graze.touch.phase,
            type=f"{point.kind}, and {table2_type(graze)} {both.apart:.1e} beside it",
            leading_below=before.leading,
            leading_above=after.leading,
            exponent=point.exponent(self.family.system(point.values)),
            distance_to_fold=point.to_fold,
            distance_to_doubling=point.to_doubling,
            conditions=(
                (
                    "least |λ + 1| of the orbit at the doubling",
                    point.to_doubling,
                    point.to_doubling <= ZERO,
                ),
                *_conditions(self.family, graze),
            ),
            residual=max(point.residual, graze.residual),
            method="both are special points of followed branches, each solved for together with its orbit: "
            "the doubling of the single orbit, and the first touch on the branch that begins there",
            branch=_branch(directions),
            verdict=worst(
                [verdict([apart], labels_equal=True), coincides(both.apart, point.value, claim.printed)]
            ),
            note="",
            motions=(before, at, after),
            coincidence=both,
            everywhere=len(directions) == len(Direction),
            law=self.law(graze),
        )

    def law(self, special: SpecialPoint) -> GrazingLaw | None:
        """Of a touch that one of the branches has; none for one from the gap under `no-tension`."""
        found = (
            (branch, each)
            for branch in self.branches
            for each in branch.special
            if each.kind is special.kind and each.period == special.period
            if abs(each.value - special.value) <= SAME * abs(special.value)
        )
        branch, touch = next(found, (None, special))
        try:
            return None if branch is None else grazing_law(self.family, branch, touch)
        except GearlashError:
            return None

    def settled(self, name: str, value: float, side: int, state: np.ndarray, wanted: Label) -> Motion:
        """The attractor at a distance at which it has the label of that side, from a state beside it."""
        distance = PICTURED
        for _ in range(14):
            place = value * (1.0 + side * distance)
            found = attractor(self.family.system({**self.values, name: place}), state, STUDY_SETTINGS)
            if found.label == wanted:
                return motion(found, value=place)
            distance /= 2.0
        raise GearlashError(f"no motion {wanted} beside {name} = {value}")

    def beside(self, claim: Claim, point: SpecialPoint, side: int) -> Motion:
        """The orbit at a distance from the grazing at which it still has the label of that side."""
        wanted = point.label_below if side < 0 else point.label_above
        distance = PICTURED
        for _ in range(14):
            value = point.value * (1.0 + side * distance)
            orbit = self.orbit_at(claim.parameter, value, point.point.state, point.period)
            if orbit is not None and orbit.label == wanted and orbit.stable:
                break
            distance /= 2.0
        else:
            raise GearlashError(f"no orbit {wanted} beside {claim.parameter} = {point.value}")
        return motion(orbit, value=value)

    def orbit_at(self, name: str, value: float, state, period: int) -> Orbit | None:
        props = propagators(self.family.system({**self.values, name: value}))
        found = orbit_at(props, state, max(1, period // props.system.cycles))
        return found if found is not None and found.status.ok else None

    def missing(self, claim: Claim) -> Event:
        """The motions at and beside the reported value, and the nearest computed events."""
        step = 0.01 * _value(claim)
        motions = tuple(self.cold(claim.parameter, _value(claim) + d) for d in (-step, 0.0, step))
        return Event(
            **_reported(claim),
            found=False,
            value=NAN,
            deviation=NAN,
            label_below=motions[0].label,
            label_above=motions[2].label,
            kind="",
            boundary=claim.boundary,
            a0=NAN,
            phase=NAN,
            type="",
            leading_below=complex(NAN, NAN),
            leading_above=complex(NAN, NAN),
            exponent=NAN,
            distance_to_fold=NAN,
            distance_to_doubling=NAN,
            conditions=(),
            residual=NAN,
            method="searched among all transitions located along the up, down and cold sweeps",
            branch="up, down and cold sweeps; pictures: cold start, at and 1 % beside the reported value",
            verdict=NOT_FOUND,
            note=instead(claim, self.found) + _beside(claim, self.coincidences),
            motions=motions,
        )

    def cold(self, name: str, value: float) -> Motion:
        values = {**self.values, name: value}
        found = attractor(self.family.system(values), self.family.start(values), STUDY_SETTINGS)
        return motion(found, value=value)


def _reported(claim: Claim) -> dict:
    return {
        "name": f"{claim.parameter}-{claim.printed}",
        "title": claim.title,
        "claim": claim.id,
        "parameter": claim.parameter,
        "fixed": dict(claim.fixed),
        "reported": _value(claim),
        "digits": claim.printed,
        "reported_before": claim.below,
        "reported_after": claim.above,
    }


def _conditions(family: Family, point: SpecialPoint) -> tuple[tuple[str, float, bool], ...]:
    """The article's four conditions with their values at the computed point."""
    found = point.conditions(family.system(point.values))
    meets, smooth, turns, _ = found.met()
    return (
        ("H(X*) = X ∓ D = 0: the orbit meets the boundary", found.distance, meets),
        ("|∂H/∂X| ≠ 0: the boundary is smooth", found.gradient, smooth),
        ("∂H/∂X · F = X′ = 0: no normal velocity", found.velocity, turns),
        ("a0 = X″ ≠ 0; its sign names the side", found.a0, abs(found.a0) > ZERO),
    )


def _branch(directions: tuple[Direction, ...]) -> str:
    words = {
        Direction.UP: "up sweep (follows the attractor, rising)",
        Direction.DOWN: "down sweep (follows the attractor, falling)",
        Direction.COLD: "cold start at every value",
    }
    if len(directions) == len(words):
        return "met in all three sweeps: cold, up, down"
    return "met in: " + "; ".join(words[d] for d in directions)


def instead(claim: Claim, found: Sequence[Explained]) -> str:
    """What was located instead: the nearest transitions that touch either reported label."""
    labels = [text for text in (claim.below, claim.above) if text]
    related = [
        each for each in found
        if any(same_label(side, text) for side in (each.before, each.after) for text in labels)
    ]  # fmt: skip
    if not related:
        return f"No motion {' or '.join(labels)} changes into another one anywhere in the sweeps."
    related.sort(key=lambda each: abs(each.value - _value(claim)))
    parts = [describe(each) for each in related[:3]]
    text = "Nearest located changes of the reported motions: " + "; ".join(parts) + "."
    return text


def _beside(claim: Claim, coincidences: Sequence[Beside]) -> str:
    """For a coincidence that was not found: the closest pair of a doubling and a touch of what it bears."""
    if claim.kind != "codimension-2" or not coincidences:
        return ""
    both, _ = min(coincidences, key=lambda pair: pair[0].apart)
    name, (below, above) = {"omega": "ω"}.get(claim.parameter, claim.parameter), both.labels
    return (
        f" The closest pair of a doubling and a grazing of what it bears: {name} = {both.doubling.value:.6f} "
        f"and {both.grazing.value:.6f}, {both.apart:.1e} apart ({short(below)} → {short(above)})."
    )


def describe(event: Explained) -> str:
    """One change in words."""
    symbol = {"omega": "ω"}.get(event.point.name, event.point.name)
    return f"{event.kind} at {symbol} = {event.value:.6f} ({short(event.before)} → {short(event.after)})"
