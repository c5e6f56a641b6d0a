"""The physics of gear pairs: geometry, inertia, mesh; helical and spur pairs as families of systems.

Nothing here knows a case file or a unit: lengths in m, angles in rad, masses in kg, or dimensionless numbers.

Everything here is imported when it is first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:  # the same names for type checkers; a test keeps the lists equal
    from . import backlash as backlash
    from . import bearings as bearings
    from . import drawing as drawing
    from . import dynamic_factor as dynamic_factor
    from . import estimates as estimates
    from . import flank_modification as flank_modification
    from . import flank_tolerances as flank_tolerances
    from . import gear_body as gear_body
    from . import gear_fits as gear_fits
    from . import helical as helical
    from . import inspection as inspection
    from . import loaded_mesh as loaded_mesh
    from . import materials as materials
    from . import mesh_cycle as mesh_cycle
    from . import mesh_stiffness as mesh_stiffness
    from . import outline as outline
    from . import pair_shape as pair_shape
    from . import spur as spur
    from . import stiffness_estimates as stiffness_estimates
    from . import tooth_form as tooth_form
    from . import tooth_pair as tooth_pair
    from . import unloaded_error as unloaded_error
    from . import waveform as waveform
    from .basic_rack import BasicRack as BasicRack
    from .cylindrical_gear import CylindricalGear as CylindricalGear
    from .cylindrical_pair import CylindricalPair as CylindricalPair
    from .geometry import LineOfAction as LineOfAction
    from .geometry import Projection as Projection
    from .geometry import ToothGeometry as ToothGeometry
    from .geometry import YAxis as YAxis
    from .geometry import line_of_action as line_of_action
    from .helical import HelicalPair as HelicalPair
    from .inertia import disc_face_width as disc_face_width
    from .inertia import equivalent_mass as equivalent_mass
    from .inertia import solid_disc as solid_disc
    from .root_fillet import RootFillet as RootFillet

_WHERE = {
    "BasicRack": "basic_rack",
    "CylindricalGear": "cylindrical_gear",
    "CylindricalPair": "cylindrical_pair",
    "LineOfAction": "geometry",
    "Projection": "geometry",
    "ToothGeometry": "geometry",
    "YAxis": "geometry",
    "line_of_action": "geometry",
    "HelicalPair": "helical",
    "disc_face_width": "inertia",
    "equivalent_mass": "inertia",
    "solid_disc": "inertia",
    "RootFillet": "root_fillet",
}
"""The file of every name that is no file itself."""

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
    "bearings",
    "disc_face_width",
    "drawing",
    "dynamic_factor",
    "equivalent_mass",
    "estimates",
    "flank_modification",
    "flank_tolerances",
    "gear_body",
    "gear_fits",
    "helical",
    "inspection",
    "line_of_action",
    "loaded_mesh",
    "materials",
    "mesh_cycle",
    "mesh_stiffness",
    "outline",
    "pair_shape",
    "solid_disc",
    "spur",
    "stiffness_estimates",
    "tooth_form",
    "tooth_pair",
    "unloaded_error",
    "waveform",
]


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    module = import_module(f"{__name__}.{_WHERE.get(name, name)}")
    value = getattr(module, name) if name in _WHERE else module
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return list(__all__)
