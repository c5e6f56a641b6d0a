"""Materials of gears and housings: what stiffness, mass and temperature need, each with its range and source.

Values at 20 °C. A plastic's modulus depends on temperature, moisture and time more than on its name: its
range is wide and a data sheet is better.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi, sqrt
from types import MappingProxyType

from gearlash.system import GearlashError

_ISO = "E, ν: ISO 6336-2, elasticity factors; rest: handbook values; ranges: estimates"
_STEEL = "E, ν: ISO 6336-2, elasticity factors; density: ISO 6336-1; rest: handbook values; ranges: estimates"
_HANDBOOK = "handbook values; ranges: estimates"
_PLASTIC = (
    "E, density: Encyclopedia of Physical Science and Technology, 3rd ed., Plastics Engineering; expansion: "
    "R. J. Crawford, Plastics Engineering; ν: handbook; ranges, dry to moist and cold to warm: estimates"
)
_DATA_SHEETS = "E: data sheets; density, expansion: R. J. Crawford, Plastics Engineering; ranges: estimates"


@dataclass(frozen=True)
class Material:
    """An isotropic material.

    Parameters
    ----------
    name : str
    youngs_modulus : float
        E, Pa.
    poisson_ratio : float
        ν.
    density : float
        ρ, kg/m³.
    expansion : float
        Coefficient of linear thermal expansion, 1/K.
    youngs_range, expansion_range : (float, float)
        What E and the expansion may be, without a data sheet.
    source : str

    Examples
    --------
    >>> from gearlash.gears import materials
    >>> steel = materials.named("steel")
    >>> steel.youngs_modulus / 1e9, steel.density
    (206.0, 7830.0)
    """

    name: str
    youngs_modulus: float
    poisson_ratio: float
    density: float
    expansion: float
    youngs_range: tuple[float, float]
    expansion_range: tuple[float, float]
    source: str


def _material(
    name: str,
    modulus: tuple[float, float, float],
    poisson: float,
    density: float,
    expansion: tuple[float, float, float],
    source: str,
) -> Material:
    """From value, least and greatest: E in GPa, expansion in 10⁻⁶/K."""
    return Material(
        name,
        modulus[0] * 1e9,
        poisson,
        float(density),
        expansion[0] * 1e-6,
        (modulus[1] * 1e9, modulus[2] * 1e9),
        (expansion[1] * 1e-6, expansion[2] * 1e-6),
        source,
    )


MATERIALS: Mapping[str, Material] = MappingProxyType(
    {
        one.name: one
        for one in (
            _material("steel", (206, 200, 212), 0.3, 7830, (11.5, 11.0, 12.5), _STEEL),
            _material("cast-steel", (202, 195, 210), 0.3, 7830, (11.5, 11.0, 12.5), _STEEL),
            _material("nodular-cast-iron", (173, 165, 180), 0.3, 7100, (12.0, 10.5, 13.0), _ISO),
            _material("grey-cast-iron", (118, 100, 130), 0.3, 7200, (10.5, 9.0, 12.0), _ISO),
            _material("tin-bronze", (103, 95, 115), 0.3, 8800, (18.0, 17.0, 19.0), _ISO),
            _material("aluminium", (70, 68, 75), 0.33, 2700, (23.0, 20.0, 24.0), _HANDBOOK),
            _material("POM", (2.9, 1.8, 3.4), 0.35, 1410, (95, 80, 120), _PLASTIC),
            _material("PA66", (3.0, 0.9, 3.4), 0.4, 1140, (90, 70, 120), _PLASTIC),
            _material("PA66-GF30", (9.5, 5.0, 10.5), 0.38, 1370, (30, 20, 60), _PLASTIC),
            _material("PEEK", (3.6, 3.3, 4.1), 0.4, 1300, (48, 45, 60), _DATA_SHEETS),
        )
    }
)
"""By name."""


STEELS = (
    *("16MnCr5", "20MnCr5", "18CrNiMo7-6", "17CrNiMo6", "17NiCrMo6-4", "14NiCrMo13-4", "15CrNi6", "20CrMnTi"),
    *("20NiCrMo2-2", "SCM415", "SCM420", "SCM440", "SCr420", "8620", "9310", "4140", "4340", "1045"),
    *("31CrMoV9", "34CrNiMo6", "42CrMo4", "C45", "C45E", "S45C", "E335", "S355"),
)
"""Designations that drawings have for gear steels: all of them have the modulus of steel."""


def named(name: str) -> Material:
    """A material of the list.

    Parameters
    ----------
    name : str
        A key of `MATERIALS` or one of `STEELS`, in any case.

    Returns
    -------
    Material

    Raises
    ------
    GearlashError
        For a name that the list does not have.

    Examples
    --------
    >>> from gearlash.gears import materials
    >>> materials.named("pom").density
    1410.0
    """
    plain = name.strip().casefold()
    for key, material in MATERIALS.items():
        if key.casefold() == plain:
            return material
    if plain in (steel.casefold() for steel in STEELS):
        return MATERIALS["steel"]
    raise GearlashError(f"no material {name!r}; the list has {', '.join(MATERIALS)}")


def elasticity_factor(first: Material, second: Material) -> float:
    """Elasticity factor of a pair, Z_E = √(1 / (π Σ (1 − ν²)/E)), √Pa.

    References
    ----------
    ISO 6336-2, elasticity factor Z_E.

    Examples
    --------
    >>> from gearlash.gears import materials
    >>> steel = materials.named("steel")
    >>> round(materials.elasticity_factor(steel, steel) / 1e3, 1)  # √(N/mm²)
    189.8
    """
    compliance = sum((1.0 - one.poisson_ratio**2) / one.youngs_modulus for one in (first, second))
    return sqrt(1.0 / (pi * compliance))
