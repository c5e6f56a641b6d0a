"""The physical units of a gear pair: what its dimensionless numbers are multiplied by, and in which unit they
are told. A pair without scales is told in its own numbers."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.case import Case
from gearlash.case.units import pretty


@dataclass(frozen=True)
class Unit:
    """A unit of one quantity.

    Parameters
    ----------
    factor : float
        Physical over dimensionless values.
    name : str
        As it is written; empty for a number of one.
    ascii : str
        As it stands in the names of columns.
    reference : float
        That levels in dB refer to, in this unit: ISO 1683 (1 µN, 1 pm), or 1 of a number.
    reference_name : str
    """

    factor: float
    name: str
    ascii: str
    reference: float = 1.0
    reference_name: str = "1"

    def text(self, value: float, digits: int = 4) -> str:
        """A dimensionless value in this unit: ``4257 N``."""
        number = f"{self.factor * value:.{digits}g}"
        if "e" in number:
            number = f"{self.factor * value:.0f}" if abs(self.factor * value) >= 1.0 else number
        return f"{number} {self.name}" if self.name else number


@dataclass(frozen=True)
class PairUnits:
    """The units of a pair.

    Parameters
    ----------
    speed, force, length, velocity, torque, time : Unit
        Of ω, Φ, X, X′, f_m and τ.
    """

    speed: Unit
    force: Unit
    length: Unit
    velocity: Unit
    torque: Unit
    time: Unit

    @staticmethod
    def of(case: Case) -> PairUnits:
        """Those of a case: rpm, N, µm, m/s, N·m and ms as far as its scales reach."""
        scales = case.scales
        if not scales.physical:
            own = Unit(1.0, "", "")
            return PairUnits(own, own, own, own, own, own)
        rpm = Unit(float(scales.pinion_rpm(1.0)), "rpm", "rpm") if scales.teeth else None
        hertz = Unit(float(scales.mesh_hz(1.0)), "Hz", "Hz")
        newtons = Unit(float(scales.force_N(1.0)), "N", "N", 1e-6, "1 µN")
        if scales.radii is None:
            torque = Unit(newtons.factor / scales.c_t, "N", "N")
        else:
            torque = Unit(float(scales.torque(1.0)), "N·m", "Nm")
        return PairUnits(
            speed=rpm or hertz,
            force=newtons,
            length=Unit(float(scales.length_um(1.0)), "µm", "um", 1e-6, "1 pm"),
            velocity=Unit(1e3 * float(scales.velocity(1.0)), "mm/s", "mm_s"),
            torque=torque,
            time=Unit(1e3 * float(scales.time_s(1.0)), "ms", "ms"),
        )


def stated_at_gear(case: Case, short: str, value: float, digits: int) -> str:
    """``3000 rpm`` of the gear, where the case states its speed or torque in place of the pinion's; else
    nothing."""
    found = case.at_gear(short)
    if found is None or found[0] not in case.entries:
        return ""
    return f"{found[1] * value:.{digits}g} {pretty(found[2])}"
