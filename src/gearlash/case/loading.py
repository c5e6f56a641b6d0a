"""From a file, a bundled name, a text or tables to a case."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from gearlash.system import given

from .case import Case, checked
from .curve_files import with_files
from .errors import CaseError
from .kinds import Content, Draft, Kind, kind_of
from .read import parse, source_text
from .texts import name_of_file


def load(path_or_name: str | Path, overrides: Mapping[str, object] | None = None) -> Case:
    """The case in a file, or the bundled case of that name.

    Parameters
    ----------
    path_or_name : str or Path
        A file in TOML, or one of `bundled()`, which wins over a file of that name.
    overrides : mapping, optional
        Values that replace those of the file, by path or short name: texts with their unit (``"120 um"``),
        or numbers for what has no unit.

    Returns
    -------
    Case

    Raises
    ------
    CaseError
        With every problem of the file and of the overrides at once.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.load_case("kahraman-singh").kind
    'spur-1dof'
    >>> gl.load_case("wind-turbine", {"backlash": "100"})
    Traceback (most recent call last):
        ...
    gearlash.case.errors.CaseError: wind-turbine: 1 problem
      backlash = '100': expected a length with its unit, such as "100 um"; did you mean '100 um'?
    """
    label, text, folder = source_text(path_or_name)
    return from_tables(with_files(label, parse(label, text), folder), overrides, label)


def loads(text: str, overrides: Mapping[str, object] | None = None, label: str = "case") -> Case:
    """The case in a text.

    Parameters
    ----------
    text : str
        TOML, as in a file.
    overrides : mapping, optional
        As of `load`.
    label : str
        What the text is called in problems, and where it states no name.

    Returns
    -------
    Case

    Raises
    ------
    CaseError
        With every problem of the text and of the overrides at once.

    Examples
    --------
    >>> from gearlash.case import loads
    >>> case = loads('''
    ... kind = "spur-1dof"
    ... [dimensionless]
    ... omega = 0.7
    ... D = 1
    ... load = 0.2
    ... error = 0.05
    ... mesh_damping = 0.05
    ... ''')
    >>> case.kind, case.family()[0].defaults["omega"]
    ('spur-1dof', 0.7)
    """
    text, label = given.a_text("text of a case", text), given.a_text("label", label)
    return from_tables(parse(label, text), overrides, label)


def from_tables(
    raw: Mapping[str, object], overrides: Mapping[str, object] | None = None, label: str = "case"
) -> Case:
    """The case in the tables of a parsed file; see `load`."""
    from .head import KEYS, read_head  # late: a worker that reads case JSON never needs pydantic

    overrides = given.mapping("overrides", overrides)
    kind, problems = kind_of(raw)
    if kind is None:
        raise CaseError(label, problems)
    head, wrong = read_head(raw, kind.places)
    draft = kind.read({key: value for key, value in raw.items() if key not in KEYS})
    meant = frozenset(p.nearest for p in wrong if p.nearest)  # stated in [source] instead
    content, refused = draft.content.override(overrides)
    problems = [*problems, *wrong, *draft.problems, *refused]
    content = checked(Draft(content, problems, draft.present | meant), label)
    return _of(kind, head, label, content)


def _of(kind: Kind, head: Mapping[str, Any], label: str, content: Content) -> Case:
    name = head["name"] or name_of_file(Path(label).stem)
    return Case(name, kind.name, head["description"], head["source"], content.entries, content.structure)
