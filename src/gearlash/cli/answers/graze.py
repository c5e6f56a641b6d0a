"""`gearlash graze`: where the attractor touches a boundary of the gap, solved for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case
from gearlash.results.contact_words import sided
from gearlash.results.followed import INTERRUPTED, FollowedPath
from gearlash.system import Family, Label, Signature, Status, System, label_text

from .asked import Asked
from .excitation import NOT_EXCITED, nothing_varies
from .outcome import INCOMPLETE, RESUME
from .parts import CaseUsed, Multiplier, PhysicalValue, case_used, multiplier_rows, physical_values
from .sentence import ASSUMED_MARK, physical_text

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.branches.continuation import SpecialPoint
    from gearlash.results import Point

HOLDS = 1e-9  # tolerance of the conditions, in units of D_c
JUMPS = (
    "H changes its sign within the error of this value, but is 0 on no orbit that was found: it jumps there. "
    "What is estimated anew for each value (stiffness under the torque) changes in small steps"
)


@dataclass(frozen=True)
class Condition:
    """One of the article's four conditions at the touch."""

    condition: str
    value: float
    holds: bool


@dataclass(frozen=True)
class TouchFound:
    """A grazing point."""

    value: Annotated[float, "of the parameter, dimensionless"]
    error: Annotated[float, "estimate of its error: the last step of Newton's method"]
    physical: tuple[PhysicalValue, ...]
    margin: Annotated[float, "from the value at the start to this one, dimensionless; negative below it"]
    margin_asked: Annotated[float, "the same in the unit that was asked for"]
    clearance: Annotated[str, "name of the gap"]
    side: Literal["drive", "back"]
    surface: Annotated[
        Literal["gap", "force"], "what is touched: a boundary of the gap, or with `no-tension` the force zero"
    ]
    kind: Annotated[str, "loss of contact or engagement"]
    type: Annotated[str, "as Table 2 of the article names it"]
    label_below: Annotated[Label, "P-Q-R of the orbit just below the value, none where it was not found"]
    label_above: Annotated[Label, "P-Q-R of the orbit just above the value, none where it was not found"]
    stable_below: Annotated[bool | None, "whether it is stable there"]
    stable_above: Annotated[bool | None, "whether it is stable there"]
    period: Annotated[int, "of the orbit, in mesh cycles"]
    phase: Annotated[float, "of the touch, in mesh cycles"]
    a0: Annotated[float, "X″ at the touch; Φ″ where the surface is the force"]
    state: Annotated[dict[str, float], "at the touch"]
    conditions: tuple[Condition, ...]
    multipliers: Annotated[tuple[Multiplier, ...], "of the touching orbit, by modulus, descending"]
    largest_exponent: Annotated[float, "of the touching orbit, per unit of τ"]
    to_doubling: Annotated[float, "least |λ + 1|"]
    to_fold: Annotated[float, "least |λ - 1|"]
    residual: Annotated[float, "of all equations"]
    note: Annotated[str, "what keeps the first condition from holding"] = ""


@dataclass(frozen=True)
class GrazeAnswer:
    """Grazing points next to an attractor (gearlash graze)."""

    sentence: str
    status: Annotated[
        str,
        "ok, not-found, not-excited, incomplete if it was stopped, or why the attractor could not be "
        "followed",
    ]
    message: str
    advice: str
    case: CaseUsed
    parameters: Annotated[
        dict[str, float], "every parameter by short name, with the value that the search started at"
    ]
    over: Annotated[str, "short name of the parameter that is solved for"]
    near: Annotated[float, "its value at the start"]
    asked: Annotated[Asked, "the unit that the sentence tells values in"]
    label: Annotated[str, "of the attractor there"]
    points: Annotated[
        tuple[TouchFound, ...], "the first that this motion meets below and above, nearest first"
    ]
    paths: Annotated[tuple[FollowedPath, ...], "how the motion was followed, downwards and upwards"]
    held: Annotated[str, "what is taken to be the same all along it, although it may not be"] = ""
    result: Literal["graze"] = "graze"


