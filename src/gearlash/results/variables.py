"""The variables of a sweep's dataset: what each is and how it is read from a point."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from operator import attrgetter
from typing import Any

from gearlash.system import label_text

from .forces import stored


@dataclass(frozen=True)
class Variable:
    """``quantity`` (length, force, rate or nothing) decides the physical unit that goes with it."""

    name: str
    long_name: str
    read: Callable[[Any], Any]
    dtype: str = "f8"
    units: str = "1"
    quantity: str = ""


def _same(name: str, long_name: str, dtype: str = "f8", units: str = "1", quantity: str = "") -> Variable:
    return Variable(name, long_name, attrgetter(name), dtype, units, quantity)


def _crossing_force(name: str, long_name: str) -> Variable:
    """The contact force at crossings, in the sign that files have."""
    return Variable(name, long_name, lambda point: stored(getattr(point, name)), quantity="force")


SCALARS = (
    Variable("status", "outcome of the computation", lambda point: str(point.status), "U"),
    _same("message", "what is known about the motion", "U"),
    Variable(
        "label",
        "signature P-Q-R (and /Q-R of every further clearance), or aperiodic, neutral or unresolved",
        lambda point: label_text(point.label),
        "U",
    ),
    _same("period", "least period P, 0 where none was proved", "i4", "cycles"),
    _same("drive", "impacts Q on the drive side per period (first clearance)", "i4"),
    _same("back", "impacts R on the back side per period (first clearance)", "i4"),
    _same("other_impacts", "impacts in all further clearances per period", "i4"),
    _same("certificate", "certified, uncertain or failed; empty where nothing was computed", "U"),
    _same("certificate_reason", "why it is not certified", "U"),
    _same("largest_exponent", "largest Lyapunov exponent", quantity="rate"),
    _same("exponent_error", "half-width of its 95 % interval, 0 on periodic orbits", quantity="rate"),
    Variable("leading_real", "multiplier of largest modulus, real part", lambda point: point.leading.real),
    Variable(
        "leading_imag", "multiplier of largest modulus, imaginary part", lambda point: point.leading.imag
    ),
    Variable("leading_modulus", "multiplier of largest modulus, modulus", lambda point: abs(point.leading)),
    _same("residual", "of the closed orbit, of each state relative to what rounding acts on"),
    _same("periods_used", "base periods marched", "i4", "base periods"),
    _same("minimum", "least X", quantity="length"),
    _same("maximum", "largest X", quantity="length"),
    _same("force_min", "least contact force Φ (negative: back side, or damping)", quantity="force"),
    _same("force_max", "largest contact force Φ", quantity="force"),
    _same("force_rms", "rms of the contact force Φ", quantity="force"),
    _same("share_without_contact", "share of time without contact, 0 to 1"),
)

PADDED = (
    (_same("state", "state at phase zero"), "state_name"),
    (_same("strobes", "X on σ_t", quantity="length"), "strobe"),
    (_crossing_force("drive_force", "F = -Φ at impacts on the drive side, σ_d"), "drive_hit"),
    (_same("drive_phase", "phase of these impacts", units="cycles"), "drive_hit"),
    (_crossing_force("back_force", "F = -Φ at impacts on the back side"), "back_hit"),
    (_same("back_phase", "phase of these impacts", units="cycles"), "back_hit"),
    (
        _crossing_force("back_release_force", "F = -Φ where the back side is left (σ_b as printed)"),
        "back_release",
    ),
    (
        _same("back_release_phase", "phase where the back side is left", units="cycles"),
        "back_release",
    ),
)
"""Variables of several numbers a point, with the dimension they run along."""

TAKEN = frozenset(
    ["direction", "coexisting", "label_name", *(v.name for v in SCALARS), *(v.name for v, _ in PADDED)]
) | frozenset(dim for _, dim in PADDED)
"""Names in a dataset that no parameter can have there."""


def dimension(parameter: str, taken: frozenset[str] = TAKEN) -> str:
    """The name of a parameter's values in a dataset: its own, unless the dataset uses that for something
    else."""
    plain = parameter.replace("/", "_")  # which in a file begins a group
    return f"{plain}_parameter" if plain in taken else plain
