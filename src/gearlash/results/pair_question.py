"""What a report of a gear pair can be made of, and the speeds it goes over."""

from __future__ import annotations

from gearlash.case import Case
from gearlash.system import GearlashError

from .axis import Axis

SPEED = "omega"
REACH = (0.5, 1.5)
"""Of the present speed: what is examined where nothing else is asked for."""
VALUES = 61
"""Speeds of the sweeps that bands are found from; ends of bands are solved for."""


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
    if not load > 0.0:
        raise GearlashError(
            f"{case.name}: a report needs a torque that presses the drive side (load = {load:g}); "
            "turn the pair round where the back side carries"
        )


def speeds_around(case: Case, count: int) -> Axis:
    """Speeds from half the present one to half more, as far as the family goes."""
    family = case.family()[0]
    here, place = family.defaults[SPEED], next(p for p in family.parameters if p.name == SPEED)
    return Axis.even(SPEED, max(REACH[0] * here, place.lower), min(REACH[1] * here, place.upper), count)