def graze_answer(
    case: Case,
    family: Family,
    parameters: Mapping[str, float],
    over: str,
    named: str,
    unit: str,
    start: Point,
    paths: tuple[FollowedPath, ...],
    found: list[SpecialPoint],
) -> GrazeAnswer:
    """The record of what was found on the paths from ``start``; ``named`` is the parameter as typed, ``unit``
    what its value was typed in."""
    near = parameters[over]
    asked = Asked.of(case, over, named, unit)
    nearest = sorted(found, key=lambda point: abs(point.value - near))
    touches = tuple(_touch(case, family, point, near, asked) for point in nearest)
    what = start.status if start.label is None else start.label
    here = f"{asked.text(near, 10 if not asked.unit else 6)}, {what}"
    status, advice = _outcome(start, bool(touches))
    if any(INTERRUPTED in (path.ended, path.beyond) for path in paths):
        status, advice = INCOMPLETE, RESUME
    said = _sentence(over, asked, near, touches, paths, _several(family, parameters), case.between_teeth)
    if not touches and not family.system(parameters).excited:
        idle = nothing_varies(case)
        said, status, advice = f"{idle.cause}; {idle.advice}", NOT_EXCITED, idle.advice
    return GrazeAnswer(
        sentence=f"{here}: {said}",
        status=status,
        message=_message(start, paths),
        advice=advice,
        case=case_used(case),
        parameters=dict(parameters),
        over=over,
        near=near,
        asked=asked,
        label=label_text(start.label),
        points=touches,
        paths=paths,
        held=case.held(over),
    )


def _touch(case: Case, family: Family, point: SpecialPoint, near: float, asked: Asked) -> TouchFound:
    from gearlash.article import table2_type

    touch, system = point.touch, family.system(point.values)
    rising = point.point.turn >= 0.0
    stable = (True, point.unstable_after == 0)[:: 1 if rising else -1]
    conditions = _conditions(system, point)
    return TouchFound(
        value=point.value,
        error=point.error,
        physical=physical_values(case, point.name, point.value, back_side_met=_meets_back(point)),
        margin=point.value - near,
        margin_asked=asked.value(point.value) - asked.value(near),
        clearance=system.clearances[touch.clearance].name,
        side="drive" if touch.boundary > 0 else "back",
        surface="gap" if touch.surface == "gap" else "force",
        kind=point.touch_kind,
        type=table2_type(point),
        label_below=point.label_below,
        label_above=point.label_above,
        stable_below=stable[0],
        stable_above=stable[1],
        period=point.period,
        phase=touch.phase,
        a0=touch.a0,
        state=dict(zip(family.states, map(float, point.state_at_touch(system)), strict=True)),
        conditions=conditions,
        multipliers=multiplier_rows(point.multipliers),
        largest_exponent=point.exponent(system),
        to_doubling=point.to_doubling,
        to_fold=point.to_fold,
        residual=point.residual,
        note="" if conditions[0].holds else JUMPS,
    )


def _meets_back(point: SpecialPoint) -> bool:
    sides = point.label_below, point.label_above
    return point.touch.boundary < 0 or any(
        isinstance(one, Signature) and one.back_impacts > 0 for one in sides
    )


def _conditions(system: System, point: SpecialPoint) -> tuple[Condition, ...]:
    """The four conditions in words."""
    found = point.conditions(system)
    values = (found.distance, found.gradient, found.velocity, found.a0)
    return tuple(map(Condition, _worded(point), values, found.met(HOLDS)))


