"""What a report of a gear pair can be made of, and the speeds it goes over."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import copysign, isclose, pi

from gearlash.case import Case, Value
from gearlash.system import GearlashError

from .axis import Axis

SPEED = "omega"
TORQUES = "operation.torque", "operation.gear_torque", "operation.power"
REACH = (0.5, 1.5)
"""Of the present speed: what is examined where nothing else is asked for."""


def check_pair(case: Case) -> None:
    """Raises `GearlashError` for a case that is no gear pair under load, or not excited."""
    if case.numbers is None or not case.between_teeth:
        raise GearlashError(
            f"{case.name} is of kind {case.kind}: a report is made of a gear pair (helical-pair, spur-1dof)"
        )
    family = case.family()[0]
    if not family.system().excited:
        words = case.excitation
        raise GearlashError(f"{case.name}: {words.cause}; {words.give}")
    load = family.defaults["load"]
    if load == 0.0:
        raise GearlashError(f"{case.name}: a report needs a torque that presses one side (load = 0)")
    if load < 0.0:
        _check_alike(case)


def carrying_forwards(case: Case) -> Case:
    """The pair as it is where the drive side carries. Where the back side does, its mirror image: X, errors
    and torque change their sign, and it moves alike.

    Raises `GearlashError` where both sides are not alike, or the case states curves.
    """
    values = case.family()[0].complete({})
    if values["load"] >= 0.0:
        return case
    _check_alike(case)
    phases = [f"error_phase{name.removeprefix('error')}" for name in values if _is_error(name)]
    found = case.with_overrides(dict(_turned(case)) | dict(_half_a_turn(case, values, phases)))
    turned = found.family()[0].complete({})
    same = found.scales == case.scales and all(
        isclose(turned[name], -value if name == "load" else value, rel_tol=1e-9, abs_tol=1e-12)
        for name, value in values.items()
        if name not in phases
    )
    if not same:  # never a report of another pair
        raise GearlashError(f"{case.name}: no mirror image of it could be made, which a report is made of")
    return found


def _is_error(name: str) -> bool:
    """Whether a parameter is the amplitude of a harmonic of the error."""
    return name == "error" or (name.startswith("error_") and name.removeprefix("error_").isdigit())


def _half_a_turn(
    case: Case, values: Mapping[str, float], phases: Sequence[str]
) -> Iterator[tuple[str, object]]:
    """Phases of the error half a turn away, with their limits and ranges: its amplitudes stay."""
    ranged = {value.short: value for value in case.values() if value.least is not None}
    for phase in phases:
        own = ranged.get(phase)
        if own is None:
            yield phase, values[phase] - copysign(pi, values[phase])
            continue
        half = 180.0 if own.unit == "deg" else pi
        yield own.path, _moved(own, 1.0, -copysign(half, float(own.value)))


def _turned(case: Case) -> Iterator[tuple[str, object]]:
    """Torque, power or load turned round under the name that states it, from which estimates at this torque
    follow."""
    stated = {entry.path for entry in case.entries.values()}
    for value in case.values():
        if value.path in stated.intersection({"dimensionless.load", *TORQUES}):
            ranged = value.least is not None
            yield value.path, _moved(value, -1.0, 0.0) if ranged else _text(-float(value.value), value)


def _moved(value: Value, factor: float, shift: float) -> dict[str, object]:
    """A value with its limits, each times a factor and moved, as a case states them."""
    assert value.least is not None
    assert value.greatest is not None
    ends = sorted((factor * value.least + shift, factor * value.greatest + shift))
    size = factor * float(value.value) + shift
    texts = [_text(number, value) for number in (size, *ends)]
    origin = {"provenance": str(value.provenance), "reason": value.reason}
    return {"value": texts[0], "range": texts[1:], **({} if value.provenance == "given" else origin)}


def _text(number: float, value: Value) -> float | str:
    """A number in the unit of a value, as a case states it."""
    return f"{number!r} {value.unit}" if value.unit else number


def _check_alike(case: Case) -> None:
    values = case.family()[0].complete({})
    said = f"{case.name}: the torque is negative, so that the back side carries; a report is then made of the"
    if values.get("back_stiffness", 1.0) != 1.0 or values.get("back_gap", 1.0) != 1.0:
        raise GearlashError(f"{said} mirror image, which needs both sides alike (back_stiffness, back_gap)")
    paths = {value.path for value in case.values()}
    if any(path.startswith(("curves.", "mesh.loaded_error")) or path.endswith(".runout") for path in paths):
        raise GearlashError(
            f"{said} mirror image, which is not made of curves, loaded errors and run-out (gearlash run, "
            "sweep, zones, map and graze take the case as it is)"
        )


def stated_speeds(case: Case) -> tuple[float, float] | None:
    """The range of speed ω that the case states; None where it states none."""
    for of_gear, ends in (
        (False, ("least_speed", "greatest_speed")),
        (True, ("least_gear_speed", "greatest_gear_speed")),
    ):
        stated = [case.entries.get(f"operation.{end}") for end in ends]
        if stated[0] is None or stated[1] is None:
            continue
        name = "gear_speed" if of_gear else "pinion_speed"
        low, high = (case.resolve(name, f"{end.number!r} rad/s")[1] for end in stated if end is not None)
        return low, high
    return None


def speeds_around(case: Case, count: int) -> Axis:
    """Speeds of the range that the case states; else from half the present one to half more, as far as the
    family goes."""
    stated = stated_speeds(case)
    if stated is not None:
        return Axis.even(SPEED, *stated, count)
    family = case.family()[0]
    here, place = family.defaults[SPEED], next(p for p in family.parameters if p.name == SPEED)
    return Axis.even(SPEED, max(REACH[0] * here, place.lower), min(REACH[1] * here, place.upper), count)
