"""What a gear engineer reads off teeth beside the model's numbers: dimensions of both gears, forces on the
shafts, and the mesh stiffness in the unit of ISO 6336."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, degrees, pi, sqrt, tan

from gearlash.gears import CylindricalGear, CylindricalPair, equivalent_mass, inspection, mesh_stiffness
from gearlash.gears.backlash import Backlash
from gearlash.system import GearlashError

from . import play
from .drawn import CENTRE, SHIFT_SUM
from .estimated import is_drawn
from .keys import GEARS
from .pair import GearPair
from .records import Derived

MM, UM = 1e3, 1e6
STANDARD = "ISO 21771-1"


def of_teeth(pair: GearPair) -> Iterator[Derived]:
    """Dimensions of the teeth of a drawing, and their play; nothing where teeth are not known."""
    body = pair.numbers.body
    if body.teeth is None or body.meshing is None:
        return
    yield from _of_pair(pair, body.meshing)
    for at, name in enumerate(GEARS):
        yield from _of_gear(pair, name, at, body.teeth)
    yield from _play(pair, body.meshing)


def under_torque(pair: GearPair) -> Iterator[Derived]:
    """Forces at the torque and speed of the case, of teeth whose module and angles are known."""
    scales, body = pair.scales, pair.numbers.body
    teeth = body.meshing or body.drawn
    if teeth is None or scales.radii is None:
        return
    torque = abs(float(scales.torque(pair.numbers.parameters["load"])))
    rolling = 0.5 * teeth.working_diameters[0]
    on_reference, on_working = 2.0 * torque / teeth.pinion.reference_diameter, torque / rolling
    along = tan(abs(teeth.pinion.helix_angle))
    normal = 2.0 * torque / teeth.pinion.base_diameter / cos(teeth.pinion.base_helix_angle)
    own, rolled = ("load", *_reference(pair)), ("load", *_rolling(pair))
    pressed = ("load", *_angles(pair))
    rows = (
        ("tangential_force", on_reference, "2 T_p/d_p", own, "F_t on the reference circles"),
        ("working_tangential_force", on_working, "2 T_p/d_wp", rolled, "F_wt on the working circles"),
        ("radial_force", on_working * tan(teeth.working_pressure_angle), "F_wt tan α_wt",
         (*pressed, *_centre(pair)), "F_r, pushes the shafts apart"),
        ("axial_force", on_reference * along, "F_t tan β", own, "F_a on each shaft, its size"),
        ("normal_force", normal, "2 T_p/(d_bp cos β_b)", pressed, "F_bn, normal to the flanks"),
    )  # fmt: skip
    for leaf, value, formula, inputs, text in rows:
        yield Derived(f"derived.{leaf}", value, "N", formula, inputs, f"{text}, at the mean torque")
    if body.face_width is not None:
        load, widths = 1e-3 * on_reference / body.face_width, _widths(pair)
        text = "line load w of the mean torque, on the common face width b"
        yield Derived("derived.line_load", load, "N/mm", "F_t/b", (*own, *widths), text)
    speed = float(scales.pinion_speed(pair.numbers.parameters["omega"])) * rolling
    text = "pitch line speed v, of the working circles"
    inputs = ("omega", *_rolling(pair))
    yield Derived("derived.pitch_line_speed", speed, "m/s", "π n_p d_wp", inputs, text)


def stiffness_per_width(pair: GearPair) -> Iterator[Derived]:
    """The mean mesh stiffness as ISO 6336-1 counts it: transverse, over the face width."""
    body, stiffness = pair.numbers.body, pair.scales.mean_stiffness
    if body.geometry is None or body.face_width is None or stiffness is None:
        return
    value = 1e-9 * stiffness * cos(body.geometry.base_helix_angle) ** 2 / body.face_width
    inputs = ("mesh.mean_stiffness", "mesh.pressure_angle", "mesh.helix_angle", *_widths(pair))
    text = "mean mesh stiffness c_γ per common face width, transverse, as in ISO 6336-1"
    yield Derived("derived.stiffness_per_width", value, "N/mm/um", "k_m cos² β_b/b", inputs, text)
    yield from _single(pair)
    if body.inertias is None:
        return
    standard = "ISO 6336-1:2019, clause 6"
    reduced = equivalent_mass(body.geometry.base_radii, body.inertias) / body.face_width
    masses = (*(f"{gear}.inertia" for gear in GEARS), *_angles(pair), *_widths(pair))
    text = "relative mass m_red of both gears per common face width, on the line of action"
    yield Derived("derived.reduced_mass", 1e-3 * reduced, "kg/mm", standard, masses, text)
    resonance = sqrt(1e9 * value / reduced) / body.geometry.teeth[0]
    text = "resonance speed n_E1 of the pinion, of both gears on this c_γ alone, without bearings"
    every = (*inputs, *masses)
    yield Derived(
        "derived.resonance_speed", 30.0 * resonance / pi, "rpm", "30000/(π z_1) √(c_γ/m_red)", every, text
    )
    ratio = float(pair.scales.pinion_speed(pair.numbers.parameters["omega"])) / resonance
    text = "resonance ratio N at the speed of the case"
    yield Derived("derived.resonance_ratio", ratio, "", "n_1/n_E1", ("omega", *every), text)


def _single(pair: GearPair) -> Iterator[Derived]:
    """c′ of teeth that a drawing tells, by the standard whether or not another stiffness is stated."""
    drawing = pair.completed.drawing
    if drawing is None or not is_drawn(pair.stated):
        return
    mesh = mesh_stiffness.method_b(drawing.meshing, drawing.chosen_materials, drawing.rims, drawing.line_load)
    inputs = (
        *_angles(pair), *_centre(pair), "load", "mesh.rack",
        *(f"{gear}.{leaf}" for gear in GEARS for leaf in ("material", "face_width")),
    )  # fmt: skip
    text = "single stiffness c′, the greatest of one pair of teeth, with rims and materials"
    yield Derived(
        "derived.single_stiffness", 1e-9 * mesh.single, "N/mm/um", mesh_stiffness.REFERENCE, inputs, text
    )


def _angles(pair: GearPair) -> tuple[str, ...]:
    return (pair.rules.module, "mesh.pressure_angle", "mesh.helix_angle", "pinion.teeth", "gear.teeth")


def _reference(pair: GearPair) -> tuple[str, ...]:
    """What the reference circles follow from: no pressure angle."""
    return tuple(path for path in _angles(pair) if path != "mesh.pressure_angle")


def _rolling(pair: GearPair) -> tuple[str, ...]:
    """What the working circles follow from: they share the centre distance by the numbers of teeth."""
    if CENTRE in pair.entries:
        return (*_centre(pair), "pinion.teeth", "gear.teeth")
    return (*_angles(pair), *_centre(pair))


def _widths(pair: GearPair) -> tuple[str, ...]:
    return tuple(f"{gear}.face_width" for gear in GEARS)


def _centre(pair: GearPair) -> tuple[str, ...]:
    """What the centre distance follows from."""
    if CENTRE in pair.entries:
        return (CENTRE, *play.stated(pair.entries))
    return (SHIFT_SUM, *(f"{gear}.profile_shift" for gear in GEARS), *play.stated(pair.entries))


def _of_pair(pair: GearPair, teeth: CylindricalPair) -> Iterator[Derived]:
    """Centre distance and working pressure angle, at work where that is stated."""
    inputs = (*_angles(pair), *_centre(pair))
    work = bool(play.stated(pair.entries))
    if not work:
        text = "centre distance a_w"
        found = MM * teeth.centre_distance
        yield Derived("derived.centre_distance", found, "mm", STANDARD, _rolling(pair), text)
    text = "α_wt" if not work else (
        "α_wt at the centre distance at work; contact ratio and stiffness are those of it"
    )  # fmt: skip
    angle = degrees(teeth.working_pressure_angle)
    yield Derived("derived.working_pressure_angle", angle, "deg", STANDARD, inputs, text)
    gear, start_end = teeth.pinion, teeth.path_of_contact
    rows = (
        ("transverse_module", MM * gear.transverse_module, "mm", _reference(pair), "transverse module m_t"),
        ("transverse_pressure_angle", degrees(gear.transverse_pressure_angle), "deg", _angles(pair),
         "transverse pressure angle α_t"),
        ("base_helix_angle", degrees(gear.base_helix_angle), "deg", _angles(pair),
         "helix angle β_b at the base cylinder"),
        ("base_pitch", MM * gear.transverse_base_pitch, "mm", _angles(pair), "transverse base pitch p_et"),
    )  # fmt: skip
    for leaf, value, unit, follows, text in rows:
        yield Derived(f"derived.{leaf}", value, unit, STANDARD, follows, text)
    length = MM * (start_end[1] - start_end[0])
    yield Derived(
        "derived.path_of_contact", length, "mm", STANDARD, inputs, "length of the path of contact g_α"
    )


def _of_gear(pair: GearPair, name: str, at: int, teeth: CylindricalPair) -> Iterator[Derived]:
    """Diameters and thicknesses of one gear at 20 °C, and how they are measured."""
    gear, own = teeth.gears[at], (*_angles(pair), f"{name}.profile_shift")
    thick = (*own, f"{name}.thickness_allowance", "mesh.rack")
    rows: tuple[tuple[str, float, tuple[str, ...], str], ...] = (
        ("reference_diameter", gear.reference_diameter, _reference(pair), "reference diameter d"),
        ("base_diameter", gear.base_diameter, _angles(pair), "base diameter d_b"),
        ("working_diameter", teeth.working_diameters[at], _rolling(pair), "working pitch diameter d_w"),
        ("tip_diameter", gear.tip_diameter, (*own, f"{name}.tip_diameter"), "tip diameter d_a"),
        ("root_diameter", gear.root_diameter, (*thick, f"{name}.root_diameter"), "root diameter d_f"),
        ("root_form_diameter", gear.root_form_diameter, thick, "root form diameter d_Ff"),
        ("active_root_diameter", teeth.active_root_diameters[at], (*own, *_centre(pair)),
         "active root diameter d_Nf"),
        ("tip_clearance", teeth.tip_clearances[at], (*thick, *_centre(pair)),
         "clearance c at the tip"),
        ("tooth_thickness", gear.normal_thickness(), thick, "normal tooth thickness s_n"),
        ("tip_thickness", gear.tip_thickness(), thick, "normal tooth thickness at the tip s_an"),
    )  # fmt: skip
    for leaf, value, inputs, text in rows:
        described = f"{text} of the {name}"
        yield Derived(f"derived.{leaf}_{name}", MM * value, "mm", STANDARD, inputs, described)
    yield from _measures(name, gear, thick, _measured_teeth(pair, name, gear), _ball_of(pair, name, gear))


def _measured_teeth(pair: GearPair, name: str, gear: CylindricalGear) -> int:
    """Teeth k that W_k is measured over: as stated, or the usual ones."""
    stated = pair.entries.get(f"{name}.span_teeth")
    return inspection.span_teeth(gear) if stated is None else int(stated.number)


def _ball_of(pair: GearPair, name: str, gear: CylindricalGear) -> float:
    """Diameter of balls or pins, m: as stated, or 1.75 m_n."""
    stated = pair.entries.get(f"{name}.ball_diameter")
    return 1.75 * gear.normal_module if stated is None else stated.number


def _measures(
    name: str, gear: CylindricalGear, inputs: tuple[str, ...], k: int, ball: float
) -> Iterator[Derived]:
    how = "DIN 21773"
    span = inspection.span_measurement(gear, k)
    yield Derived(f"derived.span_{name}", MM * span, "mm", how, inputs, f"span measurement W_k of the {name}")
    text = f"number of teeth k that W_k is over of the {name}"
    yield Derived(f"derived.span_teeth_{name}", float(k), "", "as stated, or DIN 3960", inputs, text)
    over = _over_balls(gear, ball)
    if over is not None:
        text = f"dimension over two balls M_dK of the {name}"
        yield Derived(f"derived.over_balls_{name}", MM * over, "mm", how, inputs, text)
        text = f"diameter of these balls D_M of the {name}"
        yield Derived(f"derived.ball_diameter_{name}", MM * ball, "mm", "as stated, or 1.75 m_n", (), text)


def _over_balls(gear: CylindricalGear, ball: float) -> float | None:
    """The dimension over two balls, m; None where such a ball does not rest on both flanks: it falls through,
    or touches above the tip."""
    try:
        found = inspection.dimension_over_balls(gear, ball)
        touched = inspection.ball_contact_diameter(gear, ball)
    except GearlashError:
        return None
    return found if touched < gear.tip_diameter else None


def _play(pair: GearPair, teeth: CylindricalPair) -> Iterator[Derived]:
    """The backlash of the model in the ways a drawing or a workshop says it."""
    normal = float(pair.scales.backlash_m(pair.numbers.parameters["D"]))
    found = Backlash.from_normal(teeth, normal)
    inputs = ("D", *_angles(pair), *_centre(pair))
    rows = (
        ("backlash_circumferential", UM * found.circumferential, "um", "j_n/(cos α_wt cos β_b)",
         "j_wt on the working circle"),
        ("backlash_radial", UM * found.radial, "um", "j_wt/(2 tan α_wt)",
         "j_r, how much nearer the axes could come"),
        ("backlash_angle_gear", 60.0 * degrees(found.angles[1]), "arcmin", "2 j_wt/d_wg",
         "j_φ, how far the gear turns while the pinion stands still"),
    )  # fmt: skip
    for leaf, value, unit, formula, text in rows:
        yield Derived(f"derived.{leaf}", value, unit, formula, inputs, f"whole backlash {text}")
