"""Which kinds of case there are: those of this folder, and what a user registered.

    register(Pendulum())
    case = gearlash.load_case("pendulum.toml")

Worker processes get a registered kind sent, as they get a `Family` of one's own: its class must be defined in
a module that they can import. Studies refuse any other in words.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module

from gearlash.case.errors import Problem, shown
from gearlash.case.words import nearest_name
from gearlash.system import GearlashError, given

from .kind import Kind

_FOLDERS = {"helical-pair": "helical", "spur-1dof": "spur", "piecewise-linear": "piecewise"}
"""Folders beside this file, each with its `KIND`; imported when a case of it is met."""
_registered: dict[str, Kind] = {}


def kinds() -> tuple[str, ...]:
    """Names of all kinds of case.

    Returns
    -------
    tuple of str
        In the order of the JSON Schema; registered ones last.

    Examples
    --------
    >>> from gearlash.case.kinds import kinds
    >>> kinds()
    ('helical-pair', 'spur-1dof', 'piecewise-linear')
    """
    return (*_FOLDERS, *_registered)


def kind_named(name: object) -> Kind:
    """The kind of this name. Raises `UnknownNameError`."""
    name = given.known("kind of case", name, kinds())
    if name in _registered:
        return _registered[name]
    found: Kind = import_module(f"{__package__}.{_FOLDERS[name]}").KIND
    return found


def is_between_teeth(name: str) -> bool:
    """Whether cases of the kind of this name are about meshing gears; False where no such kind is known here
    (a file may have been written elsewhere)."""
    return name in kinds() and kind_named(name).between_teeth


def register(kind: Kind) -> None:
    """Makes a kind of your own known to files, commands, studies and workers of this process.

    Parameters
    ----------
    kind : Kind
        An object of a class that worker processes can import. A class that is defined again replaces the one
        of before.

    Raises
    ------
    GearlashError
        Where another kind has the name already.

    Examples
    --------
    >>> from gearlash.case.kinds import Kind, forget, kinds, register
    >>> class Pendulum(Kind):
    ...     name = "pendulum"
    ...     def content(self, entries, structure):
    ...         raise NotImplementedError("see the example of Kind")
    >>> register(Pendulum())
    >>> kinds()[-1]
    'pendulum'
    >>> forget("pendulum")
    """
    given.instance("kind", kind, Kind, "a Kind of gearlash.case.kinds")
    name = given.word("name of a kind", getattr(kind, "name", None))
    known = _registered.get(name)
    if name in _FOLDERS or (known is not None and _home(known) != _home(kind)):
        raise GearlashError(f"there is a kind of case called {name!r} already")
    _registered[name] = kind


def _home(kind: Kind) -> tuple[str, str]:
    return type(kind).__module__, type(kind).__qualname__


def forget(name: str) -> None:
    """Takes back what `register` did for the kind of this name. Raises `UnknownNameError`."""
    _registered.pop(given.known("registered kind of case", name, _registered))


def registered(name: str) -> Kind | None:
    """The kind of this name if a user registered it."""
    return _registered.get(name)


def kind_of(tables: Mapping[str, object]) -> tuple[Kind | None, list[Problem]]:
    """The kind that a file states, and what is wrong with that. Where the name is misspelt it is the nearest
    one, so that the rest of the file is checked too; None where there is none."""
    names, stated = kinds(), tables.get("kind")
    expected = f"one of {', '.join(names)}"
    if stated is None:
        return None, [Problem("kind", None, f"{expected}, as the first line of a case", missing=True)]
    if isinstance(stated, str) and stated in names:
        return kind_named(stated), []
    near = nearest_name(stated, names)
    return None if near is None else kind_named(near), [Problem("kind", shown(stated), expected, near)]
