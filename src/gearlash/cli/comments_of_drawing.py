"""What stands in the comments of a new case file: what follows from the pair, else an example of its size."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from math import cos, degrees, pi, sqrt

from gearlash.case import Case
from gearlash.case.kinds import Choice, Quantity, kind_named
from gearlash.case.rating import materials_of
from gearlash.gears import CylindricalGear, CylindricalPair, gear_fits, inspection
from gearlash.gears.backlash import Backlash
from gearlash.gears.bearings import bearing_span
from gearlash.gears.materials import OF_DATA_SHEETS, Material, named

from .words_of_drawing import GEARS

MEASURED = (
    "span", "span_teeth", "over_balls", "ball_diameter", "tip_diameter", "root_diameter", "tooth_thickness",
)  # fmt: skip
"""Words of a gear that stand among the derived values of a case."""

HOUSING_EXPANSION = "mesh.housing_thermal_expansion"


@dataclass(frozen=True)
class Comments:
    """Texts by path: those that hold already, and examples that fit to it; what is said of those that hold
    and are not computed."""

    known: Mapping[str, str] = field(default_factory=dict)
    fitting: Mapping[str, str] = field(default_factory=dict)
    origins: Mapping[str, str] = field(default_factory=dict)

    def of(self, place: Quantity | Choice) -> tuple[str, str]:
        """The text of a comment, and what it is."""
        if place.path in self.known:
            return self.known[place.path], f", {self.origins.get(place.path, 'as computed')}"
        if isinstance(place, Choice):
            return place.default, ", by default"
        return self.fitting.get(place.path, place.example), ", for example"


def comments_of(case: Case) -> Comments:
    """Of a pair with its drawing."""
    unstated = [v for v in case.values() if not v.text and isinstance(v.value, float | int)]
    found = {v.path: f"{v.value:.5g} {v.unit}".strip() for v in unstated}
    origins = {v.path: "as estimated" for v in unstated if v.estimated}
    origins |= {v.path: "as assumed" for v in unstated if not v.estimated and v.provenance == "assumed"}
    teeth = case.numbers.body.teeth
    if teeth is None:
        return Comments(found, {}, origins)
    found |= dict(_in_other_words(case, teeth))
    return Comments(found, dict(_fitting(case, teeth)), origins | dict(_of_lists(case)))


def _housing(case: Case) -> Material:
    """The material of the housing, stated or by default."""
    path = "mesh.housing_material"
    stated = next((v.value for v in case.values() if v.path == path), None)
    place = kind_named(case.kind).places[path]
    assert isinstance(place, Choice)
    return named(place.default if stated is None else str(stated))


def _of_lists(case: Case) -> Iterator[tuple[str, str]]:
    """What is a value of a material or a rack, and not computed."""
    for gear, one in zip(GEARS, materials_of(case), strict=True):
        for leaf in OF_DATA_SHEETS:
            yield f"{gear}.{leaf}", f"of {one.name}, from the list"
        for leaf in ("addendum", "dedendum", "root_radius"):
            yield f"{gear}.{leaf}", "as its rack has"
        yield f"{gear}.ball_diameter", "as assumed"
    yield HOUSING_EXPANSION, f"of {_housing(case).name}, from the list"


def _in_other_words(case: Case, teeth: CylindricalPair) -> Iterator[tuple[str, str]]:
    """What the pair has, as other words of a drawing say it."""
    values = {v.path: v for v in case.values()}
    for gear, one in zip(GEARS, teeth.gears, strict=True):
        for leaf in MEASURED:
            value = values.get(f"derived.{leaf}_{gear}")
            if value is not None:
                yield f"{gear}.{leaf}", f"{value.value:.7g} {value.unit}".strip()
        if f"derived.over_balls_{gear}" in values:
            ball = 1e-3 * float(values[f"derived.ball_diameter_{gear}"].value)
            yield f"{gear}.over_pins", f"{1e3 * inspection.dimension_over_pins(one, ball):.7g} mm"
        own = replace(one, stated_tip_diameter=None).tip_diameter
        yield f"{gear}.tip_alteration", f"{500.0 * (one.tip_diameter - own):.6g} mm"
        yield f"{gear}.addendum", f"{one.rack.addendum:.6g}"
        yield f"{gear}.dedendum", f"{one.rack.dedendum:.6g}"
        yield f"{gear}.root_radius", f"{one.rack.root_radius:.6g}"
        yield f"{gear}.transverse_profile_shift", f"{one.profile_shift * cos(one.helix_angle):.6g}"
    for gear, one in zip(GEARS, materials_of(case), strict=True):
        yield f"{gear}.youngs_modulus", f"{1e-9 * one.youngs_modulus:.6g} GPa"
        yield f"{gear}.poisson_ratio", f"{one.poisson_ratio:.6g}"
        yield f"{gear}.density", f"{one.density:.6g} kg/m^3"
        yield f"{gear}.thermal_expansion", f"{1e6 * one.expansion:.6g} um/(m*K)"
    yield HOUSING_EXPANSION, f"{1e6 * _housing(case).expansion:.6g} um/(m*K)"
    first = teeth.pinion
    yield "mesh.transverse_module", f"{1e3 * first.transverse_module:.7g} mm"
    yield "mesh.transverse_pressure_angle", f"{degrees(first.transverse_pressure_angle):.7g} deg"
    yield "mesh.diametral_pitch", f"{0.0254 / first.normal_module:.7g}"
    yield "mesh.transverse_diametral_pitch", f"{0.0254 / first.transverse_module:.7g}"
    yield "mesh.centre_distance", f"{1e3 * teeth.centre_distance:.7g} mm"
    yield "mesh.shift_sum", f"{sum(one.profile_shift for one in teeth.gears):.4g}"
    play = _play(case, teeth)
    if play > 0.0:
        yield "mesh.backlash_circumferential", f"{1e6 * play:.5g} um"
    yield from _operation(case, teeth.ratio)


def _play(case: Case, teeth: CylindricalPair) -> float:
    """Whole backlash on the working circle as drawings have it, at 20 °C and nominal distance, m."""
    at_work = float(case.scales.backlash_m(case.family()[0].defaults["D"]))
    return Backlash.from_normal(teeth, at_work - case.numbers.play_added).circumferential


def _operation(case: Case, ratio: float) -> Iterator[tuple[str, str]]:
    """Speed and torque of the gear, and the power."""
    speed, torque = speed_and_torque(case)
    yield "operation.gear_speed", f"{speed / ratio:.6g} rpm"
    for end in ("least", "greatest"):
        own = next((v for v in case.values() if v.path == f"operation.{end}_speed"), None)
        if own is not None:
            yield f"operation.{end}_gear_speed", f"{float(own.value) / ratio:.6g} rpm"
    yield "operation.gear_torque", f"{torque * ratio:.6g} N*m"
    yield "operation.power", f"{1e-3 * torque * speed * pi / 30:.7g} kW"


def speed_and_torque(case: Case) -> tuple[float, float]:
    """Of the pinion, rpm and N·m."""
    numbers = case.family()[0].defaults
    return float(case.scales.pinion_rpm(numbers["omega"])), float(case.scales.torque(numbers["load"]))


def _fitting(case: Case, teeth: CylindricalPair) -> Iterator[tuple[str, str]]:
    """Sizes as a pair of this size may have them: nothing in the file rests on them."""
    values = {v.path: v for v in case.values()}
    relief = max(1.0, float(f"{6e3 * teeth.pinion.normal_module:.1g}"))
    short = 0.5 * max(teeth.transverse_contact_ratio - 1.0, 0.1) * teeth.pinion.transverse_base_pitch
    play = _play(case, teeth)
    for at, (gear, one) in enumerate(zip(GEARS, teeth.gears, strict=True)):
        bore = values.get(f"{gear}.bore")
        hole = 0.4 * one.root_diameter if bore is None else 1e-3 * float(bore.value)
        yield f"{gear}.bore", _millimetres(hole)
        yield f"{gear}.shaft_diameter", _millimetres(hole)
        span = bearing_span(teeth.face_width, teeth.centre_distance, hole)
        yield f"{gear}.bearing_span", _millimetres(span)
        yield f"{gear}.rim_diameter", _millimetres(_rim(one, hole))
        yield f"{gear}.web_width", _millimetres(0.3 * teeth.face_width)
        yield f"{gear}.thickness_allowance", f"{-0.5e6 * play * cos(one.helix_angle):.2g} um"
        for leaf in ("tip_relief", "root_relief", "profile_crowning", "crowning"):
            yield f"{gear}.{leaf}", f"{relief:g} um"
        lowest, highest = _touching(teeth, at)
        for end, roll in (("tip", highest - short), ("root", lowest + short)):
            diameter = 2.0 * sqrt(roll**2 + 0.25 * one.base_diameter**2)
            yield f"{gear}.{end}_relief_length", f"{1e3 * short:.3g} mm"
            yield f"{gear}.{end}_relief_diameter", f"{1e3 * diameter:.6g} mm"
        for axis in "yz":
            bearing = values.get(f"{gear}.bearing_stiffness_{axis}")
            if bearing is not None:
                usual = f"{2.0 * float(bearing.value):.1g} N/m"
                yield from ((f"{gear}.{part}_stiffness_{axis}", usual) for part in ("shaft", "housing"))
    deviation = gear_fits.centre_distance_deviation(7, min(teeth.centre_distance, 3.0))
    yield "mesh.centre_distance_deviation", f"{1e6 * deviation:.2g} um"
    speed, torque = speed_and_torque(case)
    error = values.get("mesh.error")
    if error is not None and float(error.value) != 0.0:
        yield "mesh.loaded_error", f"{float(error.value):.2g} um"
    if torque != 0.0:
        yield "mesh.loaded_error_torque", f"{torque:.5g} N*m"
    for end, factor in (("least", 0.5), ("greatest", 1.5)):
        yield f"operation.{end}_speed", f"{float(f'{factor * speed:.4g}'):.9g} rpm"
        yield f"operation.{end}_gear_speed", f"{float(f'{factor * speed / teeth.ratio:.4g}'):.9g} rpm"


def _rim(one: CylindricalGear, hole: float) -> float:
    """Inner diameter of a rim 3 m_n thick, where the bore leaves room for it; else half way to the root."""
    usual = one.root_diameter - 6.0 * one.normal_module
    return usual if usual > 1.1 * hole else 0.5 * (hole + one.root_diameter)


def _touching(teeth: CylindricalPair, at: int) -> tuple[float, float]:
    """Roll lengths of one gear between which its flank touches."""
    start, end = teeth.path_of_contact
    return (start, end) if at == 0 else (teeth.tangent_length - end, teeth.tangent_length - start)


def _millimetres(length: float) -> str:
    """Rounded as drawings have sizes: whole above 10 mm, else to a tenth."""
    size = 1e3 * length
    return f"{round(size) if size > 10.0 else round(size, 1):g} mm"
