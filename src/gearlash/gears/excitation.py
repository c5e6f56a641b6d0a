"""What excites a mesh beside its named harmonics: curves of stiffness and error, and run-out of the shafts.

A curve repeats with the mesh cycle, with the pinion's turn (z_p cycles) or with the gear's turn (z_g cycles).
The base period of the pair is the least number of mesh cycles after which all of them repeat: 140 cycles for
28 and 70 teeth whose both shafts are out of true.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import lcm, pi

import numpy as np

from gearlash.system import Fourier, Parameter, cosines, evaluate, padded
from gearlash.system.harmonics import harmonics

SHAFTS = ("pinion", "gear")


@dataclass(frozen=True)
class Curve:
    """A periodic curve of the mesh.

    Parameters
    ----------
    series : ndarray, shape (2H + 1,)
        ``[mean, c1, s1, …]`` of the angle that grows by 2π in ``cycles``; its mean is not used.
    cycles : int
        Mesh cycles after which it repeats: 1, z_p or z_g.
    """

    series: Fourier
    cycles: int = 1

    def over(self, base: int) -> Fourier:
        """Without its mean, over a base period of so many mesh cycles."""
        found = spread(self.series, base // self.cycles)
        found[0] = 0.0
        return found


@dataclass(frozen=True)
class Excitation:
    """Curves that a case states, and shafts that it states a run-out of.

    Parameters
    ----------
    stiffness : Curve, optional
        k/k_m. Its parameter ``ripple_scale`` multiplies what varies of it.
    error : Curve, optional
        e/D_c of the unloaded teeth. Its parameter is ``error_scale``.
    runout : mapping of str to int
        Teeth of each shaft, ``pinion`` or ``gear``, that has the parameters ``…_runout`` and
        ``…_runout_phase``.
    runout_factor : float
        Amplitude of the error over radial run-out F_r: half of cos β_b, as F_r is twice the eccentricity.
    relief : Curve, optional
        e/D_c that modified flanks, and contact beyond the path of contact, make under the load of the case.

    Examples
    --------
    >>> from gearlash.gears.excitation import Excitation
    >>> Excitation(runout={"pinion": 28, "gear": 70}).cycles
    140
    """

    stiffness: Curve | None = None
    error: Curve | None = None
    runout: Mapping[str, int] | None = None
    runout_factor: float = 0.5
    relief: Curve | None = None

    @property
    def cycles(self) -> int:
        """Mesh cycles of the base period."""
        curves = [curve.cycles for curve in (self.stiffness, self.error, self.relief) if curve is not None]
        return lcm(*curves, *(self.runout or {}).values())

    def parameters(self, defaults: Mapping[str, float]) -> tuple[Parameter, ...]:
        """Those that this excitation adds to a mesh."""
        found = []
        if self.stiffness is not None:
            found.append(
                Parameter("ripple_scale", defaults.get("ripple_scale", 1.0), "curve of stiffness, times this")
            )
        if self.error is not None:
            found.append(
                Parameter("error_scale", defaults.get("error_scale", 1.0), "curve of error, times this")
            )
        for shaft in self.runout or {}:
            name, phase = f"{shaft}_runout", f"{shaft}_runout_phase"
            found += [
                Parameter(name, defaults.get(name, 0.0), f"radial run-out of the {shaft} over D_c"),
                Parameter(phase, defaults.get(phase, 0.0), f"phase of the run-out of the {shaft}, rad"),
            ]
        return tuple(found)

    def stiffness_series(self, values: Mapping[str, float], named: Fourier) -> Fourier:
        """η over the base period: named harmonics of the mesh cycle, and the curve."""
        found = spread(named, self.cycles)
        if self.stiffness is not None:
            found = summed(found, values["ripple_scale"] * self.stiffness.over(self.cycles))
        return found

    def error_series(self, values: Mapping[str, float], named: Fourier) -> Fourier:
        """E over the base period: named harmonics, curve, relief, and a turn's harmonic of each run-out."""
        found = spread(named, self.cycles)
        if self.error is not None:
            found = summed(found, values["error_scale"] * self.error.over(self.cycles))
        if self.relief is not None:
            found = summed(found, self.relief.over(self.cycles))
        for shaft, teeth in (self.runout or {}).items():
            height = self.runout_factor * values[f"{shaft}_runout"]
            turn = cosines(0.0, [height], [values[f"{shaft}_runout_phase"]])
            found = summed(found, spread(turn, self.cycles // teeth))
        return found


NOTHING = Excitation()
"""Named harmonics only."""


def spread(series: Fourier, times: int) -> Fourier:
    """The same curve as a series of an angle that is ``times`` as slow."""
    count = harmonics(series)
    if times == 1:
        return series.copy()
    found = np.zeros(2 * count * times + 1)
    found[0] = series[0]
    orders = times * np.arange(1, count + 1)
    found[2 * orders - 1], found[2 * orders] = series[1::2], series[2::2]
    return found


def summed(one: Fourier, other: Fourier) -> Fourier:
    """The sum of two series of one angle."""
    count = max(harmonics(one), harmonics(other))
    return padded(one, count) + padded(other, count)


def least(series: Fourier) -> float:
    """The smallest value of a series, of 32 points in its fastest turn."""
    points = 32 * max(harmonics(series), 1)
    return float(np.min(evaluate(series, np.linspace(0.0, 2.0 * pi, points, endpoint=False))))
