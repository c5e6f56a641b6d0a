"""Materials of gears and housings: what stiffness, mass and temperature need, each with its range and source.

Values at 20 °C. A plastic's modulus depends on temperature, moisture and time more than on its name: its
range is wide and a data sheet is better.

Where designations are taken for an entry, data sheets have these values (E in GPa; expansion in 10⁻⁶/K):

- steel: AISI 4140 and 4340 (BS 817M40, En 24) 205, ν 0.29, 12.3 (asm.matweb.com, bassnum M434AE); 1020, 1040,
  4140 and 4340 207 (W. D. Callister, Materials Science and Engineering, table B.2); carbon steels of AS 1442
  200, 12 (mem50212.com, Materials_ferrous.html); 8620 expansion 13 (makeitfrom.com, where this steel, C50 and
  A36 all have 190, to two digits); 20CrMnTi 207, 12.6 (duan168.com/sell/show-4694.html); 40CrNiMoA 209
  (dou03.com/Shownews.asp?ID=8634).
- nodular cast iron: EN 1563, GJS-350 to 500 169, GJS-600 174, GJS-700 176, 7100 and 7200 kg/m³
  (iron-foundry.com, equivalent standards EN 1563).
- grey cast iron: EN 1561, GJL-250 103 to 118, GJL-300 108 to 137, ν 0.26, 7200 and 7250 kg/m³
  (sn-castiron.nl/?p=2224); ISO 6336-2 has ν 0.3.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import pi, sqrt
from types import MappingProxyType
from typing import Any

from gearlash.system import GearlashError

from .material_names import listed_name, nearest_material

_ISO = "E, ν: ISO 6336-2, elasticity factors; rest: handbook values; ranges: estimates"
_GREY = "E, ν: ISO 6336-2, elasticity factors; range of E: EN 1561, GJL-250 and 300; rest: handbook values"
_STEEL = "E, ν: ISO 6336-2, elasticity factors; density: ISO 6336-1; rest: handbook values; ranges: estimates"
_HANDBOOK = "handbook values; ranges: estimates"
_BRASS = "CuZn38Pb2 to CuZn39Pb3, EN 12164: data sheets; ν: handbook; ranges: estimates"
_PLASTIC = (
    "E, density: Encyclopedia of Physical Science and Technology, 3rd ed., Plastics Engineering; expansion: "
    "R. J. Crawford, Plastics Engineering; ν: handbook; ranges, dry to moist and cold to warm: estimates"
)
OF_DATA_SHEETS = "youngs_modulus", "poisson_ratio", "density", "thermal_expansion"
"""What a case may state of a gear in place of values of its material, in the order of `with_own`."""
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
            _material("steel", (206, 200, 212), 0.3, 7830, (11.5, 11.0, 13.0), _STEEL),
            _material("cast-steel", (202, 195, 210), 0.3, 7830, (11.5, 11.0, 12.5), _STEEL),
            _material("nodular-cast-iron", (173, 165, 180), 0.3, 7100, (12.0, 10.5, 13.0), _ISO),
            _material("grey-cast-iron", (118, 100, 137), 0.3, 7200, (10.5, 9.0, 12.0), _GREY),
            _material("tin-bronze", (103, 95, 115), 0.3, 8800, (18.0, 17.0, 19.0), _ISO),
            _material("brass", (100, 95, 110), 0.34, 8450, (20.5, 19.0, 21.5), _BRASS),
            _material("aluminium", (70, 68, 75), 0.33, 2700, (23.0, 20.0, 24.0), _HANDBOOK),
            _material("POM", (2.9, 1.8, 3.4), 0.35, 1410, (95, 80, 120), _PLASTIC),
            _material("PA66", (3.0, 0.9, 3.4), 0.4, 1140, (90, 70, 120), _PLASTIC),
            _material("PA66-GF30", (9.5, 5.0, 10.5), 0.38, 1370, (30, 20, 60), _PLASTIC),
            _material("PEEK", (3.6, 3.3, 4.1), 0.4, 1300, (48, 45, 60), _DATA_SHEETS),
        )
    }
)
"""By name."""


def named(name: str) -> Material:
    """A material of the list.

    Parameters
    ----------
    name : str
        A key of `MATERIALS`, another word for it, or a designation whose modulus is in its range.

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
    key = listed_name(name, tuple(MATERIALS))
    if key is None:
        raise GearlashError(f"no material {name!r}; the list has {', '.join(MATERIALS)}")
    return MATERIALS[key]


def is_listed(name: str) -> bool:
    """Whether `named` knows a name.

    Parameters
    ----------
    name : str

    Returns
    -------
    bool

    Examples
    --------
    >>> from gearlash.gears import materials
    >>> materials.is_listed("16MnCr5"), materials.is_listed("X5CrNi18-10")
    (True, False)
    """
    return listed_name(name, tuple(MATERIALS)) is not None


def nearest_name(name: str) -> str | None:
    """The name of the list that is next to one it does not have.

    Parameters
    ----------
    name : str

    Returns
    -------
    str or None

    Examples
    --------
    >>> from gearlash.gears import materials
    >>> materials.nearest_name("X5CrNi18-10")
    'steel'
    """
    return nearest_material(name, tuple(MATERIALS))


def with_own(
    material: Material,
    youngs_modulus: float | None = None,
    poisson_ratio: float | None = None,
    density: float | None = None,
    expansion: float | None = None,
) -> Material:
    """A material with values of a data sheet in place of those of the list.

    Parameters
    ----------
    material : Material
    youngs_modulus, poisson_ratio, density, expansion : float, optional
        In SI units. A stated modulus or expansion is its whole range.

    Returns
    -------
    Material

    Examples
    --------
    >>> from gearlash.gears import materials
    >>> own = materials.with_own(materials.named("steel"), youngs_modulus=195e9)
    >>> own.youngs_range, own.density
    ((195000000000.0, 195000000000.0), 7830.0)
    """
    own = {
        "youngs_modulus": youngs_modulus,
        "poisson_ratio": poisson_ratio,
        "density": density,
        "expansion": expansion,
    }
    stated: dict[str, Any] = {name: value for name, value in own.items() if value is not None}
    if not stated:
        return material
    if youngs_modulus is not None:
        stated["youngs_range"] = (youngs_modulus, youngs_modulus)
    if expansion is not None:
        stated["expansion_range"] = (expansion, expansion)
    names = {"youngs_modulus": "E", "poisson_ratio": "ν", "density": "density", "expansion": "expansion"}
    told = ", ".join(names[name] for name in own if own[name] is not None)
    return replace(material, source=f"{told}: stated; {material.source}", **stated)


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
