"""Words of drawings, standards and papers, each with the names of a case file that they may mean."""

from __future__ import annotations

from collections.abc import Iterable

from gearlash.system.nearest import nearest

OTHER_WORDS: dict[str, tuple[str, ...]] = {
    "rpm": ("pinion_speed",),
    "speed": ("pinion_speed",),
    "n": ("pinion_speed",),
    "n_1": ("pinion_speed",),
    "rotational_speed": ("pinion_speed",),
    "frequency": ("mesh_frequency", "omega"),
    "f_z": ("mesh_frequency", "omega"),
    "m_n": ("normal_module", "module"),
    "module": ("normal_module",),
    "normal_module": ("module",),
    "modul": ("normal_module", "module"),
    "z": ("teeth",),
    "number_of_teeth": ("teeth",),
    "alpha": ("pressure_angle",),
    "alpha_n": ("pressure_angle",),
    "beta": ("helix_angle",),
    "helix": ("helix_angle",),
    "j": ("backlash",),
    "j_n": ("backlash",),
    "j_bn": ("backlash",),
    "jbn": ("backlash",),
    "j_t": ("backlash",),
    "b": ("face_width", "backlash"),
    "width": ("face_width",),
    "play": ("backlash",),
    "gap": ("backlash", "D"),
    "clearance": ("backlash", "D"),
    "half_backlash": ("D",),
    "weight": ("mass",),
    "m": ("mass",),
    "stiffness": ("mean_stiffness",),
    "mesh_stiffness": ("mean_stiffness",),
    "k": ("mean_stiffness",),
    "k_m": ("mean_stiffness",),
    "moment_of_inertia": ("inertia",),
    "j_p": ("inertia",),
    "t": ("torque",),
    "t_1": ("torque",),
    "moment": ("torque", "load"),
    "force": ("torque", "load"),
    "f_m": ("load",),
    "zeta": ("damping_ratio", "mesh_damping"),
    "xi": ("damping_ratio", "mesh_damping"),
    "xi_m": ("damping_ratio", "mesh_damping"),
    "xi_b": ("bearing_damping",),
    "damping": ("damping_ratio", "mesh_damping"),
    "transmission_error": ("error",),
    "te": ("error",),
    "ste": ("error",),
    "e": ("error",),
    "epsilon": ("ripple",),
    "eps": ("ripple",),
}


def nearest_name(name: object, valid: Iterable[str]) -> str | None:
    """The valid name that was probably meant, by its look or as another word for it."""
    return nearest(name, valid, OTHER_WORDS)
