"""The words of a drawing as options of `gearlash new`, as questions, and as places of a case file."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from .strokes import names, quantities

GEARS = ("pinion", "gear")
LEAST_TEETH = 5
_NUMBERS = re.compile(r"\d+(?:[.,]\d+)?", re.ASCII)
_OF_TEETH = re.compile(r"\bz(?:[\s_]?[12₁₂](?!\d)|p|g)?\s*[=:]*", re.IGNORECASE)
"""The letter of a number of teeth: z1 =."""
_GEAR_FIRST = re.compile(r"\b(?:gear|wheel|rad)\b.*\b(?:pinion|ritzel)\b", re.IGNORECASE)
_OF_BEARINGS = re.compile(r"\.((bearing|shaft|housing)_stiffness_|added_mass)")


@dataclass(frozen=True)
class Word:
    """One word of a drawing.

    Parameters
    ----------
    name : str
        Of the option, with _ for -.
    path : str
        In the case file; ``{gear}`` for pinion and gear.
    example : str
    what : str
    question : bool
        Whether it is asked for at a terminal.
    needed : bool
        Whether nothing can be said without it.
    """

    name: str
    path: str
    example: str
    what: str
    question: bool = False
    needed: bool = False

    @property
    def paths(self) -> tuple[str, ...]:
        """Of pinion and gear, or of the pair."""
        return tuple(dict.fromkeys(self.path.format(gear=gear) for gear in GEARS))

    @property
    def option(self) -> str:
        """As it is typed."""
        return f"--{self.name.replace('_', '-')}"


WORDS = (
    Word("teeth", "{gear}.teeth", "25/57", "Teeth of pinion and gear.", True, True),
    Word("module", "mesh.normal_module", "3mm", "Normal module m_n.", True, True),
    Word("transverse_module", "mesh.transverse_module", "3.1mm", "Transverse module m_t, in place of that."),
    Word(
        "diametral_pitch",
        "mesh.diametral_pitch",
        "8",
        "Normal diametral pitch P_n in teeth per inch, in place of that.",
    ),
    Word(
        "transverse_diametral_pitch",
        "mesh.transverse_diametral_pitch",
        "7.7",
        "Transverse diametral pitch P_t, in place of that.",
    ),
    Word(
        "pressure_angle",
        "mesh.pressure_angle",
        "20deg",
        "Normal pressure angle α_n; 20° where none is given.",
        True,
    ),
    Word(
        "transverse_pressure_angle",
        "mesh.transverse_pressure_angle",
        "20.6deg",
        "Transverse pressure angle α_t, in place of that.",
    ),
    Word("helix_angle", "mesh.helix_angle", "15deg", "Helix angle β; spur teeth where none is given.", True),
    Word("face_width", "{gear}.face_width", "40mm", "Face width b.", True),
    Word("profile_shift", "{gear}.profile_shift", "0.3/0.1", "Profile shift x.", True),
    Word(
        "transverse_profile_shift",
        "{gear}.transverse_profile_shift",
        "0.3/0.1",
        "Profile shift x_t over m_t, in place of that.",
    ),
    Word("span", "{gear}.span", "32.83mm/68.9mm", "Span measurement W_k.", True),
    Word("span_teeth", "{gear}.span_teeth", "4/8", "Teeth k that W_k is measured over.", True),
    Word("over_balls", "{gear}.over_balls", "83.9mm/", "Dimension over two balls M_dK.", True),
    Word("over_pins", "{gear}.over_pins", "83.9mm/", "Dimension over two pins M_dR."),
    Word(
        "ball_diameter",
        "{gear}.ball_diameter",
        "5mm",
        "Diameter D_M of balls or pins; 1.75 m_n where none is given.",
        True,
    ),
    Word(
        "tooth_thickness",
        "{gear}.tooth_thickness",
        "5.4mm/4.9mm",
        "Normal tooth thickness s_n on the reference circle.",
    ),
    Word(
        "thickness_allowance",
        "{gear}.thickness_allowance",
        "-70um",
        "Allowance E_sn of the normal tooth thickness.",
    ),
    Word("tip_diameter", "{gear}.tip_diameter", "83mm/182mm", "Tip diameter d_a."),
    Word(
        "tip_alteration",
        "{gear}.tip_alteration",
        "-0.1mm",
        "Tip alteration k m_n, below 0 where tips are shortened.",
    ),
    Word("tips", "mesh.tips", "shortened", "Tips that nobody states: full, or shortened by k m_n."),
    Word("root_diameter", "{gear}.root_diameter", "70mm/169mm", "Root diameter d_f."),
    Word("rack", "mesh.rack", "ISO53-A", "Basic rack: ISO53-A to ISO53-D, DIN867 or stub."),
    Word("addendum", "{gear}.addendum", "1.0", "Addendum h_aP of the rack over m_n, in place of its own."),
    Word("dedendum", "{gear}.dedendum", "1.25", "Dedendum h_fP of the rack over m_n, in place of its own."),
    Word(
        "root_radius", "{gear}.root_radius", "0.38", "Root fillet radius ρ_fP of the rack over m_n, likewise."
    ),
    Word("centre_distance", "mesh.centre_distance", "128mm", "Centre distance a_w.", True),
    Word("shift_sum", "mesh.shift_sum", "0.4", "Sum of the profile shifts."),
    Word(
        "distance_grade", "mesh.distance_grade", "7", "Tolerance grade of the centre distance: the 7 of js7."
    ),
    Word("bore", "{gear}.bore", "30mm/50mm", "Bore, or diameter of the shaft it is one piece with.", True),
    Word(
        "shaft_diameter",
        "{gear}.shaft_diameter",
        "25mm/",
        "Diameter of the shaft in its bearings; the bore where none is given.",
    ),
    Word(
        "bearing_span",
        "{gear}.bearing_span",
        "120mm/",
        "Distance of the two bearings of the shaft, which bends between them: `verify` and the range of "
        "estimated bearings have it.",
    ),
    Word("rim_diameter", "{gear}.rim_diameter", "/140mm", "Inner diameter of the rim."),
    Word("web_width", "{gear}.web_width", "/15mm", "Width of the web."),
    Word(
        "material", "{gear}.material", "steel/POM", "Material by its name; steel where none is given.", True
    ),
    Word(
        "youngs_modulus", "{gear}.youngs_modulus", "/110GPa", "Young's modulus E, in place of its material's."
    ),
    Word("poisson_ratio", "{gear}.poisson_ratio", "/0.35", "Poisson's ratio ν, likewise."),
    Word("density", "{gear}.density", "/8800kg/m^3", "Density ρ, likewise."),
    Word(
        "thermal_expansion",
        "{gear}.thermal_expansion",
        "/18um/(m*K)",
        "Coefficient of linear thermal expansion, likewise.",
    ),
    Word("quality", "{gear}.quality", "7", "Flank tolerance class of ISO 1328-1.", True),
    Word(
        "tip_relief",
        "{gear}.tip_relief",
        "20um",
        "Tip relief C_αa; stiffness, contact ratio and error then follow the torque.",
        True,
    ),
    Word(
        "tip_relief_length",
        "{gear}.tip_relief_length",
        "2mm",
        "Roll length of the tip relief; half of (ε_α − 1) p_bt where none is given.",
    ),
    Word(
        "tip_relief_diameter",
        "{gear}.tip_relief_diameter",
        "79mm/178mm",
        "Diameter at which the tip relief begins, in place of that.",
    ),
    Word("root_relief", "{gear}.root_relief", "10um/", "Root relief C_αf."),
    Word("root_relief_length", "{gear}.root_relief_length", "2mm/", "Roll length of the root relief."),
    Word(
        "root_relief_diameter",
        "{gear}.root_relief_diameter",
        "73mm/",
        "Diameter at which the root relief begins, in place of that.",
    ),
    Word("relief_form", "mesh.relief_form", "linear", "How reliefs grow: linear or parabolic."),
    Word("profile_crowning", "{gear}.profile_crowning", "5um", "Profile crowning C_α."),
    Word("crowning", "{gear}.crowning", "8um", "Lead crowning C_β."),
    Word("fit", "{gear}.fit", "25cd/26c", "Fit of the teeth by DIN 3967."),
    Word("backlash", "mesh.backlash", "80um", "Whole normal backlash j_n.", True),
    Word(
        "backlash_circumferential",
        "mesh.backlash_circumferential",
        "85um",
        "Whole backlash j_wt on the working circle.",
    ),
    Word("temperature", "{gear}.temperature", "60degC", "Temperature at work; 20 °C where none is given."),
    Word("housing_temperature", "mesh.housing_temperature", "50degC", "Temperature of the housing at work."),
    Word("housing_material", "mesh.housing_material", "aluminium", "Material of the housing."),
    Word(
        "housing_thermal_expansion",
        "mesh.housing_thermal_expansion",
        "23um/(m*K)",
        "Its coefficient of linear thermal expansion, in place of its material's.",
    ),
    Word(
        "centre_distance_deviation",
        "mesh.centre_distance_deviation",
        "20um",
        "How much the centre distance is above the nominal one.",
    ),
    Word("mass", "{gear}.mass", "1.5kg/7kg", "Mass."),
    Word(
        "added_inertia",
        "{gear}.added_inertia",
        "0.002kg*m^2/",
        "Inertia of what turns rigidly with the gear, such as shaft, rotor or pulley, beside its own.",
        True,
    ),
    Word(
        "added_mass",
        "{gear}.added_mass",
        "2kg/",
        "Mass of it on the bearings of the gear; makes the bearings part of a spur pair too.",
        True,
    ),
    Word("inertia", "{gear}.inertia", "0.001kg*m^2/0.03kg*m^2", "Moment of inertia."),
    Word("mean_stiffness", "mesh.mean_stiffness", "8e8N/m", "Mean mesh stiffness along the normal."),
    Word("error", "mesh.error", "6um", "Zero-to-peak unloaded transmission error at the mesh frequency."),
    Word(
        "loaded_error",
        "mesh.loaded_error",
        "8um",
        "The same under load, in place of that: what the stiffness makes of it is taken out.",
    ),
    Word(
        "loaded_error_torque",
        "mesh.loaded_error_torque",
        "150Nm",
        "Torque of the pinion that it was found at.",
    ),
    Word("damping_ratio", "mesh.damping_ratio", "0.07", "Damping ratio of the mesh."),
    Word(
        "bearing_y",
        "{gear}.bearing_stiffness_y",
        "3e8N/m",
        "Lateral bearing stiffness; makes the bearings part of a spur pair too.",
    ),
    Word("bearing_z", "{gear}.bearing_stiffness_z", "1e8N/m", "Axial bearing stiffness."),
    Word(
        "shaft_y",
        "{gear}.shaft_stiffness_y",
        "5e8N/m",
        "Lateral shaft stiffness, in series with the bearing.",
    ),
    Word(
        "shaft_z", "{gear}.shaft_stiffness_z", "2e9N/m", "Axial shaft stiffness, in series with the bearing."
    ),
    Word("housing_y", "{gear}.housing_stiffness_y", "9e8N/m", "Lateral housing stiffness, in series too."),
    Word("housing_z", "{gear}.housing_stiffness_z", "6e8N/m", "Axial housing stiffness, in series too."),
    Word("speed", "operation.pinion_speed", "4200rpm", "Speed of the pinion.", True, True),
    Word("gear_speed", "operation.gear_speed", "1842rpm", "Speed of the gear, in place of that."),
    Word("least_speed", "operation.least_speed", "1500rpm", "Least speed that the pinion is to run at."),
    Word(
        "greatest_speed", "operation.greatest_speed", "4500rpm", "Greatest one; `report` examines the range."
    ),
    Word("least_gear_speed", "operation.least_gear_speed", "660rpm", "The same of the gear, in place of it."),
    Word("greatest_gear_speed", "operation.greatest_gear_speed", "2000rpm", "Greatest one of the gear."),
    Word("torque", "operation.torque", "150N*m", "Torque of the pinion.", True, True),
    Word("gear_torque", "operation.gear_torque", "342N*m", "Torque of the gear, in place of that."),
    Word("power", "operation.power", "66kW", "Power, in place of a torque."),
)
EITHER = {
    "module": ("transverse_module", "diametral_pitch", "transverse_diametral_pitch"),
    "speed": ("gear_speed",),
    "torque": ("gear_torque", "power"),
}
"""Words that stand in for a needed one."""
NAMES = ("material", "fit")
"""Words that are no quantities."""
ONLY_BESIDE = {"span_teeth": "span", "ball_diameter": "over_balls", "added_mass": "added_inertia"}
"""Words that are asked for only where another one was answered."""


def placed(words: Mapping[str, str]) -> dict[str, str]:
    """Texts by path. One text stands for both gears; ``25/57`` are those of pinion and gear, one of which may
    be missing. Raises `GearlashError` for one that may be either, and for one number of teeth."""
    found: dict[str, str] = {}
    for word in WORDS:
        text = words.get(word.name)
        if text is None:
            continue
        parts = _parts(word, text)
        if len(parts) == 1:
            parts *= len(word.paths)
        found |= {path: part for path, part in zip(word.paths, parts, strict=True) if part}
    return found


def _parts(word: Word, text: str) -> list[str]:
    if len(word.paths) == 1:
        return [text.strip()]
    parts = names(text) if word.name in NAMES else quantities(word.option, text)
    if word.name == "teeth" and len(parts) == 1 and parts[0]:
        from gearlash.system import GearlashError  # late: help needs none of it

        raise GearlashError(
            f"{word.option} {parts[0]}: expected those of pinion and gear apart by a stroke, such as "
            f"{_teeth_in(parts[0])}"
        )
    return parts


def _teeth_in(text: str) -> str:
    """The numbers of teeth that a text has, as they are to be written; an example where it has others."""
    found = _NUMBERS.findall(_OF_TEETH.sub(" ", text))
    if len(found) not in (1, 2) or not all(each.isdigit() and int(each) >= LEAST_TEETH for each in found):
        return "25/57"
    if len(found) == 1:
        return f"{found[0]}/57, or {found[0]}/{found[0]} of equal gears"
    turned = _GEAR_FIRST.search(text) is not None
    return f"{found[turned]}/{found[not turned]}"


def is_helical(texts: Mapping[str, str]) -> bool:
    """Whether bearings are part of the model: where teeth at an angle press on them, or they are stated."""
    angle = texts.get("mesh.helix_angle", "0")
    turned = any(digit in angle for digit in "123456789") or not any(c.isdigit() for c in angle)
    return turned or any(_OF_BEARINGS.search(path) for path in texts)


def lacking(words: Iterable[str]) -> list[Word]:
    """Needed words that are not there."""
    there = set(words)
    return [w for w in WORDS if w.needed and there.isdisjoint({w.name, *EITHER.get(w.name, ())})]
