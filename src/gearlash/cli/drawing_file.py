"""The text of a case file from a drawing: what is stated stands there, what may be stated is a comment."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import groupby
from math import cos, degrees, pi

from gearlash.case import Case
from gearlash.case.kinds import Quantity, kind_named
from gearlash.case.kinds.registry import Kind
from gearlash.gears import inspection
from gearlash.gears.backlash import Backlash

from .words_of_drawing import GEARS, WORDS, is_helical

TABLES = (*GEARS, "mesh", "operation")
HEAD = """\
# A gear pair from its drawing. Values carry their units. Lines that begin with # are not read: without the #
# they state what stands there. What is not stated is estimated whenever the file is read, and assumed:
#   gearlash check {name}
"""
EXAMPLE = """\
# A template: nothing is stated yet. The lines with "example:" have the values of an example. Put your own in
# their place, and take their # away.
"""
ASSUMED_STEEL = '{value = "steel", provenance = "assumed", reason = "not stated"}'
TEMPLATE = {
    "teeth": "25/57",
    "module": "3 mm",
    "helix_angle": "15 deg",
    "face_width": "40 mm",
    "backlash": "80 um",
    "speed": "4200 rpm",
    "torque": "150 N*m",
}


def kind_of(texts: Mapping[str, str]) -> Kind:
    """The kind of case that fits what is stated."""
    return kind_named("helical-pair" if is_helical(texts) else "spur-1dof")


def file_text(
    texts: Mapping[str, str],
    name: str,
    description: str = "",
    example: bool = False,
    known: Mapping[str, str] | None = None,
) -> str:
    """The file with these texts by path; an ``example``, which nobody stated, is comments. What is ``known``
    otherwise stands in the comments."""
    kind, known = kind_of(texts), known or {}
    if kind.name == "spur-1dof":  # which has no helix: the angle is 0
        texts = {path: text for path, text in texts.items() if path != "mesh.helix_angle"}
    lines = [HEAD.format(name=name) + (EXAMPLE if example else "")]
    lines.append(f'kind = "{kind.name}"')
    if description:
        lines.append(f"description = {_toml(description)}")
    places = [(path, kind.places[path]) for path in _paths(kind, texts)]
    for table, inside in groupby(places, key=lambda row: row[0].partition(".")[0]):
        lines += ["", f"[{table}]"]
        for path, place in inside:
            leaf = path.partition(".")[2]
            stated = path in texts
            if path.endswith(".material") and not stated:
                lines.append(f"{leaf} = {ASSUMED_STEEL}  # {place.description}")
                continue
            usual = place.example if isinstance(place, Quantity) else place.default
            value = _value(place, texts[path] if stated else known.get(path, usual))
            computed = ", as computed" if not stated and path in known else ""
            origin = "example: " if example and stated else ""
            begin = "" if stated and not example else "# "
            lines.append(f"{begin}{leaf} = {value}  # {origin}{place.description}{computed}")
    return "\n".join(lines) + "\n"


def _paths(kind: Kind, texts: Mapping[str, str]) -> Iterator[str]:
    """Paths of this kind in the order of the file."""
    for table in TABLES:
        for word in WORDS:
            yield from (path for path in word.paths if path.startswith(f"{table}.") and path in kind.places)
    yield from (path for path in texts if path not in kind.places)  # told when the file is read


def _value(place: object, text: str) -> str:
    """A number as one where the place takes it, else a text with its unit."""
    if isinstance(place, Quantity) and place.bare:
        try:
            return repr(int(text)) if place.integer else repr(float(text))
        except ValueError:
            pass
    return _toml(text)


def _toml(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def known_of(case: Case) -> dict[str, str]:
    """What follows from a case, as texts by path: estimates, and what its teeth measure."""
    found = {}
    for value in case.values():
        if not value.text and isinstance(value.value, float | int):
            found[value.path] = f"{value.value:.5g} {value.unit}".strip()
    teeth = case.numbers.body.teeth
    if teeth is None:
        return found
    for gear, one in zip(GEARS, teeth.gears, strict=True):
        k, ball = inspection.span_teeth(one), 1.75 * one.normal_module
        found[f"{gear}.span_teeth"] = str(k)
        lengths = {
            "span": inspection.span_measurement(one, k),
            "over_balls": inspection.dimension_over_balls(one, ball),
            "over_pins": inspection.dimension_over_pins(one, ball),
            "ball_diameter": ball,
            "tip_diameter": one.tip_diameter,
            "root_diameter": one.root_diameter,
            "tooth_thickness": one.normal_thickness(),
            "tip_alteration": 0.5 * (one.tip_diameter - replace(one, stated_tip_diameter=None).tip_diameter),
        }
        numbers = {
            "addendum": one.rack.addendum,
            "dedendum": one.rack.dedendum,
            "root_radius": one.rack.root_radius,
            "transverse_profile_shift": one.profile_shift * cos(one.helix_angle),
        }
        found |= {f"{gear}.{leaf}": f"{number:.6g}" for leaf, number in numbers.items()}
        found |= {f"{gear}.{leaf}": f"{1e3 * length:.6g} mm" for leaf, length in lengths.items()}
    first = teeth.pinion
    found["mesh.transverse_module"] = f"{1e3 * first.transverse_module:.7g} mm"
    found["mesh.transverse_pressure_angle"] = f"{degrees(first.transverse_pressure_angle):.7g} deg"
    found["mesh.diametral_pitch"] = f"{0.0254 / first.normal_module:.7g}"
    found["mesh.transverse_diametral_pitch"] = f"{0.0254 / first.transverse_module:.7g}"
    found["mesh.centre_distance"] = f"{1e3 * teeth.centre_distance:.7g} mm"
    found["mesh.shift_sum"] = f"{sum(one.profile_shift for one in teeth.gears):.4g}"
    speed, torque = (_of(case, path) for path in ("operation.pinion_speed", "operation.torque"))
    found["operation.gear_speed"] = f"{speed / teeth.ratio:.6g} rpm"
    for end in ("least", "greatest"):
        own = next((v for v in case.values() if v.path == f"operation.{end}_speed"), None)
        if own is not None:
            found[f"operation.{end}_gear_speed"] = f"{float(own.value) / teeth.ratio:.6g} rpm"
    found["operation.gear_torque"] = f"{torque * teeth.ratio:.6g} N*m"
    found["operation.power"] = f"{1e-3 * torque * speed * pi / 30:.5g} kW"
    play = Backlash.from_normal(teeth, 1e-6 * _of(case, "mesh.backlash"))
    found["mesh.backlash_circumferential"] = f"{1e6 * play.circumferential:.5g} um"
    return found


def _of(case: Case, path: str) -> float:
    """A value of the case in its unit."""
    for value in case.values():
        if value.path == path:
            return float(value.value)
    family, _ = case.family()
    short = {"operation.pinion_speed": "omega", "operation.torque": "load", "mesh.backlash": "D"}[path]
    return next(float(v) for p, v, _ in case.physical(short, family.defaults[short]) if p == path)
