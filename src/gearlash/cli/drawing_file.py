"""The text of a case file from a drawing: what is stated stands there, what may be stated is a comment."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from itertools import groupby

from gearlash.case.kinds import Choice, Quantity, kind_named
from gearlash.case.kinds.registry import Kind

from .comments_of_drawing import Comments
from .words_of_drawing import GEARS, WORDS, is_helical

TABLES = (*GEARS, "mesh", "operation")
HEAD = """\
# A gear pair from its drawing. Values carry their units, and may be two limits ("60 to 140 um"). Lines that
# begin with # are not read: without the # they state what stands there: "for example" a size that would fit
# this pair and says nothing of it, others what holds already, as computed, estimated, assumed or taken from a
# list. What is not stated is estimated whenever the file is read, and assumed:
#   gearlash check {name}
"""
EXAMPLE = """\
# A template: nothing is stated yet. The lines with "example:" have the values of an example. Put your own in
# their place, and take their # away.
"""
ALL_ROUND = """
[model]
y_axis = {value = "line-of-action", provenance = "assumed", reason = "bearings that give way alike all \
round: shafts move along the line of action, and lateral bearing forces are all of the force across a shaft"}
"""
"""Of a pair on bearings: along the tangent of the pitch circles, which is the default, the force that pushes
the shafts apart would have no bearing to give way."""
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


def template(teeth: str) -> dict[str, str]:
    """Words of an example pair with these teeth: spur ones have no helix angle, others have one."""
    return {name: text for name, text in TEMPLATE.items() if teeth != "spur" or name != "helix_angle"}


def kind_of(texts: Mapping[str, str]) -> Kind:
    """The kind of case that fits what is stated."""
    return kind_named("helical-pair" if is_helical(texts) else "spur-1dof")


def file_text(
    texts: Mapping[str, str],
    name: str,
    description: str = "",
    example: bool = False,
    comments: Comments | None = None,
) -> str:
    """The file with these texts by path; an ``example``, which nobody stated, is comments."""
    kind, comments = kind_of(texts), comments or Comments()
    if kind.name == "spur-1dof":  # which has no helix: the angle is 0
        texts = {path: text for path, text in texts.items() if path != "mesh.helix_angle"}
    elif "mesh.helix_angle" not in texts:  # spur teeth on bearings
        texts = {**texts, "mesh.helix_angle": "0 deg"}
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
            text, why = (texts[path], "") if stated else comments.of(place)
            origin = "example: " if example and stated else ""
            begin = "" if stated and not example else "# "
            lines.append(f"{begin}{leaf} = {_value(place, text)}  # {origin}{place.description}{why}")
    return "\n".join(lines) + "\n" + (ALL_ROUND if kind.name == "helical-pair" else "")


def _paths(kind: Kind, texts: Mapping[str, str]) -> Iterator[str]:
    """Paths of this kind in the order of the file."""
    for table in TABLES:
        for word in WORDS:
            yield from (path for path in word.paths if path.startswith(f"{table}.") and path in kind.places)
    yield from (path for path in texts if path not in kind.places)  # told when the file is read


def _value(place: Quantity | Choice, text: str) -> str:
    """A number as one where the place takes it, else a text with its unit."""
    if isinstance(place, Quantity) and place.bare:
        try:
            return repr(int(text)) if place.integer else repr(float(text))
        except ValueError:
            pass
    return _toml(text)


def _toml(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
