"""Mesh stiffness by ISO 6336-1 (Method B): to hold a stated stiffness against, never used in a model.

ISO 6336-1:2019, *Calculation of load capacity of spur and helical gears – Part 1*, clause on tooth stiffness:
the single stiffness c′ of a steel pair from a regression in the virtual tooth numbers, and the mean mesh
stiffness c_γα = c′ (0.75 ε_α + 0.25), both per unit of face width and in the transverse plane.
"""

from __future__ import annotations

from math import cos, degrees

from .geometry import ToothGeometry

REFERENCE = "ISO 6336-1:2019, tooth stiffness, Method B"

# Regression of the tooth-pair compliance q′ for zero profile shift, mm·µm/N: constant, 1/z_n1, 1/z_n2.
_COMPLIANCE = (0.04723, 0.15551, 0.25791)


def single_stiffness(geometry: ToothGeometry, dedendum: float = 1.25) -> float:
    """Stiffness c′ of one pair of teeth of solid steel gears, without profile shift, at a load of 100 N/mm or
    more.

    Parameters
    ----------
    geometry : ToothGeometry
    dedendum : float
        h_fP/m_n of the basic rack.

    Returns
    -------
    float
        Per unit of face width, in the transverse plane, N/m².

    References
    ----------
    ISO 6336-1:2019, tooth stiffness, Method B.

    Examples
    --------
    >>> from math import radians
    >>> from gearlash.gears import ToothGeometry, iso6336
    >>> teeth = ToothGeometry((28, 70), 4e-3, radians(20), radians(18))
    >>> round(iso6336.single_stiffness(teeth) / 1e9, 2)  # N/(mm µm)
    13.42
    """
    to_si = 1e9  # 1 N/(mm·µm) in N/m²
    measured = 0.8  # C_M: measured over theoretical stiffness
    beta = geometry.helix_angle
    virtual = [z / (cos(geometry.base_helix_angle) ** 2 * cos(beta)) for z in geometry.teeth]
    compliance = _COMPLIANCE[0] + _COMPLIANCE[1] / virtual[0] + _COMPLIANCE[2] / virtual[1]
    rack = (1.0 + 0.5 * (1.2 - dedendum)) * (1.0 - 0.02 * (20.0 - degrees(geometry.pressure_angle)))
    return to_si / compliance * measured * rack * cos(beta)


def mesh_stiffness(geometry: ToothGeometry, face_width: float) -> float:
    """Mean stiffness of the mesh along the normal line of action, c_γα b / cos² β_b.

    Force and deflection normal to the flank are F_t / cos β_b and δ_t cos β_b of the standard's transverse
    ones. The standard's formula holds for ε_α ≥ 1.2; below that it asks for up to 10 % less, and 10 % less
    are taken.

    Parameters
    ----------
    geometry : ToothGeometry
    face_width : float
        Common face width b, m.

    Returns
    -------
    float
        N/m.

    References
    ----------
    ISO 6336-1:2019, tooth stiffness, Method B.

    Examples
    --------
    >>> from math import radians
    >>> from gearlash.gears import ToothGeometry, iso6336
    >>> teeth = ToothGeometry((28, 70), 4e-3, radians(20), radians(18))
    >>> round(iso6336.mesh_stiffness(teeth, 0.065) / 1e9, 2)
    1.38
    """
    ratio = geometry.transverse_contact_ratio
    reduction = 1.0 if ratio >= 1.2 else 0.9
    transverse = reduction * single_stiffness(geometry) * (0.75 * ratio + 0.25) * face_width
    return transverse / cos(geometry.base_helix_angle) ** 2
