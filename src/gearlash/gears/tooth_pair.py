"""Stiffness of a pair of teeth along its path of contact, from the form of the teeth, material and load.

Deflection of each tooth along the line of action by Weber and Banaschek: bending, shear and compression of
the tooth, its foundation in the body, and the flattening of the contact. Per unit of length of the contact
line and force F/b, with E' = E/(1 − ν²) where the strain is plane:

    w_Z = (F/b) cos² α'/E [12 (1−ν²) ∫ (y_p − y)²/(2x)³ dy + (2.4 (1+ν) + (1−ν²) tan² α') ∫ dy/(2x)],
    w_R = (F/b) cos² α' (1−ν²)/(0.91 E) [5.2 (y_p/s_F)² + y_p/s_F + 1.4 (1 + 0.294 tan² α')],
    w_H = (2F/πb) Σ (1−ν²)/E [ln(2t/b_H) − ν/(2(1−ν))],   b_H² = (4F/πb) ρ Σ (1−ν²)/E.

α' is the load angle, y_p where the load meets the middle of the tooth above its foot, t how far the contact
is from the middle along the load, ρ the relative radius of curvature. ISO 6336-1 rests its c'_th on this
theory; its measured teeth were softer by the factor C_M = 0.8, which is not in here.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import cos, hypot, log, pi, sqrt, tan

import numpy as np
from numpy.typing import NDArray

from .cylindrical_pair import CylindricalPair
from .materials import Material, named
from .tooth_form import ToothForm, tooth_form

_form = lru_cache(maxsize=64)(tooth_form)
_gauss = lru_cache(maxsize=8)(np.polynomial.legendre.leggauss)


@dataclass(frozen=True)
class ToothLoad:
    """Where and how a load acts on a tooth, in the normal section.

    Parameters
    ----------
    angle : float
        α', between the load and the perpendicular to the middle of the tooth, rad.
    height : float
        y_p, above the foot, m.
    depth : float
        t, from the contact to the middle of the tooth along the load, m.
    """

    angle: float
    height: float
    depth: float


def tooth_load(form: ToothForm, curvature: float) -> ToothLoad:
    """The load at the point of the involute with this radius of curvature.

    Parameters
    ----------
    form : ToothForm
    curvature : float
        Of the flank in the normal section, m.

    Returns
    -------
    ToothLoad
    """
    base = form.base_radius
    angle = curvature / base - form.half_angle
    radius = hypot(base, curvature)
    half = form.half_angle - (curvature / base - float(np.arctan(curvature / base)))
    return ToothLoad(angle, base / cos(angle) - float(form.y[0]), radius * float(np.sin(half)) / cos(angle))


def tooth_compliance(form: ToothForm, load: ToothLoad, material: Material) -> float:
    """Deflection of one tooth and its foundation per unit of force and width, m²/N.

    Parameters
    ----------
    form : ToothForm
    load : ToothLoad
    material : Material

    Returns
    -------
    float
        (w_Z + w_R) b/F.
    """
    nu, slope = material.poisson_ratio, tan(load.angle) ** 2
    plane = 1.0 - nu**2
    height = load.height
    y = form.y - form.y[0]
    inside = y < height
    ends = np.append(y[inside], height)
    width = 2.0 * np.interp(ends, y, form.x)
    bending = float(np.trapezoid((height - ends) ** 2 / width**3, ends))
    shear = float(np.trapezoid(1.0 / width, ends))
    over = height / form.foot_thickness
    tooth = 12.0 * plane * bending + (2.4 * (1.0 + nu) + plane * slope) * shear
    body = plane / 0.91 * (5.2 * over**2 + over + 1.4 * (1.0 + 0.294 * slope))
    return cos(load.angle) ** 2 / material.youngs_modulus * (tooth + body)


def contact_compliance(
    loads: tuple[ToothLoad, ToothLoad],
    curvature: float,
    line_load: float,
    materials: tuple[Material, Material],
) -> float:
    """Flattening of the contact over the load, w_H b/F, m²/N.

    Parameters
    ----------
    loads : (ToothLoad, ToothLoad)
    curvature : float
        ρ, relative radius of curvature, m.
    line_load : float
        F/b, N/m; above 0.
    materials : (Material, Material)

    Returns
    -------
    float
    """
    plane = [(1.0 - one.poisson_ratio**2) / one.youngs_modulus for one in materials]
    half_width = sqrt(4.0 * line_load / pi * curvature * sum(plane))
    return sum(
        2.0 / pi * soft * (log(2.0 * load.depth / half_width) - 0.5 * nu / (1.0 - nu))
        for soft, load, nu in zip(plane, loads, (one.poisson_ratio for one in materials), strict=True)
    )


def pair_stiffness(
    pair: CylindricalPair,
    place: float,
    line_load: float,
    materials: tuple[Material, Material] | None = None,
) -> float:
    """Stiffness of one pair of teeth where it touches, in the normal section.

    Parameters
    ----------
    pair : CylindricalPair
    place : float
        Distance from the base tangent point T1 along the line of action, m; inside ``pair.path_of_contact``.
    line_load : float
        F/b along the contact line, N/m; above 0. The stiffness rises slowly with it.
    materials : (Material, Material), optional
        Of pinion and gear; steel where nothing is given.

    Returns
    -------
    float
        F/b over the whole deflection, N/m²: 10⁹ N/m² is 1 N/(mm µm). Comparable with c'_th of ISO 6336-1.

    References
    ----------
    C. Weber, K. Banaschek, Formänderung und Profilrücknahme bei gerad- und schrägverzahnten Rädern, Vieweg,
    Braunschweig 1953; its terms as collected in R. W. Cornell, J. Mech. Des. 103 (1981) 447.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair, mesh_stiffness
    >>> from gearlash.gears.tooth_pair import pair_stiffness
    >>> pair = CylindricalPair(CylindricalGear(30, 4e-3), CylindricalGear(60, 4e-3))
    >>> middle = 0.5 * sum(pair.path_of_contact)
    >>> round(pair_stiffness(pair, middle, 300e3) / mesh_stiffness.theoretical_stiffness(pair), 2)
    1.03
    """
    bodies = (named("steel"), named("steel")) if materials is None else materials
    loads, relative, teeth = _touch(pair, place, bodies)
    return 1.0 / (contact_compliance(loads, relative, line_load, bodies) + teeth)


@lru_cache(maxsize=4096)  # a mesh at another load asks for the same places
def _touch(
    pair: CylindricalPair, place: float, bodies: tuple[Material, Material]
) -> tuple[tuple[ToothLoad, ToothLoad], float, float]:
    """How both teeth are loaded at a place, the relative radius of curvature there, and their compliance."""
    oblique = cos(pair.pinion.base_helix_angle)
    curvatures = place / oblique, (pair.tangent_length - place) / oblique
    forms = [_form(gear) for gear in pair.gears]
    first, second = (tooth_load(form, rho) for form, rho in zip(forms, curvatures, strict=True))
    relative = curvatures[0] * curvatures[1] / sum(curvatures)
    teeth = sum(
        tooth_compliance(form, load, body)
        for form, load, body in zip(forms, (first, second), bodies, strict=True)
    )
    return (first, second), relative, teeth


@dataclass(frozen=True)
class CalculatedMesh:
    """A mesh made of slices whose pairs are as stiff as calculated.

    Parameters
    ----------
    mean : float
        Mean stiffness along the line of action normal to the flanks, N/m, without C_M.
    harmonics : ndarray of complex, shape (count,)
        c_1, c_2 … over the mean: η = 1 + Re Σ c_n exp(2πi n (ψ − ε_γ/2)), the phase counted from the middle
        of a pair's path.
    """

    mean: float
    harmonics: NDArray[np.complex128]


def calculated_mesh(
    pair: CylindricalPair,
    count: int,
    line_load: float,
    materials: tuple[Material, Material] | None = None,
) -> CalculatedMesh:
    """Mean and harmonics of the mesh stiffness from `pair_stiffness` along the path.

    Parameters
    ----------
    pair : CylindricalPair
        With its face width.
    count : int
        How many harmonics, from 1.
    line_load : float
        F/b along the contact lines, N/m; above 0.
    materials : (Material, Material), optional
        Steel where nothing is given.

    Returns
    -------
    CalculatedMesh
        Contact lines of mean length ε_α b / cos β_b; the slices across the face as in `gears.mesh_cycle`.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.gears.tooth_pair import calculated_mesh
    >>> pair = CylindricalPair(CylindricalGear(30, 4e-3), CylindricalGear(60, 4e-3), face_width=0.04)
    >>> abs(calculated_mesh(pair, 3, 300e3).harmonics).round(2).tolist()
    [0.24, 0.13, 0.04]
    """
    start, end = pair.path_of_contact
    ratio, orders = pair.transverse_contact_ratio, np.arange(count + 1)
    nodes, weights = _gauss(48 + 8 * count)  # enough for the highest harmonic
    places = 0.5 * nodes
    values = [pair_stiffness(pair, start + (end - start) * (u + 0.5), line_load, materials) for u in places]
    turns = np.exp(-2j * pi * ratio * np.outer(orders, places))
    transform = turns @ (0.5 * weights * np.array(values))
    length = ratio * pair.face_width / cos(pair.pinion.base_helix_angle)
    harmonics = 2.0 * np.sinc(orders * pair.overlap_ratio) * transform / transform[0]
    return CalculatedMesh(length * float(transform[0].real), harmonics[1:])
