"""What every gear pair shares: speed, load, mesh stiffness, transmission error and the backlash itself.

    Φ = η(θ) f(X; D) + ζ X′,   η = 1 + Σ ε_n cos(nθ + φ_n),   ζ = 2ξ_m,   E = Σ E_n cos(nθ + ψ_n)

X already contains −E, so the error drives the equation of X through −E″ = Σ n²ω² E_n cos(nθ + ψ_n) only.
Curves and run-out (`gears.excitation`) add to both sums.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache
from math import inf

import numpy as np
from numpy.typing import NDArray

from gearlash.system import Clearance, ContactRule, Fourier, GearlashError, Parameter, cosines, derivative

from .excitation import NOTHING, Excitation

SMALLEST_OMEGA = 1e-9
"""Least mesh frequency: its period is finite."""
ERROR_READOUT = "transmission_error", "dynamic transmission error", "length"
"""Name, words and unit of what encoders on both shafts measure, along the line of action."""
KEPT_SERIES = 64
_HARMONIC = re.compile(r"(ripple|error)(_phase)?(?:_([1-9][0-9]*))?")


def harmonic_name(stem: str, order: int) -> str:
    """Parameter name of a harmonic: ``ripple``, ``ripple_phase``, ``ripple_2``, ``ripple_phase_2`` …"""
    return stem if order == 1 else f"{stem}_{order}"


def harmonic_count(names: Mapping[str, float], stem: str) -> int:
    """Highest order of ``ripple`` or ``error`` among the names, at least 1."""
    matches = (_HARMONIC.fullmatch(name) for name in names)
    return max((int(m[3] or 1) for m in matches if m and m[1] == stem), default=1)


def mesh_parameters(defaults: Mapping[str, float]) -> tuple[Parameter, ...]:
    """The parameters of a mesh, with these defaults.

    ``omega``, ``D`` and ``load`` must be among them; whatever else is missing is 0 (stiffness and gap ratio
    of the back side: 1). The highest ``ripple_n``, ``error_n`` named says how many harmonics there are.
    """
    missing = [name for name in ("omega", "D", "load") if name not in defaults]
    if missing:
        raise GearlashError(f"a gear pair needs a default for {', '.join(missing)}")
    return (
        Parameter("omega", defaults["omega"], "mesh frequency over ω_n", SMALLEST_OMEGA),
        Parameter("D", defaults["D"], "half the backlash over D_c", 0.0),
        Parameter("load", defaults["load"], "mean load f_m = c_t W / (k_m D_c); < 0: back side"),
        *_harmonics("ripple", "stiffness ripple", defaults, bound=2.0),  # |ε_n| ≤ 2 for any η ≥ 0 of mean 1
        *_harmonics("error", "transmission error over D_c", defaults, bound=inf),
        Parameter("mesh_damping", defaults.get("mesh_damping", 0.0), "damping ratio ξ_m of the mesh", 0.0),
        Parameter(
            "back_stiffness", defaults.get("back_stiffness", 1.0), "back over drive side stiffness", 0.0
        ),
        Parameter("back_gap", defaults.get("back_gap", 1.0), "back over drive side gap, D⁻/D", 0.0),
    )


def _harmonics(stem: str, what: str, defaults: Mapping[str, float], bound: float) -> list[Parameter]:
    found = []
    for order in range(1, harmonic_count(defaults, stem) + 1):
        amplitude, phase = harmonic_name(stem, order), harmonic_name(f"{stem}_phase", order)
        found += [
            Parameter(amplitude, defaults.get(amplitude, 0.0), f"{what}, harmonic {order}", -bound, bound),
            Parameter(phase, defaults.get(phase, 0.0), f"phase of that harmonic, rad (order {order})"),
        ]
    return found


def series(values: Mapping[str, float], stem: str, mean: float, count: int) -> Fourier:
    """mean + Σ amplitude_n cos(nθ + phase_n) of ``ripple`` or ``error``, shape (2·count + 1,), read-only."""
    amplitudes, phases = (
        tuple(values[harmonic_name(part, n)] for n in range(1, count + 1)) for part in (stem, f"{stem}_phase")
    )
    return _summed(mean, amplitudes, phases)


@lru_cache(maxsize=KEPT_SERIES)
def _summed(mean: float, amplitudes: tuple[float, ...], phases: tuple[float, ...]) -> Fourier:
    """Kept, as most parameters leave a series as it is."""
    found = cosines(mean, amplitudes, phases)
    found.setflags(write=False)
    return found


def acceleration_forcing(
    values: Mapping[str, float], count: int, excitation: Excitation = NOTHING
) -> Fourier:
    """f_m − E″ as a Fourier series over the base period: what drives X″."""
    error = excitation.error_series(values, series(values, "error", 0.0, count))
    forcing = -((values["omega"] / excitation.cycles) ** 2) * derivative(derivative(error))
    forcing[0] = values["load"]
    return forcing


def mesh_clearance(
    values: Mapping[str, float],
    h: NDArray[np.float64],
    g: NDArray[np.float64],
    count: int,
    contact: ContactRule,
    excitation: Excitation = NOTHING,
) -> Clearance:
    """The backlash as a clearance on X = h·z; the back side is the drive side scaled by the two ratios."""
    stiffness = excitation.stiffness_series(values, series(values, "ripple", 1.0, count))
    return Clearance(
        h=h,
        g=g,
        gap_plus=values["D"],
        gap_minus=values["D"] * values["back_gap"],
        stiffness_plus=stiffness,
        stiffness_minus=values["back_stiffness"] * stiffness,
        damping=2.0 * values["mesh_damping"],
        contact=contact,
    )


def rotation_parameter(default: float) -> Parameter:
    """c_t² as a parameter; a steep helix may have one below the usual range."""
    return Parameter("rotation_factor", default, "c_t²", min(1e-6, default))


def resting_displacement(values: Mapping[str, float], rotation_factor: float) -> float:
    """X of the cold start, pressed against the loaded side, bearings undeflected: sign(f_m) D + f_m / c_t².

    Under negative load the back side carries, with its own gap and stiffness (a back side of stiffness zero
    cannot: there the drive side's value is used).
    """
    load = values["load"]
    if load >= 0.0:
        return (values["D"] if load > 0.0 else 0.0) + load / rotation_factor
    stiffness = values["back_stiffness"] or 1.0
    return -values["D"] * values["back_gap"] + load / (rotation_factor * stiffness)
