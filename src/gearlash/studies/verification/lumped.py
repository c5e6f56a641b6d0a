"""The lumped model at the inputs of the multibody one, under every contact rule."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.gears.excitation import NOTHING
from gearlash.gears.mesh import harmonic_name
from gearlash.jobs import Execution
from gearlash.orbits import attractor
from gearlash.results import Axis
from gearlash.studies.motion import motion
from gearlash.studies.point import point
from gearlash.studies.sweep import sweeps
from gearlash.system import ContactRule, Family

from .refused import gears_of

Array = NDArray[np.float64]
SHOWN, SAMPLES, KEPT = 2, 400, 80
"""Mesh cycles of force that are kept, its samples a cycle, and how many of them about are kept."""
HIGHEST = 8
"""Order of the mesh frequency up to which amplitudes are kept."""
_EXCITES = re.compile(r"ripple|error|\w+_runout")
"""Names of parameters of a family that say how its mesh is excited."""


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
    errors : tuple of complex
        Of the mesh orders 1, 2, …, m, in the same mesh phase: on the flanks, and what these make under load.
    bearings : float
        Stiffness of all bearings over that of the case.
    """

    stiffness: float
    ripples: tuple[float, ...]
    ripple_phases: tuple[float, ...]
    torque: float
    errors: tuple[complex, ...]
    bearings: float = 1.0


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


def lumped_family(case: Case, given: LumpedInputs, rule: ContactRule) -> Family:
    """The case's model with what the multibody model gives in place of its own excitation and load.

    Parameters
    ----------
    case : Case
        Of a pair of gears.
    given : LumpedInputs
    rule : ContactRule

    Returns
    -------
    Family
        In units of the given stiffness: ω is the mesh frequency over √(k/m_e). It has the harmonics given,
        and no curve, run-out or relief beside them.
    """
    content = gears_of(case)
    own, softer = content.numbers, content.numbers.scales.mean_stiffness
    assert softer is not None  # `gears_of` saw to it, here and below
    assert own.scales.omega_n is not None
    assert own.scales.length is not None
    growth = given.stiffness / softer
    scales = replace(
        own.scales, mean_stiffness=given.stiffness, omega_n=own.scales.omega_n * float(np.sqrt(growth))
    )
    kept = {name: value for name, value in own.parameters.items() if not _EXCITES.match(name)}
    excited = {
        **_named("ripple", given.ripples, given.ripple_phases),
        **_named("error", [abs(e) / own.scales.length for e in given.errors], np.angle(given.errors)),
    }
    pair = own.pair
    if pair is not None:
        stiffer = float(np.sqrt(given.bearings / growth))
        yp, zp, yg, zg = (stiffer * kappa for kappa in pair.bearing_frequencies)
        pair = replace(pair, bearing_frequencies=(yp, zp, yg, zg), contact=rule)
    load = float(scales.load_from_torque(given.torque))
    changed = replace(
        own,
        parameters={**kept, **excited, "load": load},
        pair=pair,
        contact=rule,
        scales=scales,
        excitation=NOTHING,
    )
    return content.rules.family(changed)


def _named(stem: str, amplitudes: Sequence[float], phases: Sequence[float] | Array) -> dict[str, float]:
    """Harmonics by the names of a family."""
    found = {}
    for n, (amplitude, phase) in enumerate(zip(amplitudes, phases, strict=True), start=1):
        found[harmonic_name(stem, n)] = float(amplitude)
        found[harmonic_name(f"{stem}_phase", n)] = float(phase)
    return found


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
    rule, (family, _) = gears_of(case).numbers.contact, case.family()
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
        family = lumped_family(case, given, rule)
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
        up, down = sweeps(
            lumped_family(case, given, rule), Axis("omega", omegas), ("up", "down"), execution=execution
        )
        found[rule] = tuple(tuple(str(p.label or p.status) for p in each.points) for each in (up, down))
    return found
