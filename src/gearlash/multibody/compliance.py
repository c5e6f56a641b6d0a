"""How the flanks of a gear give way under forces on them: teeth and rim in finite elements, without the dent.

A sector of the gear is held at its inner face and at the cuts through its rim. The dent below a concentrated
force depends on the mesh; so the part of the displacement that comes from a layer below the flank, held where
it joins the rest, is taken out (the sub-model of Andersson and Vedmar). What replaces it is Hertz's approach
of a half-plane relative to `FlankCompliance.depth`, which gives as much as that layer (`dent`).
"""

from __future__ import annotations

import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import cache
from importlib.metadata import version
from pathlib import Path

import numpy as np
import scipy.sparse as sparse
from numpy.typing import NDArray
from scipy.sparse.linalg import splu

from gearlash.gears import CylindricalGear, CylindricalPair
from gearlash.gears.materials import Material, named
from gearlash.system import GearlashError

from . import kept
from .dent import half_plane_depth
from .elastic import ElasticModel, elastic_model
from .extra import require_extra
from .flank_loads import flank_loads
from .hexahedra import GearSector, gear_sector
from .tooth_section import Fineness, default_depth, tooth_section

Reals = NDArray[np.float64]
Integers = NDArray[np.int64]
MAKERS = ("compliance", "dent", "elastic", "flank_loads", "hexahedra", "tooth_section")
"""Modules on which a kept compliance depends."""


@dataclass(frozen=True)
class SectorSettings:
    """How the sector of a gear is cut and divided.

    Parameters
    ----------
    fineness : Fineness
    teeth : int
        Of the sector; odd, from 3.
    rim_depth : float
        Below the root circle, over the normal module; above 0. There and at both cuts the sector is held.
    layer : float, optional
        Depth of what is taken out below the flank, over the normal module; where nothing is given 0.2, or
        less on a pointed tooth.

    Examples
    --------
    >>> from gearlash.multibody.compliance import SectorSettings
    >>> SectorSettings().teeth
    5
    """

    fineness: Fineness = field(default_factory=Fineness)
    teeth: int = 5
    rim_depth: float = 4.0
    layer: float | None = None

    def __post_init__(self) -> None:
        """A middle tooth has neighbours on both sides."""
        if self.teeth < 3 or self.teeth % 2 == 0:
            raise GearlashError(f"a sector of {self.teeth} teeth: it has 3, 5, 7 …")


@dataclass(frozen=True)
class FlankCompliance:
    """How the flanks of a gear give way, on a grid over the flank on the side of larger angles about +z.

    Parameters
    ----------
    roll : ndarray, shape (nr,)
        Radii of curvature in the transverse section, m: from the start of the involute to the tip.
    axial : ndarray, shape (nz,)
        z, m: −b/2 to b/2.
    influence : ndarray, shape (2M + 1, nr·nz, nr·nz)
        m/N: entry [M + m, a, b] is the displacement at place b of tooth k + m under a force of 1 N at place a
        of tooth k; both along the flank's normal, into the tooth. Place = row of `roll` times nz + row of
        `axial`; tooth k + 1 is the next one towards larger angles. A place stands for the hat over its
        neighbours along z: forces there are spread, displacements are averaged.
    depth : float
        Below the flank, m: the approach of the contact relative to this depth of a half-plane comes on top.
    asymmetry : float
        Greatest difference of what should be equal (a force here and a displacement there, or the other way
        round), over the greatest influence. It comes from the cuts: `influence` has the mean of both.
    seconds : float
        That making it took, now or when it was kept.

    Notes
    -----
    What moves one tooth against the next hardly depends on how much of the gear the sector has; what moves
    all of them together does: the body below the sector, down to what carries it, is rigid here. Where it
    gives way, modes of the body have to say so (`reduced`), or a sector of more teeth with a deeper rim.

    The other flank has the same influence with z and m of the other sign: half a turn about the radial line
    through the middle of a tooth puts a helical gear onto itself. A force on one flank and a displacement of
    the other flank are not in here.

    References
    ----------
    A. Andersson, L. Vedmar, A dynamic model to determine vibrations in involute helical gears, J. Sound Vib.
    260 (2003) 195-212, https://doi.org/10.1016/S0022-460X(02)00920-7
    """

    roll: Reals
    axial: Reals
    influence: Reals
    depth: float
    asymmetry: float
    seconds: float


