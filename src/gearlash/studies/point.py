"""One attractor, and what is kept of it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.linalg import LinAlgError
from numpy.typing import ArrayLike

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.flow.events import gap_displacement
from gearlash.orbits import Attractor, Orbit, Settings, attractor
from gearlash.orbits.force_figures import force_figures
from gearlash.results import Point, blank
from gearlash.system import Family, GearlashError, Status, given, plain_values, short_name

from .arguments import checked_settings
from .model import Model, Source

TRACEABLE = (Status.OK, Status.UNCERTAIN, Status.UNRESOLVED, Status.NEUTRAL)
NOT_A_NUMBER = float("nan")


def point(
    model: Model,
    values: Mapping[str, float | str] | None = None,
    *,
    name: str | None = None,
    start: ArrayLike | None = None,
    trial: tuple[ArrayLike, int] | None = None,
    settings: Settings | None = None,
) -> Point:
    """The attractor of a case, or of one member of a family, and what is kept of it.

    Parameters
    ----------
    model : Case or Family
    values : mapping of str to float or str, optional
        Parameters over those of the model. A case takes every name and unit of its file:
        ``{"pinion_speed": "3600 rpm"}``.
    name : str, optional
        Parameter whose value, dimensionless, the point carries; its value is NaN without.
    start : array_like of shape (n,), optional
        State at phase zero; the model's cold start without.
    trial : (array_like of shape (n,), int), optional
        State and base periods of a periodic orbit to try first, as for `attractor`.
    settings : Settings, optional
        How the attractor is looked for.

    Returns
    -------
    Point
        What cannot be built or solved gives a point of status ``failed`` with the reason as its message.

    Raises
    ------
    GearlashError
        For names, values and starts that do not fit.

    Examples
    --------
    >>> import gearlash as gl
    >>> found = gl.point(gl.load_case("wind-turbine"), {"pinion_speed": "1800 rpm"})
    >>> str(found.label), str(found.certificate)
    ('1-0-0', 'certified')
    """
    family = Source.of(model).family()
    numbers = plain_values(model, family, values)
    if name is not None:
        name = short_name(model, family, name)
    begin = None if start is None else given.numbers("start", start, (len(family.states),))
    return evaluate(family, numbers, name, begin, trial, checked_settings(settings), None)[0]


def evaluate(
    family: Family,
    values: dict[str, float],
    name: str | None,
    start: ArrayLike | None,
    trial: tuple[ArrayLike, int] | None,
    settings: Settings,
    reuse: Propagators | None,
) -> tuple[Point, Propagators | None]:
    """`point`, with the propagators it was computed with, for the next point to reuse."""
    value = NOT_A_NUMBER
    try:
        values = family.complete(values)
        value = NOT_A_NUMBER if name is None else values[name]
        props = flow.propagators(family.system(values), reuse)
        begin = family.start(values) if start is None else start
        return summary(attractor(props, begin, settings, trial), value), props
    except (GearlashError, LinAlgError) as error:
        value = values.get(name, value) if name is not None else value
        return blank(value, Status.FAILED, str(error) or type(error).__name__), reuse


def summary(found: Attractor, value: float = NOT_A_NUMBER) -> Point:
    """What is kept of an attractor. A motion that ran away has no sections."""
    orbit = found if isinstance(found, Orbit) else None
    about = {
        "value": float(value),
        "status": found.status,
        "message": found.message,
        "label": found.label,
        "largest_exponent": float(found.largest_exponent),
        "exponent_error": float(found.exponent_error),
        "periods_used": int(found.periods_used),
        "state": np.array(found.final_state),
    }
    if orbit is not None:
        signature = orbit.signature
        about |= {"period": signature.period, "drive": signature.drive, "back": signature.back}
        about |= {"others": signature.others}
        about |= {"leading": orbit.leading, "residual": float(orbit.residual)}
    about |= {"certificate": str(found.certificate.verdict), "certificate_reason": found.certificate.reason}
    if found.status in TRACEABLE and np.isfinite(found.final_state).all():
        about |= _sections(found) | force_figures(found.trace)
    return Point(**about)


def _sections(found: Attractor) -> dict[str, np.ndarray]:
    """σ_t, σ_d and σ_b of the first clearance as a point keeps them."""
    system, events, strobes = found.propagators.system, found.events.of(0), found.strobes
    phase = np.arange(len(strobes), dtype=np.float64) * system.cycles
    engaging = np.asarray(events.engaging, dtype=np.bool_)
    drive, back = engaging & (events.boundary > 0), engaging & (events.boundary < 0)
    release = ~engaging & (events.boundary < 0)
    return {
        "strobes": gap_displacement(system, phase, strobes),
        "drive_force": events.force[drive],
        "drive_phase": events.phase[drive],
        "back_force": events.force[back],
        "back_phase": events.phase[back],
        "back_release_force": events.force[release],
        "back_release_phase": events.phase[release],
    }
