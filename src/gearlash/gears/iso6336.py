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
_THEORY_TO_MEASUREMENT = 0.8
_SOLID_BODY = 1.0
_N_PER_MM_UM = 1e9  # 1 N/(mm·µm) in N/m²


def single_stiffness(geometry: ToothGeometry, dedendum: float = 1.25) -> float:
    """c′ per unit face width, N/m², of a solid steel pair with specific tooth load ≥ 100 N/mm.

    ``dedendum`` is h_fP/m_n of the basic rack. Zero profile shift.
    """
    beta = geometry.helix_angle
    virtual = [z / (cos(geometry.base_helix_angle) ** 2 * cos(beta)) for z in geometry.teeth]
    compliance = _COMPLIANCE[0] + _COMPLIANCE[1] / virtual[0] + _COMPLIANCE[2] / virtual[1]
    rack = (1.0 + 0.5 * (1.2 - dedendum)) * (1.0 - 0.02 * (20.0 - degrees(geometry.pressure_angle)))
    return _N_PER_MM_UM / compliance * _THEORY_TO_MEASUREMENT * _SOLID_BODY * rack * cos(beta)


def mesh_stiffness(geometry: ToothGeometry, face_width: float) -> float:
    """c_γα times the common face width (m), turned into a stiffness along the normal line of action, N/m.

    Force and deflection normal to the flank are F_t / cos β_b and δ_t cos β_b of the standard's transverse
    ones, so k = c_γα b / cos² β_b. The standard's formula holds for ε_α ≥ 1.2; below, it asks for up to 10 %
    less, as here.
    """
    ratio = geometry.transverse_contact_ratio
    reduction = 1.0 if ratio >= 1.2 else 0.9
    transverse = reduction * single_stiffness(geometry) * (0.75 * ratio + 0.25) * face_width
    return transverse / cos(geometry.base_helix_angle) ** 2