def _worded(point: SpecialPoint) -> tuple[str, str, str, str]:
    if point.touch.surface == "force":
        return "H = Φ = 0", "|∂H/∂z| ≠ 0", "Φ′ = 0 (its residual)", "a0 = Φ″ ≠ 0"
    sign = "X − D" if point.touch.boundary > 0 else "X + D⁻"
    return f"H = {sign} = 0", "|∂H/∂X| ≠ 0", "X′ = 0", f"a0 = X″ {_curvature(point)}"


def _curvature(point: SpecialPoint) -> str:
    """Its sign, and where the touch is seen from if that is not S1."""
    above = point.touch.a0 > 0.0
    if point.touch.boundary > 0:
        return "> 0" if above else "< 0 (seen from S2)"
    return "> 0 (at Σ2, seen from S2)" if above else "< 0 (at Σ2)"


def _sentence(
    over: str,
    asked: Asked,
    near: float,
    touches: tuple[TouchFound, ...],
    paths: tuple[FollowedPath, ...],
    several: bool,
    teeth: bool,
) -> str:
    """What was found, along this motion; the nearest is called so only if the other way was followed as
    far."""
    if not paths:
        return "no grazing was found, as none was looked for"
    if not touches:
        low, high = (path.reached for path in paths)
        stopped = [path.direction for path in paths if path.ended == INTERRUPTED]
        lost = [path.direction for path in paths if not path.decided and path.direction not in stopped]
        ends = [("interrupted", stopped), ("lost", lost)]
        said = [f"{end} there on the way {' and '.join(ways)}" for end, ways in ends if ways]
        text = f"no grazing of this motion was found {asked.reach(low, high, 7)}"
        return text + (f" ({', '.join(said)})" if said else "")
    first = touches[0]
    value = _value(over, asked, first)
    what = sided(first.kind.partition(" (")[0], teeth) + (f" of {first.clearance}" if several else "")
    below, above = (
        _side(first.label_below, first.stable_below),
        _side(first.label_above, first.stable_above),
    )
    text = f"{what} at {value}, {below} below and {above} above"
    for path in paths:
        if not path.decided and abs(path.reached - near) < abs(first.value - near):
            way = {"down": "below", "up": "above"}[path.direction]
            far = asked.text(path.reached, 7)
            text += f"; whether one lies nearer {way} is not known, followed to {far} there"
            return f"a grazing of this motion is {text}"
    return f"nearest grazing found along this motion is {text}"


def _side(label: Label, stable: bool | None) -> str:
    """The orbit on one side of a touch."""
    if stable is None:
        return "no orbit found"
    return str(label) if stable else f"{label} (unstable)"


def _several(family: Family, parameters: Mapping[str, float]) -> bool:
    return len(family.system(parameters).clearances) > 1


def _value(over: str, asked: Asked, touch: TouchFound) -> str:
    """A value found, first in the unit that was asked for; without one beside the first that the case has."""
    plain = f"{over} = {touch.value:.10g}"
    if not asked.unit:
        return f"{plain} ({physical_text(touch.physical[0], 6)})" if touch.physical else plain
    mark = f" {ASSUMED_MARK}" if any(p.rests_on for p in touch.physical if p.name == asked.name) else ""
    return f"{asked.text(touch.value, 8)}{mark} ({plain})"


def _outcome(start: Point, found: bool) -> tuple[str, str]:
    """Status and advice: those of the attractor where it could not be followed."""
    if found:
        return str(Status.OK), Status.OK.advice
    if start.periodic:  # followed in vain
        return str(Status.NOT_FOUND), "start from another value (--near), or another motion (--initial)"
    if start.status is Status.OK:  # aperiodic
        return str(Status.NOT_FOUND), (
            "start where the motion is periodic (--near), or from a state on a periodic motion (--initial)"
        )
    return str(start.status), start.status.advice


def _message(start: Point, paths: tuple[FollowedPath, ...]) -> str:
    if start.periodic:
        return "; ".join(f"{path.direction} to {path.reached:.6g}: {path.ended}" for path in paths)
    return f"{start.message}; only a periodic motion can be followed to a grazing"
