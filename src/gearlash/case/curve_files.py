"""Files of points that a case names, read into the places where their points belong.

A name counts from the folder of the case. The first column is the angle, the second the value; a unit in
brackets behind the name of a column takes effect where the case states none, and must not contradict one
that it states.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from .columns import Columns, read_columns
from .errors import CaseError, Problem, shown
from .files import UnreadableError
from .units import Unit, UnitError, unit

TABLE = "curves"
_UNITS_OF_ANGLES = {
    "deg": "deg",
    "°": "deg",
    "rad": "rad",
    "turn": "turn",
    "turns": "turn",
    "rev": "turn",
    "cycle": "cycle",
}
"""Last words of an angle, in a case and in heads of columns."""
_ANGLES = {"": "cycle", "°": "deg", "cycles": "cycle", "mesh cycle": "cycle", "mesh cycles": "cycle"}


def with_files(label: str, tables: Mapping[str, object], folder: Path | None) -> dict[str, object]:
    """The tables of a case with points in place of files. Raises `CaseError`."""
    curves = tables.get(TABLE)
    if folder is None or not isinstance(curves, Mapping):
        return dict(tables)
    read, problems = dict(curves), []
    for name, table in _from_files(curves):
        try:
            columns = _columns(table, folder)
            problems += _contradictions(f"{TABLE}.{name}", table, columns)
            read[name] = _with_points(table, columns)
        except UnreadableError as error:
            path, named = f"{TABLE}.{name}.file", shown(table["file"])
            problems.append(Problem(path, named, f"a text file of two columns beside the case ({error})"))
    if problems:
        raise CaseError(label, problems)
    return {**tables, TABLE: read}


def files_named(tables: Mapping[str, object], folder: Path) -> list[Path]:
    """The files that `with_files` reads."""
    named = [table["file"] for _, table in _from_files(tables.get(TABLE))]
    return [folder / name for name in named if isinstance(name, str) and name.strip()]


def _from_files(curves: object) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Names and tables of the curves whose points are in files."""
    for name, table in curves.items() if isinstance(curves, Mapping) else ():
        if isinstance(table, Mapping) and "file" in table and "points" not in table:
            yield name, table


def _columns(table: Mapping[str, Any], folder: Path) -> Columns:
    named = table["file"]
    if not isinstance(named, str) or not named.strip():
        raise UnreadableError("it is no name")
    found = read_columns(folder / named)
    if len(found.names) != 2:
        raise UnreadableError(f"it has {len(found.names)} columns")
    return found


def _with_points(table: Mapping[str, Any], found: Columns) -> dict[str, Any]:
    """Units of the file's head where the table states none."""
    points = {key: value for key, value in table.items() if key != "file"}
    angle, unit = found.units
    if "angle" not in table and angle:
        points["angle"] = _ANGLES.get(angle, angle)
    if "unit" not in table:
        points["unit"] = unit
    points.setdefault("reason", f"points of {table['file']}")
    return {**points, "points": [list(row) for row in found.rows]}


def _contradictions(path: str, table: Mapping[str, Any], found: Columns) -> Iterator[Problem]:
    """Units that the case states otherwise than the head of the file. Which of both is wrong only the user
    knows; a word in the head that is no unit says nothing."""
    angle, value = found.units
    named = table["file"]
    of_shafts = {str(table.get("angle")).split(" ")[0], angle.split(" ")[0]} == {"pinion", "gear"}
    for key, head, size in (("angle", angle, _of_angle), ("unit", value, _unit)):
        stated = table.get(key)
        if not isinstance(stated, str) or not head:
            continue
        if _differ(size(stated), size(head)) or (key == "angle" and of_shafts):
            what = f"what the head of {named} has, {head!r}; or put that right"
            yield Problem(f"{path}.{key}", shown(stated), what)


def _differ(one: object, other: object) -> bool:
    return one is not None and other is not None and one != other


def _of_angle(text: str) -> str | None:
    """What an angle is counted in; None of what is no angle."""
    words = _ANGLES.get(text, text).split()
    size = _UNITS_OF_ANGLES.get(words[-1]) if words else None
    if size is None or not set(words[:-1]) <= {"pinion", "gear"}:
        return None
    return size


def _unit(text: str) -> Unit | None:
    try:
        return unit(text)
    except UnitError:
        return None
