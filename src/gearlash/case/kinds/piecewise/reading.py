"""Plain tables and arrays of a case file, read one by one; every problem is kept, none ends the reading."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping
from typing import Any, TypeAlias

from gearlash.case.errors import MOST_SHOWN, Problem, shown
from gearlash.case.words import nearest_name

from .expressions import GRAMMAR, LARGEST_NUMBER, Expression, ExpressionError

Number: TypeAlias = float | str
"""A number or the text of an expression."""
Series: TypeAlias = dict[str, Any]

MOST_HARMONICS = 100
HIGHEST_ORDER = 1000
LABEL = "a name of 1 to 40 letters, digits and _ - . ' that starts with a letter"
EXPECTED_NUMBER = f'a finite number, or an expression as text, such as "2*zeta" ({GRAMMAR})'
EXPECTED_SERIES = (
    "a number, an expression, or a table of mean, cos and sin, or of mean, amplitudes and phases"
)
POLAR, CARTESIAN = ("amplitudes", "phases"), ("cos", "sin")
_LABEL = re.compile(r"[^\W\d_][\w'′.\-]{0,39}")


class Reading:
    """Raw TOML values to numbers, series and vectors. ``known`` are the names that expressions may hold;
    ``states`` is None where the list of states is itself unusable: then nothing is held against it."""

    def __init__(self, known: Collection[str] = (), states: list[str] | None = None):
        self.known, self.states = known, states
        self.problems: list[Problem] = []

    def wrong(self, path: str, raw: object, expected: str, nearest: str | None = None) -> None:
        self.problems.append(Problem(path, shown(raw), expected, nearest))

    def missing(self, path: str, expected: str) -> None:
        self.problems.append(Problem(path, None, expected, missing=True))

    def near(self, name: str, valid: Iterable[str]) -> str | None:
        """The nearest valid name, for problems that are told and not only counted."""
        return nearest_name(name, valid) if len(self.problems) < MOST_SHOWN else None

    def table(self, raw: object, path: str, keys: Iterable[str] | None = None) -> dict[str, Any]:
        """The table, without keys that are none of these."""
        if not isinstance(raw, Mapping):
            self.wrong(path, raw, f"a table [{path}]")
            return {}
        if keys is None:
            return dict(raw)
        valid = tuple(keys)
        for key in raw:
            if key not in valid:
                expected = f"one of {', '.join(valid)} here"
                self.wrong(f"{path}.{key}", raw[key], expected, self.near(key, valid))
        return {key: raw[key] for key in valid if key in raw}

    def label(self, raw: object, path: str) -> str | None:
        """The name of a state or of a clearance."""
        if isinstance(raw, str) and _LABEL.fullmatch(raw):
            return raw
        self.wrong(path, raw, LABEL)
        return None

    def number(self, raw: object, path: str) -> Number:
        if isinstance(raw, str):
            try:
                Expression.read(raw, self.known)
            except ExpressionError as error:
                self.wrong(path, raw, error.expected, error.nearest)
            return raw
        value = finite(raw)
        if value is None:
            self.wrong(path, raw, EXPECTED_NUMBER)
        return value or 0.0

    def numbers(self, raw: object, path: str) -> list[Number]:
        if not isinstance(raw, list) or len(raw) > MOST_HARMONICS:
            self.wrong(path, raw, f"an array of at most {MOST_HARMONICS} numbers or expressions")
            return []
        return [self.number(item, f"{path}[{i}]") for i, item in enumerate(raw)]

    def series(self, raw: object, path: str) -> Series:
        """A Fourier series over the base period, in one form: every list as long as ``orders``."""
        if isinstance(raw, list | bool):
            self.wrong(path, raw, EXPECTED_SERIES)
            return {"mean": 0.0}
        if not isinstance(raw, Mapping):
            return {"mean": self.number(raw, path)}
        content = self.table(raw, path, ("mean", *CARTESIAN, *POLAR, "orders"))
        mean = self.number(content.get("mean", 0.0), f"{path}.mean")
        polar, cartesian = ([key for key in keys if key in content] for keys in (POLAR, CARTESIAN))
        if polar and cartesian:
            both = f"either {' and '.join(CARTESIAN)} or {' and '.join(POLAR)}"
            self.wrong(f"{path}.{cartesian[0]}", content[cartesian[0]], both)
            return {"mean": mean}
        first, second = POLAR if polar else CARTESIAN
        lists = {key: self.numbers(content.get(key, []), f"{path}.{key}") for key in (first, second)}
        if polar and lists[second] and len(lists[second]) != len(lists[first]):
            expected = f"as many phases as amplitudes ({len(lists[first])})"
            self.wrong(f"{path}.{second}", content[second], expected)
        count = max(map(len, lists.values()))
        orders = self._orders(content, path, count)
        if not count:
            return {"mean": mean}
        padded = {key: [*items, *[0.0] * (count - len(items))] for key, items in lists.items()}
        return {"mean": mean, **padded, "orders": orders}

    def _orders(self, content: Mapping[str, object], path: str, count: int) -> list[int]:
        """Which harmonic of the base period each entry is: 1, 2, 3 … unless stated."""
        plain = list(range(1, count + 1))
        if "orders" not in content:
            return plain
        raw = content["orders"]
        expected = (
            f"{count} different whole numbers from 1 to {HIGHEST_ORDER}, one an entry of the other arrays"
        )
        if not isinstance(raw, list) or len(raw) != count or not all(map(_is_order, raw)):
            self.wrong(f"{path}.orders", raw, expected)
            return plain
        if len(set(raw)) < count:
            self.wrong(f"{path}.orders", raw, expected)
            return plain
        return list(raw)

    def by_state(self, raw: object, path: str, read: Any) -> dict[str, Any]:
        """A value a state: an array as long as the list of states, or a table with names of states."""
        states = self.states
        if isinstance(raw, list):
            items = [read(item, f"{path}[{i}]") for i, item in enumerate(raw)]
            if states is not None and len(items) != len(states):
                self.wrong(path, raw, f"{len(states)} entries, one a state ({', '.join(states)})")
            return dict(zip(states or (), items, strict=False))
        if not isinstance(raw, Mapping):
            self.wrong(path, raw, "an array with one entry a state, or a table with names of states")
            return {}
        for name in raw:
            if states is not None and name not in states:
                expected = f"the name of a state: {', '.join(states)}"
                self.wrong(f"{path}.{name}", raw[name], expected, self.near(name, states))
        return {name: read(item, f"{path}.{name}") for name, item in raw.items()}

    def vector(self, raw: object, path: str) -> dict[str, Number]:
        return self.by_state(raw, path, self.number)


def finite(raw: object) -> float | None:
    """The float of a TOML number, if it is one and not too large."""
    if isinstance(raw, bool) or not isinstance(raw, int | float):
        return None
    try:
        value = float(raw)
    except OverflowError:
        return None
    return value if abs(value) <= LARGEST_NUMBER else None


def _is_order(raw: object) -> bool:
    return isinstance(raw, int) and not isinstance(raw, bool) and 1 <= raw <= HIGHEST_ORDER
