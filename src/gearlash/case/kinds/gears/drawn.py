"""Places for what a drawing says of a gear pair and no model takes: values are estimated from it."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace

from gearlash.case.quantity import Choice, Quantity
from gearlash.case.units import ANGLE, DENSITY, LENGTH, POWER, PRESSURE, TORQUE
from gearlash.gears import basic_rack, gear_fits
from gearlash.gears.materials import MATERIALS
from gearlash.gears.mesh import harmonic_name

from . import relief, written
from .keys import GEARS
from .shared import HIGHEST_HARMONIC, NO_RING, RIGHT_ANGLE, expansion, nominal, number, positive, speed

RACKS = {
    "ISO53-A": basic_rack.ISO53_A,
    "ISO53-B": basic_rack.ISO53_B,
    "ISO53-C": basic_rack.ISO53_C,
    "ISO53-D": basic_rack.ISO53_D,
    "DIN867": basic_rack.ISO53_A,
    "stub": basic_rack.STUB,
}
RACK, TIPS = "mesh.rack", "mesh.tips"
SHORTENED = "shortened"
TRANSVERSE_MODULE, TRANSVERSE_ANGLE = "mesh.transverse_module", "mesh.transverse_pressure_angle"
PITCH, TRANSVERSE_PITCH = "mesh.diametral_pitch", "mesh.transverse_diametral_pitch"
FITS = tuple(
    f"{tolerance}{allowance}" for tolerance in range(21, 31) for allowance in gear_fits.ALLOWANCE_SERIES
)
GEAR_SPEED, GEAR_TORQUE, POWERED = "operation.gear_speed", "operation.gear_torque", "operation.power"
SPEED_RANGE = "operation.least_speed", "operation.greatest_speed"
GEAR_RANGE = "operation.least_gear_speed", "operation.greatest_gear_speed"
PLAY = "mesh.backlash_circumferential"
WIDTH = "mesh.face_width"
BOTH_WIDTHS = {WIDTH: ("pinion.face_width", "gear.face_width")}
CENTRE, SHIFT_SUM = "mesh.centre_distance", "mesh.shift_sum"
MEASURES = ("span", "over_balls", "over_pins", "tooth_thickness")
"""What is measured on a gear: it tells the profile shift, or the allowance beside a stated shift."""
MODULES = "mesh.module", "mesh.normal_module", TRANSVERSE_MODULE, PITCH, TRANSVERSE_PITCH
ANGLES = "mesh.pressure_angle", TRANSVERSE_ANGLE
TEETH = frozenset(("pinion.teeth", "gear.teeth", "mesh.helix_angle", *MODULES, *ANGLES))
"""What teeth follow from at least."""
SAME: tuple[tuple[str, ...], ...] = (
    ("omega", GEAR_SPEED),
    ("load", GEAR_TORQUE, POWERED),
    *zip(SPEED_RANGE, GEAR_RANGE, strict=True),
    ("D", PLAY),
    (CENTRE, SHIFT_SUM),
    *(tuple(f"{gear}.{leaf}" for leaf in MEASURES) for gear in GEARS),
    MODULES,
    ANGLES,
    *((f"{gear}.profile_shift", f"{gear}.transverse_profile_shift") for gear in GEARS),
    *((f"{gear}.tip_diameter", f"{gear}.tip_alteration") for gear in GEARS),
    *relief.SAME,
)
"""Keys of which one is stated; another one takes its place."""
_ORDERS = range(1, HIGHEST_HARMONIC + 1)
ERRORS = frozenset(harmonic_name("error", n) for n in _ORDERS)
LOADED = frozenset(harmonic_name("mesh.loaded_error", n) for n in _ORDERS)
_OF_LOADED = {
    *LOADED, *(harmonic_name("mesh.loaded_error_phase", n) for n in _ORDERS), "mesh.loaded_error_torque"
}  # fmt: skip


def rivals(key: str) -> tuple[str, ...]:
    """The other keys that say the same."""
    if key in ERRORS or key in _OF_LOADED:  # one of them takes the place of all of the other
        return tuple(LOADED if key in ERRORS else ERRORS)
    return next((tuple(k for k in group if k != key) for group in SAME if key in group), ())


def contradicted(entries: Collection[str]) -> list[tuple[str, str]]:
    """Pairs of keys that are both stated and say the same."""
    found = []
    for group in SAME:
        stated = [key for key in group if key in entries]
        found += [(stated[0], other) for other in stated[1:]]
    return found


def of_gear(gear: str) -> Iterator[Quantity]:
    """What the table [pinion] or [gear] may hold."""
    yield number(f"{gear}.profile_shift", "0.2", f"profile shift x of the {gear}, over m_n", -3.0, 3.0)
    what = f"profile shift x_t of the {gear} in the transverse section, over m_t"
    yield number(f"{gear}.transverse_profile_shift", "0.2", what, -3.0, 3.0)
    yield positive(f"{gear}.span", LENGTH, "mm", "32.83 mm", f"span measurement W_k of the {gear}", 50)
    what = "teeth k that it is measured over"
    yield number(f"{gear}.span_teeth", "4", what, 1, 2000, integer=True)
    for leaf, name in (("over_balls", "balls M_dK"), ("over_pins", "pins M_dR")):
        what = f"dimension over two {name} of the {gear}"
        yield positive(f"{gear}.{leaf}", LENGTH, "mm", "58.08 mm", what, 50)
    what = f"normal tooth thickness s_n of the {gear} on the reference circle"
    yield positive(f"{gear}.tooth_thickness", LENGTH, "mm", "4.71 mm", what, 0.5)
    what = f"diameter D_M of balls or pins in the {gear}"
    yield positive(f"{gear}.ball_diameter", LENGTH, "mm", "3.5 mm", what, 1)
    what = f"allowance E_sn of the normal tooth thickness of the {gear}"
    yield Quantity(f"{gear}.thickness_allowance", LENGTH, "um", "-70 um", what, -0.02, 0.001)
    yield positive(f"{gear}.tip_diameter", LENGTH, "mm", "93 mm", f"tip diameter d_a of the {gear}", 50)
    what = f"tip alteration k m_n of the {gear}: what its tip radius has more than by rack and shift"
    yield Quantity(f"{gear}.tip_alteration", LENGTH, "mm", "-0.1 mm", what, -0.1, 0.1)
    what = f"addendum h_aP of the basic rack of the {gear}, over m_n"
    yield number(f"{gear}.addendum", "1.0", what, 0.3, 2.0)
    what = f"dedendum h_fP of the basic rack of the {gear}, over m_n"
    yield number(f"{gear}.dedendum", "1.25", what, 0.3, 2.5)
    what = f"root fillet radius ρ_fP of the basic rack of the {gear}, over m_n"
    yield number(f"{gear}.root_radius", "0.38", what, 0.0, 1.0)
    yield positive(f"{gear}.root_diameter", LENGTH, "mm", "80 mm", f"root diameter d_f of the {gear}", 50)
    what = f"bore of the {gear}, or diameter of the shaft it is one piece with"
    yield positive(f"{gear}.bore", LENGTH, "mm", "30 mm", what, 50)
    what = f"diameter of the shaft of the {gear} in its bearings; the bore where none is stated"
    yield positive(f"{gear}.shaft_diameter", LENGTH, "mm", "25 mm", what, 50)
    what = f"distance of the two bearings of the {gear}'s shaft, from middle to middle"
    yield positive(f"{gear}.bearing_span", LENGTH, "mm", "120 mm", what, 50)
    what = f"inner diameter of the rim of the {gear}"
    yield positive(f"{gear}.rim_diameter", LENGTH, "mm", "140 mm", what, 50)
    yield positive(f"{gear}.web_width", LENGTH, "mm", "15 mm", f"width of the web of the {gear}", 5)
    what = f"Young's modulus E of the {gear}, in place of that of its material"
    yield positive(f"{gear}.youngs_modulus", PRESSURE, "GPa", "206 GPa", what, 1e13)
    what = f"Poisson's ratio ν of the {gear}, in place of that of its material"
    yield number(f"{gear}.poisson_ratio", "0.3", what, 0.0, 0.499)
    what = f"density ρ of the {gear}, in place of that of its material"
    yield positive(f"{gear}.density", DENSITY, "kg/m^3", "7830 kg/m^3", what, 1e5)
    what = f"coefficient of linear thermal expansion of the {gear}, in place of that of its material"
    yield expansion(f"{gear}.thermal_expansion", what)
    yield number(
        f"{gear}.quality",
        "7",
        f"flank tolerance class of the {gear}, ISO 1328-1",
        1,
        12,
        integer=True,
        reader=written.tolerance_class,
    )
    yield from relief.of_gear(gear)


def of_mesh() -> Iterator[Quantity]:
    """What the table [mesh] may hold."""
    yield positive(WIDTH, LENGTH, "mm", "40 mm", "face width b of both gears", 5)
    ring = f"below 0 it is that of an internal gear, {NO_RING}"
    alone = "they stand at mesh.centre_distance_deviation, or as its grade at mesh.distance_grade"
    distance = positive(CENTRE, LENGTH, "mm", "125 mm", "centre distance a_w", 50)
    yield replace(distance, below=ring, alone=alone)
    yield number(SHIFT_SUM, "0.4", "sum of the profile shifts x_1 + x_2", -6.0, 6.0)
    yield nominal(positive(TRANSVERSE_MODULE, LENGTH, "mm", "4.2 mm", "transverse module m_t", 0.2))
    what = "transverse pressure angle α_t"
    yield nominal(positive(TRANSVERSE_ANGLE, ANGLE, "deg", "21 deg", what, RIGHT_ANGLE))
    read = written.diametral_pitch
    what = "normal diametral pitch P_n, teeth per inch"
    yield nominal(number(PITCH, "8", what, 0.1, 500.0, reader=read))
    what = "transverse diametral pitch P_t, teeth per inch"
    yield nominal(number(TRANSVERSE_PITCH, "7.7", what, 0.1, 500.0, reader=read))
    what = "tolerance grade of the centre distance: the 7 of js7"
    yield number("mesh.distance_grade", "7", what, 5, 11, integer=True)
    yield Quantity(PLAY, LENGTH, "um", "100 um", "whole backlash j_wt on the working circle", 0.0, 0.02)


def of_operation() -> Iterator[Quantity]:
    """What the table [operation] may hold."""
    yield speed(GEAR_SPEED, "1200 rpm", "speed of the gear")
    what = "mean torque of the gear; negative loads the back side"
    yield Quantity(GEAR_TORQUE, TORQUE, "N*m", "900 N·m", what, -1e9, 1e9)
    what = "power at the stated speed; the torque that follows is kept where the speed varies"
    yield Quantity(POWERED, POWER, "kW", "45 kW", what, -1e12, 1e12)
    for who, paths in (("pinion", SPEED_RANGE), ("gear", GEAR_RANGE)):
        for path, name, example in zip(paths, ("least", "greatest"), ("1500 rpm", "4500 rpm"), strict=True):
            place = speed(path, example, f"{name} speed that the {who} is to run at")
            yield replace(place, reader=written.least_speed) if name == "least" else place


def options() -> Iterator[Choice]:
    """Named options; each is the default where a drawing does not say."""
    for gear in GEARS:
        what = f"material of the {gear}; by its designation, too"
        yield Choice(f"{gear}.material", tuple(MATERIALS), "steel", what, reader=written.material)
        yield Choice(f"{gear}.fit", FITS, "25cd", f"fit of the {gear}'s teeth, DIN 3967", reader=written.fit)
    yield Choice(RACK, tuple(RACKS), "ISO53-A", "standard basic rack that cuts both gears")
    what = "tips that nobody states: full, or shortened so that the rack's clearance is kept"
    yield Choice(TIPS, ("full", SHORTENED), "full", what)
    yield from relief.options()


KEYS = frozenset(
    place.path
    for place in (*(q for gear in GEARS for q in of_gear(gear)), *of_mesh(), *of_operation(), *options())
)
"""Words of a drawing."""
BEARING_SPANS = tuple(f"{gear}.bearing_span" for gear in GEARS)
GEOMETRY = KEYS - {
    GEAR_SPEED, GEAR_TORQUE, POWERED, WIDTH, *SPEED_RANGE, *GEAR_RANGE, *BEARING_SPANS
}  # fmt: skip
"""Those that say something of the teeth or their bodies."""
