"""Estimates of the mesh stiffness and how it varies: of a drawing's flanks, at its torque."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from . import mesh_stiffness
from .cylindrical_pair import CylindricalPair
from .drawing import USUAL_LINE_LOAD, Drawing, Estimate
from .flank_modification import PairModification
from .loaded_mesh import ContactLines, LoadedMesh, contact_lines
from .materials import Material
from .mesh_cycle import ripple_ranges
from .pair_shape import PairShape
from .tooth_pair import calculated_mesh

_SHAPES = (
    "pairs of teeth by Weber and Banaschek, which touch beyond the path of contact as far as they bend; "
    "range: without load, equal stiffness per length, Cai and Hayashi, Sánchez et al., and what finite "
    "elements of teeth differ by"
)
OF_ELEMENTS = 0.35, 0.01
"""How far harmonics of teeth in finite elements lay from these, of themselves and of the mean stiffness, for
steel and plastics, spur and helical (docs/drawing.md)."""


def mean_stiffness(drawing: Drawing) -> Estimate:
    """ISO 6336-1, Method B: the mean that unmodified flanks have under the torque of the drawing, as measured
    teeth have it; of modified flanks the part that bears at this torque."""
    pair = drawing.meshing
    mesh = _solid_mesh(drawing)
    part = 1.0
    source = "; ".join((f"{mesh_stiffness.REFERENCE}, c_γα b / cos² β_b", *mesh.beyond))
    value, (least, greatest) = mesh.along_normal(pair.face_width), mesh.normal_range(pair.face_width)
    if drawing.modification.modified:
        bears = _lines(drawing).under(drawing.normal_force, _factor(drawing))
        part = bears.mean_stiffness / value
        source += f"; times {part:.4g}, the part of it that modified flanks have at this torque"
    return Estimate(part * value, part * least, part * greatest, source)


@lru_cache(maxsize=32)
def _factor(drawing: Drawing, shape: PairShape | None = None) -> float:
    """What contact lines are multiplied by, so that those of unmodified flanks have the mean stiffness of the
    standard at the torque of the drawing, with contact beyond the path of contact and with what pairs share.
    A published shape has neither of these, and all of it bears: its mean is that without load."""
    whole = _solid_mesh(drawing).along_normal(drawing.meshing.face_width)
    if shape is not None:
        return whole / _lines(drawing, shape).mean
    plain = replace(drawing, modification=PairModification())
    return _lines(plain).factor_of_mean(plain.normal_force, whole)


def _solid_mesh(drawing: Drawing) -> mesh_stiffness.MeshStiffness:
    return mesh_stiffness.method_b(drawing.meshing, drawing.chosen_materials, drawing.rims, drawing.line_load)


def _lines(drawing: Drawing, shape: PairShape | None = None) -> ContactLines:
    load = drawing.line_load or USUAL_LINE_LOAD
    return _kept_lines(drawing.meshing, drawing.modification, load, drawing.chosen_materials, shape)


_kept_lines = lru_cache(maxsize=8)(contact_lines)
"""Mean, variation and error of one torque ask for the same ones, whatever mean stiffness is stated."""


@lru_cache(maxsize=32)
def loaded_mesh(drawing: Drawing, shape: PairShape | None = None) -> LoadedMesh:
    """The mesh of a drawing's flanks at its torque.

    Parameters
    ----------
    drawing : Drawing
    shape : PairShape, optional
        A published shape of a pair's stiffness in place of the calculated one.

    Returns
    -------
    LoadedMesh
        Its mean stiffness is the stated one, or the estimated one (`mean_stiffness`).

    Raises
    ------
    GearlashError
        Where at some phase of the cycle no pair touches.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.gears.drawing import Drawing
    >>> from gearlash.gears.flank_modification import FlankModification, PairModification, Relief
    >>> from gearlash.gears.stiffness_estimates import loaded_mesh
    >>> pair = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), face_width=0.02)
    >>> tips = FlankModification(tip=Relief(15e-6, 1.5e-3))
    >>> mesh = loaded_mesh(Drawing(pair, torque=60.0, modification=PairModification(tips, tips)))
    >>> round(pair.transverse_contact_ratio, 2), round(mesh.contact_ratio, 2)
    (1.69, 1.51)
    """
    lines = _lines(drawing, shape)
    if drawing.stated_stiffness is not None:
        return lines.under_with_mean(drawing.normal_force, drawing.stated_stiffness)
    return lines.under(drawing.normal_force, _factor(drawing, shape))


def ripples(drawing: Drawing, count: int) -> dict[str, Estimate]:
    """Of the contact lines that bear at the torque of a drawing; amplitudes keep the sign that they have
    without load.

    Parameters
    ----------
    drawing : Drawing
    count : int
        How many harmonics, from 1.

    Returns
    -------
    dict
        ``ripple_1`` …, and their phases ``ripple_phase_1`` …, rad, from the middle of a pair's path.
    """
    modified = drawing.modification.modified
    own = loaded_mesh(drawing).stiffness_harmonics(count)
    others = _modified_shapes(drawing, count) if modified else _shapes(drawing, count)
    sign = np.where(own.real < 0.0, -1.0, 1.0)
    turned = np.vstack([own, others]) * sign * np.exp(-1j * np.angle(sign * own))
    along = turned.real * sign  # in the phase of the own one
    flanks = "modified" if modified else "unmodified"
    source = f"sliced contact lines of {flanks} flanks that bear at this torque; {_SHAPES}"
    share, size = OF_ELEMENTS
    found, phases = {}, {}
    for n, column in enumerate(along.T, start=1):
        value, apart = float(column[0]), share * abs(float(column[0])) + size
        least, greatest = min(float(column.min()), value - apart), max(float(column.max()), value + apart)
        found[f"ripple_{n}"] = Estimate(value, max(least, -2.0), min(greatest, 2.0), source)
        angle = float(np.angle(sign[n - 1] * own[n - 1]))
        phases[f"ripple_phase_{n}"] = Estimate(angle, angle, angle, "phase of the same contact lines")
    return found | phases


def _shapes(drawing: Drawing, count: int) -> NDArray[np.complex128]:
    """Harmonics of unmodified flanks without load, and of the published shapes."""
    load = drawing.line_load or USUAL_LINE_LOAD
    return _unloaded_shapes(drawing.meshing, count, load, drawing.chosen_materials)


@lru_cache(maxsize=8)  # the same whatever mean stiffness is stated
def _unloaded_shapes(
    pair: CylindricalPair, count: int, load: float, materials: tuple[Material, Material]
) -> NDArray[np.complex128]:
    unloaded = calculated_mesh(pair, count, load, materials).harmonics
    return np.vstack([unloaded, ripple_ranges(pair, count).astype(np.complex128)])


def _modified_shapes(drawing: Drawing, count: int) -> NDArray[np.complex128]:
    """The same of modified flanks at the torque of the drawing, which is what they have."""
    return np.array([loaded_mesh(drawing, shape).stiffness_harmonics(count) for shape in PairShape])
