"""The lumped model at the inputs of the multibody one, under every contact rule."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.jobs import Execution
from gearlash.orbits import attractor
from gearlash.results import Axis
from gearlash.studies.motion import motion
from gearlash.studies.point import point
from gearlash.studies.sweep import sweeps
from gearlash.system import ContactRule, Family

Array = NDArray[np.float64]
SHOWN, SAMPLES, KEPT = 2, 400, 80
"""Mesh cycles of force that are kept, its samples a cycle, and how many of them about are kept."""
HIGHEST = 8
"""Order of the mesh frequency up to which amplitudes are kept."""


@dataclass(frozen=True)
class LumpedInputs:
    """What the multibody model hands to the lumped one.

    Attributes
    ----------
    stiffness : float
        Mean, N/m.
    ripples, ripple_phases : tuple of float
        Of the mesh orders 1, 2, … of the stiffness over its mean, and rad, cosines of the mesh phase.
    torque : float
        N·m.
    error, error_phase : float
        m and rad, in the same mesh phase.
    relief_errors : tuple of complex
        Beside it, of the mesh orders 1, 2, …, m: what relief that the case does not state makes.
    bearings : float
        Stiffness of all bearings over that of the case.
    """

    stiffness: float
    ripples: tuple[float, ...]
    ripple_phases: tuple[float, ...]
    torque: float
    error: float
    error_phase: float
    relief_errors: tuple[complex, ...] = ()
    bearings: float = 1.0

    @property
    def errors(self) -> tuple[complex, ...]:
        """All of the error, of the mesh orders 1, 2, …, m."""
        first, *others = self.relief_errors or (0j,)
        return (complex(self.error * np.exp(1j * self.error_phase)) + first, *others)


@dataclass(frozen=True)
class LumpedPoint:
    """A motion of the lumped model.

    Attributes
    ----------
    omega : float
    rule : ContactRule
    label : str
        P-Q-R, or what the motion is where it has none.
    apart : float or None
        Share of time in which the teeth do not touch; None where there is no orbit.
    phase, force : ndarray
        Mesh cycles, and the contact force over the mean one: of one period, or of the first mesh cycles of a
        motion without one.
    order, amplitude : ndarray
        Orders of the mesh frequency up to `HIGHEST`, and amplitudes of that force; empty for a motion without
        a period.
    """

    omega: float
    rule: ContactRule
    label: str
    apart: float | None
    phase: Array
    force: Array
    order: Array
    amplitude: Array


def lumped_case(case: Case, given: LumpedInputs, rule: ContactRule) -> Case:
    """The case with what the multibody model gives in place of its own.

    Parameters
    ----------
    case : Case
    given : LumpedInputs
    rule : ContactRule

    Returns
    -------
    Case
    """
    known = {value.path for value in case.values()}
    first, *others = given.errors
    changes: dict[str, object] = {
        "mesh.mean_stiffness": f"{given.stiffness!r} N/m",
        "operation.torque": f"{given.torque!r} N*m",
        "mesh.error": f"{abs(first) * 1e6!r} um",
        "dimensionless.error_phase": float(np.angle(first)),
        "model.contact": str(rule),
    }
    for n in range(1, 9):
        tail = "" if n == 1 else f"_{n}"
        if n <= len(given.ripples):
            changes[f"dimensionless.ripple{tail}"] = given.ripples[n - 1]
            changes[f"dimensionless.ripple_phase{tail}"] = given.ripple_phases[n - 1]
        elif f"dimensionless.ripple{tail}" in known:
            changes[f"dimensionless.ripple{tail}"] = 0.0
    length = case.scales.length
    for n, error in enumerate(others, start=2):
        assert length is not None  # of every case with teeth
        changes[f"dimensionless.error_{n}"] = abs(error) / length
        changes[f"dimensionless.error_phase_{n}"] = float(np.angle(error))
    if given.bearings != 1.0:
        changes |= _bearings(case, given.bearings)
    return case.with_overrides(changes)


def _bearings(case: Case, stiffer: float) -> dict[str, object]:
    """All that the case states of bearings' stiffness, times a factor."""
    return {
        value.path: f"{stiffer * float(value.value)!r} {value.unit}"
        for value in case.values()
        if "bearing_stiffness_" in value.path and isinstance(value.value, int | float)
    }


def stated_points(case: Case, omegas: tuple[float, ...]) -> tuple[LumpedPoint, ...]:
    """The motions of the case as it is, with the stiffness that it states, from the cold start.

    Parameters
    ----------
    case : Case
    omegas : tuple of float

    Returns
    -------
    tuple of LumpedPoint
    """
    rule = next(ContactRule(str(v.value)) for v in case.values() if v.path == "model.contact")
    family, _ = case.family()
    return tuple(_point(family, rule, omega) for omega in omegas)


def lumped_points(case: Case, given: LumpedInputs, omegas: tuple[float, ...]) -> tuple[LumpedPoint, ...]:
    """The motions from the cold start, under every rule.

    Parameters
    ----------
    case : Case
    given : LumpedInputs
    omegas : tuple of float

    Returns
    -------
    tuple of LumpedPoint
    """
    found = []
    for rule in ContactRule:
        family, _ = lumped_case(case, given, rule).family()
        found += [_point(family, rule, omega) for omega in omegas]
    return tuple(found)


def _point(family: Family, rule: ContactRule, omega: float) -> LumpedPoint:
    values = {"omega": omega}
    one = point(family, values)
    shown = motion(attractor(family.system(values), family.start(values)))
    every = family.complete(values)
    mean = every["load"] / every["rotation_factor"]
    kept = slice(0, SHOWN * SAMPLES, SAMPLES // KEPT)
    label = str(one.label or one.status)
    spectrum = _orders(shown.phase, shown.force / mean, shown.period)
    return LumpedPoint(
        omega, rule, label, one.share_without_contact, shown.phase[kept], shown.force[kept] / mean, *spectrum
    )


def _orders(phase: Array, force: Array, period: int) -> tuple[Array, Array]:
    """Orders and amplitudes of a motion of some mesh cycles; none where nothing periodic was proved."""
    if period == 0:
        return np.zeros(0), np.zeros(0)
    at = phase[0] + np.arange(period * SAMPLES) / SAMPLES
    lines = np.abs(np.fft.rfft(np.interp(at, phase, force, period=period))) * 2.0 / len(at)
    count = HIGHEST * period
    return np.arange(1, count + 1) / period, lines[1 : count + 1]


def lumped_window(
    case: Case, given: LumpedInputs, omegas: Array, execution: Execution | None = None
) -> dict[ContactRule, tuple[tuple[str, ...], tuple[str, ...]]]:
    """Labels over the grid going up and going down, under every rule, both in ascending order of speed.

    Parameters
    ----------
    case : Case
    given : LumpedInputs
    omegas : ndarray
    execution : Execution, optional

    Returns
    -------
    dict
    """
    found = {}
    for rule in ContactRule:
        chosen = lumped_case(case, given, rule)
        up, down = sweeps(chosen, Axis("omega", omegas), ("up", "down"), execution=execution)
        found[rule] = tuple(tuple(str(p.label or p.status) for p in each.points) for each in (up, down))
    return found
