"""The physics of gear pairs: geometry, inertia, mesh; helical and spur pairs as families of systems.

Nothing here knows a case file or a unit: lengths in m, angles in rad, masses in kg, or dimensionless numbers.
"""

from . import (
    backlash,
    contact_lines,
    dynamic_factor,
    estimates,
    flank_tolerances,
    gear_body,
    gear_fits,
    helical,
    inspection,
    iso6336,
    materials,
    mesh_cycle,
    mesh_stiffness,
    pair_shape,
    spur,
    tooth_form,
    tooth_pair,
    unloaded_error,
    waveform,
)
from .basic_rack import BasicRack
from .cylindrical_gear import CylindricalGear
from .cylindrical_pair import CylindricalPair
from .geometry import LineOfAction, Projection, ToothGeometry, YAxis, line_of_action
from .helical import HelicalPair
from .inertia import disc_face_width, equivalent_mass, solid_disc
from .root_fillet import RootFillet

__all__ = [
    "BasicRack",
    "CylindricalGear",
    "CylindricalPair",
    "HelicalPair",
    "LineOfAction",
    "Projection",
    "RootFillet",
    "ToothGeometry",
    "YAxis",
    "backlash",
    "contact_lines",
    "disc_face_width",
    "dynamic_factor",
    "equivalent_mass",
    "estimates",
    "flank_tolerances",
    "gear_body",
    "gear_fits",
    "helical",
    "inspection",
    "iso6336",
    "line_of_action",
    "materials",
    "mesh_cycle",
    "mesh_stiffness",
    "pair_shape",
    "solid_disc",
    "spur",
    "tooth_form",
    "tooth_pair",
    "unloaded_error",
    "waveform",
]
