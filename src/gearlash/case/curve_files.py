"""Files of points that a case names, read into the places where their points belong.

A name counts from the folder of the case. The first column is the angle, the second the value; a unit in
brackets behind the name of a column takes effect where the case states none.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from .columns import read_columns
from .errors import CaseError, Problem, shown
from .files import UnreadableError

TABLE = "curves"
_ANGLES = {"": "cycle", "°": "deg", "cycles": "cycle", "mesh cycle": "cycle", "mesh cycles": "cycle"}


def with_files(label: str, tables: Mapping[str, object], folder: Path | None) -> dict[str, object]:
    """The tables of a case with points in place of files. Raises `CaseError`."""
    curves = tables.get(TABLE)
    if folder is None or not isinstance(curves, Mapping):
        return dict(tables)
    read, problems = {}, []
    for name, table in curves.items():
        if not isinstance(table, Mapping) or "file" not in table or "points" in table:
            read[name] = table
            continue
        try:
            read[name] = _with_points(table, folder)
        except UnreadableError as error:
            path, named = f"{TABLE}.{name}.file", shown(table["file"])
            problems.append(Problem(path, named, f"a text file of two columns beside the case ({error})"))
    if problems:
        raise CaseError(label, problems)
    return {**tables, TABLE: read}


def _with_points(table: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    named = table["file"]
    if not isinstance(named, str) or not named.strip():
        raise UnreadableError("it is no name")
    found = read_columns(folder / named)
    if len(found.names) != 2:
        raise UnreadableError(f"it has {len(found.names)} columns")
    points = {key: value for key, value in table.items() if key != "file"}
    angle, unit = found.units
    if "angle" not in table and angle:
        points["angle"] = _ANGLES.get(angle, angle)
    if "unit" not in table:
        points["unit"] = unit
    points.setdefault("reason", f"points of {named}")
    return {**points, "points": [list(row) for row in found.rows]}