def flank_compliance(
    gear: CylindricalGear,
    face_width: float,
    material: Material | None = None,
    settings: SectorSettings | None = None,
    keep: bool = True,
) -> FlankCompliance:
    """Compliance of a gear's flanks by finite elements, or as it was kept from an earlier run.

    Parameters
    ----------
    gear : CylindricalGear
        With its own hand: a helix angle above 0 is right-handed.
    face_width : float
        b, m; above 0.
    material : Material, optional
        Steel where nothing is given.
    settings : SectorSettings, optional
    keep : bool
        Whether it may come from, and goes into, the user's cache folder.

    Returns
    -------
    FlankCompliance

    Raises
    ------
    GearlashError
        For a face without width, a rim that reaches the axis, or a layer thicker than half the tooth.
    MissingExtraError
        Without the extra `multibody`.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.multibody.compliance import SectorSettings, flank_compliance
    >>> from gearlash.multibody.tooth_section import Fineness
    >>> coarse = SectorSettings(Fineness(flank=2, fillet=1, core=1, rim=1, axial=2), teeth=3)
    >>> flanks = flank_compliance(CylindricalGear(30, 4e-3), 0.02, settings=coarse)
    >>> flanks.influence.shape
    (3, 25, 25)
    """
    if not face_width > 0.0:
        raise GearlashError(f"face width {face_width:g} m: it is above 0")
    require_extra()
    steel = named("steel") if material is None else material
    how = SectorSettings() if settings is None else settings
    teeth = _odd_at_most(how.teeth, gear.teeth)
    layer = default_depth(gear) if how.layer is None else how.layer * gear.normal_module
    section = tooth_section(gear, how.fineness, how.rim_depth * gear.normal_module, layer)
    sector = gear_sector(gear, face_width, section, how.fineness, teeth)
    key = _key(gear, sector, steel, layer)
    found = kept.read(_makers(), key) if keep else None
    if found is None:
        found = _made(gear, face_width, sector, steel, layer)
        if keep:
            kept.write(_makers(), key, found)
    return _from_arrays(found)


