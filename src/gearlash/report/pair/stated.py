"""The pair that a report is of: what the case states, what follows from it, and its teeth in mesh."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from gearlash import plots
from gearlash.case import Case, Value
from gearlash.case.units import pretty
from gearlash.plots.teeth_of_case import teeth_of_case
from gearlash.report.blocks import Block, Cell, Figure, Marked, Section, Table, Text
from gearlash.report.numbers import number
from gearlash.report.pictures import Picture

from .contents import Contents

GEARS = ("pinion", "gear")
TEETH = "Teeth in mesh, in the transverse section, with their dimensions; † rests on an assumed value."
STATED = "What the case states, in its units."
FOLLOWS = "What follows from it at the present speed and torque; forces are those of the mean torque."
OF_GEAR = re.compile(r"derived\.(\w+?)_(pinion|gear)")
OF_MODEL = re.compile(
    r"dimensionless\..*|derived\.(radius|natural_frequency|closed_frequency|critical_speed|c_|omega_n|force_unit|"
    r"equivalent_mass|transmitted_force).*"
)
"""Numbers of the model's equations: `gearlash check` has them."""
ONE_SIDED = ("derived.backlash_angle_gear",)
"""Of one gear by its name, but a number of the pair."""


def pictures(contents: Contents) -> list[Picture]:
    """The teeth, where they are known."""
    teeth = teeth_of_case(contents.found.case)
    return [] if teeth is None else [Picture("teeth", plots.mesh_drawing, teeth)]


def section(contents: Contents) -> Section:
    """A reader of the page alone knows which pair it is of."""
    case = contents.found.case
    blocks: list[Block] = [*pair_tables(case)]
    if teeth_of_case(case) is not None:
        blocks.append(Figure("figure-teeth", Text.of(TEETH), TEETH, "teeth"))
    return Section("pair", "The pair", tuple(blocks))


def pair_tables(case: Case) -> tuple[Table, ...]:
    """What is stated and what follows, as far as the case has it."""
    values = case.values()
    given = [each for each in values if each.provenance == "given" and each.path != "model.reference_length"]
    derived = [each for each in values if each.provenance == "derived" and not OF_MODEL.fullmatch(each.path)]
    return (*_table("stated", STATED, given), *_table("follows", FOLLOWS, derived))


def in_brief(case: Case) -> str:
    """``17/71 teeth, normal module 1 mm, …``: the pair in a line, as far as the case states it."""
    values = {each.path: each for each in case.values() if each.provenance == "given"}
    return ", ".join(_brief(values))


def _brief(values: dict[str, Value]) -> Iterator[str]:
    both = [values.get(f"{gear}.teeth") for gear in GEARS]
    if all(each is not None for each in both):
        yield f"{'/'.join(_shown(each) for each in both if each is not None)} teeth"
    for path, words in (
        ("mesh.normal_module", "normal module"),
        ("mesh.transverse_module", "transverse module"),
        ("mesh.diametral_pitch", "normal diametral pitch"),
        ("mesh.transverse_diametral_pitch", "transverse diametral pitch"),
        ("mesh.helix_angle", "helix angle"),
        ("mesh.centre_distance", "centre distance"),
        ("mesh.backlash", "normal backlash"),
    ):
        if path in values:
            yield f"{words} {_shown(values[path])}"
    bodies = [values.get(f"{gear}.material") for gear in GEARS]
    if all(each is not None for each in bodies):
        yield " on ".join(dict.fromkeys(_shown(each) for each in bodies if each is not None))


def _table(name: str, caption: str, values: Sequence[Value]) -> Iterator[Table]:
    """A table with what is of the pair over both columns of the gears, and of either gear in its own."""
    rows: dict[str, dict[str, Cell]] = {}
    for value in values:
        gear = _gear(value.path)
        words = value.description.partition(";")[0] or value.path
        words = of_either(words, gear) if gear else words
        formula = value.reason if value.provenance == "derived" else ""
        words = f"{words} ({formula})" if formula else words
        shown = _shown(value)
        cell = Marked(shown) if value.rests_on else shown
        rows.setdefault(words, {})[gear or GEARS[0]] = cell
    cells = tuple((words, *(found.get(gear, "") for gear in GEARS)) for words, found in rows.items())
    if cells:
        yield Table(name, caption, ("", "pair, or pinion", "gear"), cells, frozenset({1, 2}), (62, 19, 19))


def of_either(words: str, gear: str) -> str:
    """Words of one gear as they are of both: its column says which of them it is."""
    words = words.replace(f"that of the {gear} itself", "its own").replace(f"the {gear}'s", "its")
    return re.sub(rf" (?:of|in) the {gear}\b", "", words)


def _gear(path: str) -> str:
    """Which gear a value is of; empty where it is of the pair."""
    table = path.partition(".")[0]
    if table in GEARS:
        return table
    found = OF_GEAR.fullmatch(path)
    return found[2] if found and path not in ONE_SIDED else ""


def _shown(value: Value) -> str:
    if isinstance(value.value, str):
        return value.value
    unit = pretty(value.unit)
    blank = "" if unit in ("", "°") else " "
    if value.limited and value.least is not None and value.greatest is not None:
        ends = f" ({number(value.least, 5)} to {number(value.greatest, 5)})"
        return f"{number(float(value.value), 5)}{ends}{blank}{unit}"
    return f"{number(float(value.value), 5)}{blank}{unit}"