def _made(
    gear: CylindricalGear, face_width: float, sector: GearSector, material: Material, layer: float
) -> dict[str, Reals]:
    """What a `FlankCompliance` has, by finite elements."""
    began = time.perf_counter()
    roll, influence, asymmetry = _influence(gear, sector, material)
    return {
        "roll": roll,
        "axial": np.linspace(-0.5 * face_width, 0.5 * face_width, influence.shape[1] // len(roll)),
        "influence": influence,
        "depth": np.array(half_plane_depth(layer, material.poisson_ratio)),
        "asymmetry": np.array(asymmetry),
        "seconds": np.array(time.perf_counter() - began),
    }


def _from_arrays(arrays: dict[str, Reals]) -> FlankCompliance:
    numbers = (float(arrays[name]) for name in ("depth", "asymmetry", "seconds"))
    return FlankCompliance(arrays["roll"], arrays["axial"], arrays["influence"], *numbers)


def _key(gear: CylindricalGear, sector: GearSector, material: Material, layer: float) -> str:
    """Hash of all that a compliance depends on, besides what makes it."""
    numbers = np.array([material.youngs_modulus, material.poisson_ratio, layer, gear.base_helix_angle])
    arrays = (sector.points, sector.hexahedra, sector.flanks, sector.in_layer, sector.held, numbers)
    return kept.digest([repr(gear).encode(), *(array.tobytes() for array in arrays)])


@cache
def _makers() -> str:
    """Hash of the sources that make a compliance, and of the versions of what they call."""
    here = Path(__file__).parent
    sources = [(here / f"{name}.py").read_bytes() for name in MAKERS]
    return kept.digest([*sources, *(version(name).encode() for name in ("scikit-fem", "scipy", "numpy"))])


def pair_compliances(
    pair: CylindricalPair,
    face_widths: tuple[float, float],
    materials: tuple[Material, Material] | None = None,
    settings: SectorSettings | None = None,
    keep: bool = True,
) -> tuple[FlankCompliance, FlankCompliance]:
    """Compliance of pinion and gear, each in a thread of its own.

    Parameters
    ----------
    pair : CylindricalPair
        Where both gears have a helix angle of the same sign, that of the pinion counts and the gear has the
        other hand.
    face_widths : (float, float)
        b of pinion and gear, m; above 0.
    materials : (Material, Material), optional
        Steel where nothing is given.
    settings : SectorSettings, optional
    keep : bool
        As of `flank_compliance`.

    Returns
    -------
    (FlankCompliance, FlankCompliance)

    Raises
    ------
    GearlashError, MissingExtraError
        As `flank_compliance`.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.multibody.compliance import SectorSettings, pair_compliances
    >>> from gearlash.multibody.tooth_section import Fineness
    >>> coarse = SectorSettings(Fineness(flank=2, fillet=1, core=1, rim=1, axial=2), teeth=3)
    >>> pair = CylindricalPair(CylindricalGear(20, 4e-3), CylindricalGear(30, 4e-3))
    >>> pinion, gear = pair_compliances(pair, (0.02, 0.02), settings=coarse)
    >>> pinion.depth == gear.depth
    True
    """
    steel = named("steel")
    both = (steel, steel) if materials is None else materials
    pinion, gear = pair.gears
    mate = gear.mirrored() if pinion.helix_angle * gear.helix_angle > 0.0 else gear
    with ThreadPoolExecutor(2) as pool:
        waiting = [
            pool.submit(flank_compliance, one, width, material, settings, keep)
            for one, width, material in zip((pinion, mate), face_widths, both, strict=True)
        ]
    return waiting[0].result(), waiting[1].result()


def _odd_at_most(teeth: int, all_teeth: int) -> int:
    """A sector is less than the whole gear."""
    return min(teeth, all_teeth - 1 - all_teeth % 2)


def _influence(gear: CylindricalGear, sector: GearSector, material: Material) -> tuple[Reals, Reals, float]:
    """Roll lengths; influence of the middle tooth's flank on all, without the layer; and its asymmetry."""
    model = elastic_model(sector.points, sector.hexahedra, material)
    flanks = [flank_loads(gear, model, flank) for flank in sector.flanks]
    loads = [flank.forces for flank in flanks]
    middle = len(loads) // 2
    whole = _displacements(model, sector.held, loads[middle])
    raw = np.stack([(load.T @ whole).T for load in loads])
    raw[middle] -= _layer_influence(gear, sector, sector.flanks[middle], material)
    mirrored = raw[::-1].transpose(0, 2, 1)
    asymmetry = float(np.abs(raw - mirrored).max() / np.abs(raw).max())
    return flanks[middle].roll, 0.5 * (raw + mirrored), asymmetry


def _layer_influence(gear: CylindricalGear, sector: GearSector, flank: Integers, material: Material) -> Reals:
    """Of the layer below a flank alone, held where it joins the rest."""
    hexahedra = sector.hexahedra[sector.in_layer]
    own, inside = np.unique(hexahedra, return_inverse=True)
    model = elastic_model(sector.points[own], inside.reshape(hexahedra.shape), material)
    joined = np.isin(own, sector.hexahedra[~sector.in_layer])
    load = flank_loads(gear, model, np.searchsorted(own, flank)).forces
    return load.T @ _displacements(model, joined, load)


def _displacements(model: ElasticModel, held: NDArray[np.bool_], loads: sparse.csc_array) -> Reals:
    """Displacements under each load, shape (dof, loads); some corners held, and the edges between them."""
    nodes = np.append(held, held[model.edges].all(axis=1))
    free = np.flatnonzero(~np.repeat(nodes, 3))
    matrix = model.stiffness[free][:, free].tocsc()
    factors = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    pushed = loads.toarray()[free]
    whole = np.zeros((len(nodes) * 3, pushed.shape[1]))
    for load in range(pushed.shape[1]):  # one by one: for many at once SuperLU takes twice as long
        whole[free, load] = factors.solve(np.ascontiguousarray(pushed[:, load]))
    return whole
