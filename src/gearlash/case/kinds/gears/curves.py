"""The tables ``[curves.stiffness]`` and ``[curves.error]``: what is measured or computed over an angle.

What they state is kept as plain data (`Structure`), values in SI, so that another process makes the same
series of it: ``phases`` (parts of the period, from 0 to 1) and ``values``, or ``amplitudes`` and ``phases``.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import isfinite, pi
from typing import Any

import numpy as np

from gearlash.case.errors import Problem, shown
from gearlash.case.quantity import Quantity
from gearlash.case.stated import Provenance, ValueRefusedError, read_one
from gearlash.case.units import (
    ANGLE,
    LENGTH,
    NUMBER,
    STIFFNESS,
    TORQUE,
    Dimension,
    UnitError,
    in_si,
    read,
    takes,
)
from gearlash.case.words import nearest_name

TABLE = "curves"
STEMS = {"stiffness": "ripple", "error": "error"}
"""Curves by name, with the stem of the harmonics that they stand for."""
NAMES = tuple(STEMS)
PERIODS = ("mesh cycle", "pinion turn", "gear turn")
ANGLES: Mapping[str, tuple[str, float]] = {
    "cycle": ("mesh cycle", 1.0),
    **{
        f"{shaft} {unit}": (f"{shaft} turn", size)
        for shaft in ("pinion", "gear")
        for unit, size in (("deg", 360.0), ("rad", 2.0 * pi), ("turn", 1.0))
    },
}
"""Name of an angle: the period that it counts, and how much of it one period is."""
FORMS = {
    "points": ("points",),
    "file": ("file",),
    "rectangle": ("low", "high", "contact_ratio"),
    "harmonics of a cosine": ("amplitudes",),
}
KEYS = (
    "points", "file", "low", "high", "contact_ratio", "amplitudes", "phases", "mean", "angle", "unit",
    "over", "harmonics", "state", "torque", "provenance", "reason",
)  # fmt: skip
MOST_POINTS = 20_000
CLOSING = 0.02  # of the least step: how far beside a whole period an angle that closes it may be rounded
WIDEST = 1.5  # times the largest step between points: from the last one round to the first
MOST_HARMONICS = 200
"""Of a mesh cycle; a turn of a shaft has as many times its teeth."""
UNLOADED, LOADED = "unloaded", "loaded"
_DIMENSION = {"stiffness": STIFFNESS, "error": LENGTH}
_TORQUE = Quantity("torque", TORQUE, "N*m", "150 N·m", "pinion torque of the measurement", -1e9, 1e9)
_PHASE = Quantity("phases", ANGLE, "rad", "1.57 rad", "phase of a cosine", -100.0, 100.0, bare=True)
_WHAT = {"stiffness": "N/um", "error": "um"}


class CurveReader:
    """One table read; every problem is kept."""

    def __init__(self, name: str, table: Mapping[str, Any], teeth: Mapping[str, int]):
        self.name, self.table, self.path = name, table, f"{TABLE}.{name}"
        self.teeth = teeth
        self.problems: list[Problem] = []

    def wrong(self, key: str, expected: str, nearest: str | None = None) -> None:
        """Keeps a problem of what stands at a key, once."""
        problem = Problem(f"{self.path}.{key}", shown(self.table.get(key)), expected, nearest)
        if problem not in self.problems:
            self.problems.append(problem)

    def read(self) -> dict[str, Any] | None:
        """The plain data; None where something is wrong."""
        for key in self.table:
            if key not in KEYS:
                self.wrong(key, "a name that exists here", nearest_name(key, KEYS))
        form = self._form()
        found = {
            "over": self._one_of("over", PERIODS),
            "harmonics": self._harmonics(),
            "provenance": self._one_of("provenance", tuple(Provenance)),
            "reason": self._text("reason"),
            **self._state(),
        }
        if form == "rectangle":
            found |= self._rectangle()
        elif form == "harmonics of a cosine":
            found |= self._cosines()
        elif form == "points":
            found |= self._points(self.table["points"], "points")
        return None if self.problems else found

    def _form(self) -> str | None:
        """Which of the ways to state a curve is used: one and only one."""
        if "file" in self.table:  # the loader puts points in its place
            self.wrong("file", "points in place: a text or a table that came from no file has no folder")
            return None
        used = [form for form, keys in FORMS.items() if any(key in self.table for key in keys)]
        if len(used) == 1:
            lacking = [key for key in FORMS[used[0]] if key not in self.table]
            for key in lacking:
                self.problems.append(
                    Problem(f"{self.path}.{key}", None, f"there, for a {used[0]}", missing=True)
                )
            return None if lacking else used[0]
        expected = "one of: points; file; low, high and contact_ratio; amplitudes (with phases)"
        self.problems.append(Problem(self.path, None, expected, missing=not used))
        return None

    def _one_of(self, key: str, valid: tuple[str, ...]) -> str:
        raw = self.table.get(key, valid[0])
        if raw not in valid:
            near = nearest_name(raw, valid) if isinstance(raw, str) else None
            self.wrong(key, f"one of {', '.join(valid)}", near)
            return str(valid[0])
        return str(raw)

    def _text(self, key: str) -> str:
        raw = self.table.get(key, "")
        if not isinstance(raw, str):
            self.wrong(key, "a text")
            return ""
        return raw

    def _harmonics(self) -> int | None:
        raw = self.table.get("harmonics")
        if raw is None:
            return None
        if isinstance(raw, bool) or not isinstance(raw, int) or not 1 <= raw <= MOST_HARMONICS:
            self.wrong("harmonics", f"a whole number from 1 to {MOST_HARMONICS}: of a mesh cycle")
        return raw

    def _state(self) -> dict[str, Any]:
        """Whether an error was measured under load, and under which torque."""
        if self.name != "error":
            for key in ("state", "torque"):
                if key in self.table:
                    self.wrong(key, "nothing here: it is for curves.error")
            return {}
        state = self._one_of("state", (UNLOADED, LOADED))
        if state == UNLOADED:
            if "torque" in self.table:
                self.wrong("torque", 'nothing here: it is for state = "loaded"')
            return {"state": state}
        if "torque" not in self.table:
            expected = 'the pinion torque of the measurement, such as "150 N m"'
            self.problems.append(Problem(f"{self.path}.torque", None, expected, missing=True))
            return {"state": state}
        try:
            return {"state": state, "torque": float(read_one(self.table["torque"], _TORQUE).value)}
        except ValueRefusedError as error:
            self.wrong("torque", error.expected, error.nearest)
            return {"state": state}

    def _unit(self) -> tuple[Dimension, float]:
        """Dimension and size of the unit of the values; without unit they are over the mean, or over D_c."""
        raw = self.table.get("unit", "")
        expected = f'a unit of it, such as "{_WHAT[self.name]}", or "" for dimensionless numbers'
        if not isinstance(raw, str):
            self.wrong("unit", expected)
            return NUMBER, 1.0
        if not raw.strip():
            return NUMBER, 1.0
        try:
            number, unit = read(f"1 {raw}")
        except UnitError:
            self.wrong("unit", expected)
            return NUMBER, 1.0
        dimension = _DIMENSION[self.name]
        if not takes(dimension, unit):
            self.wrong("unit", expected)
            return NUMBER, 1.0
        return dimension, float(in_si(dimension, Fraction(number), unit))

    @property
    def _unit_stated(self) -> bool:
        return self._unit()[0] != NUMBER

    def _value(self, key: str) -> float | None:
        """A number of the curve: in the unit of the table, or with its own."""
        raw = self.table.get(key)
        if isinstance(raw, int | float) and not isinstance(raw, bool) and isfinite(raw):
            return float(raw) * self._unit()[1]
        if isinstance(raw, str):
            return self._own_unit(key, raw)
        self.wrong(key, f'a number, or one with its unit, such as "5 {_WHAT[self.name]}"')
        return None

    def _own_unit(self, key: str, raw: str) -> float | None:
        """A value with its own unit."""
        place = Quantity(key, _DIMENSION[self.name], _WHAT[self.name], f"5 {_WHAT[self.name]}", "")
        try:
            return float(read_one(raw, place).value)
        except ValueRefusedError as error:
            self.problems.append(Problem(f"{self.path}.{key}", shown(raw), error.expected, error.nearest))
            return None

    def _in_si(self, key: str, raws: list[Any]) -> tuple[list[float] | None, bool]:
        """Values in the unit of the table, or all with their own; and whether they have one."""
        texts = [isinstance(raw, str) for raw in raws]
        if not any(texts):
            dimension, size = self._unit()
            return [size * float(raw) for raw in raws], dimension != NUMBER
        if not all(texts):
            self.wrong(key, "values that all are numbers, or all have their own unit")
            return None, True
        found = [self._own_unit(f"{key}[{at}]", raw) for at, raw in enumerate(raws)]
        known = [value for value in found if value is not None]
        return (known if len(known) == len(found) else None), True

    def _period(self) -> float | None:
        """One period in the unit of the angles."""
        period = self.table.get("over", PERIODS[0])
        shaft, size = ANGLES[self._one_of("angle", tuple(ANGLES))]
        if shaft == period:
            return size
        if period == PERIODS[0]:
            gear = shaft.partition(" ")[0]
            if gear in self.teeth:
                return size / self.teeth[gear]
            self.wrong("angle", f"cycle, or a case that states the teeth of the {gear}")
            return None
        if period in PERIODS:
            fitting = ", ".join(name for name, (of, _) in ANGLES.items() if of == period)
            self.wrong("angle", f"an angle of over = {period!r}: one of {fitting}")
        return None

    def _physical(self, *keys: str) -> bool:
        """Whether values have a unit: the table's, or their own."""
        own = any(isinstance(self.table.get(key), str) for key in keys)
        return own or self._unit()[0] != NUMBER

    def _rectangle(self) -> dict[str, Any]:
        low, high, ratio = self._value("low"), self._value("high"), self.table["contact_ratio"]
        good = isinstance(ratio, int | float) and not isinstance(ratio, bool) and 1.0 < ratio < 20.0
        if not good:
            self.wrong("contact_ratio", "a number above 1 and below 20: pairs of teeth in contact on average")
        if low is None or high is None or not good:
            return {}
        if (
            isinstance(self.table["low"], str) != isinstance(self.table["high"], str)
            and not self._unit_stated
        ):
            self.wrong("high", "a number as low is, or both with their unit")
            return {}
        part = float(ratio) % 1.0
        return {
            "physical": self._physical("low", "high"),
            "phases": [0.0, part, part, 1.0],
            "values": [high, high, low, low],
            "steps": True,
        }

    def _cosines(self) -> dict[str, Any]:
        heights, angles = self._amplitudes(), self._angles()
        if heights is None or angles is None:
            return {}
        if angles and len(angles) != len(heights):
            self.wrong("phases", f"one for each of the {len(heights)} amplitudes, in rad")
            return {}
        values, physical = self._in_si("amplitudes", heights)
        if values is None:
            return {}
        mean = self._value("mean") if "mean" in self.table else None
        if isinstance(self.table.get("mean"), str) and not physical:
            self.wrong("mean", "a number as the amplitudes are, or all with their unit")
        if self.name == "stiffness" and mean is None and physical:
            expected = "the mean, as amplitudes have a unit"
            self.problems.append(Problem(f"{self.path}.mean", None, expected, missing=True))
        return {
            "physical": physical,
            "mean": mean if mean is not None else (1.0 if self.name == "stiffness" else 0.0),
            "amplitudes": values,
            "angles": angles or [0.0] * len(heights),
            "unphased": not angles,
        }

    def _amplitudes(self) -> list[Any] | None:
        raw = self.table.get("amplitudes", [])
        if not isinstance(raw, list) or not 1 <= len(raw) <= MOST_HARMONICS or not all(map(_valued, raw)):
            expected = f"an array of 1 to {MOST_HARMONICS} values, from the first harmonic on"
            self.wrong("amplitudes", expected)
            return None
        return raw

    def _angles(self) -> list[float] | None:
        """Phases in rad, or with their own unit."""
        raw = self.table.get("phases", [])
        if not isinstance(raw, list) or len(raw) > MOST_HARMONICS or not all(map(_valued, raw)):
            self.wrong("phases", f"an array of up to {MOST_HARMONICS} phases, in rad")
            return None
        found = []
        for at, one in enumerate(raw):
            try:
                found.append(float(read_one(one, _PHASE).value) if isinstance(one, str) else float(one))
            except ValueRefusedError as error:
                self.problems.append(
                    Problem(f"{self.path}.phases[{at}]", shown(one), error.expected, error.nearest)
                )
                return None
        return found

    def _points(self, raw: object, key: str) -> dict[str, Any]:
        expected = f"an array of 2 to {MOST_POINTS:,} pairs [angle, value]"
        if not isinstance(raw, list) or not 2 <= len(raw) <= MOST_POINTS:
            self.wrong(key, expected)
            return {}
        for at, row in enumerate(raw):
            pair = isinstance(row, list | tuple) and len(row) == 2
            if not pair or not _finite(row[0]) or not _valued(row[1]):
                self.problems.append(Problem(f"{self.path}.{key}[{at}]", shown(row), "a pair [angle, value]"))
                return {}
        size, period = self._period(), self.table.get("over", PERIODS[0])
        if size is None:
            return {}
        heights, physical = self._in_si(key, [row[1] for row in raw])
        if heights is None:
            return {}
        phases, values = np.array([float(row[0]) for row in raw]) / size, np.array(heights)
        if np.any(np.diff(phases) < 0.0):
            self.wrong(key, "angles that never go back")
            return {}
        phases = closed(phases)
        length = float(phases[-1] - phases[0])
        if length > 1.0 + 1e-9 or 1.0 - length > WIDEST * float(np.max(np.diff(phases))) + 1e-9:
            self.wrong(key, f"points all round one {period} (these go over {length:.9g} of it)")
            return {}
        phases, values = begun_at_zero(phases, values)
        return {"physical": physical, "phases": phases.tolist(), "values": values.tolist()}


def closed(phases: Any) -> Any:
    """The same, where the last one is the first again but for the decimals that it was written with."""
    steps = np.diff(phases)
    beside = abs(phases[-1] - phases[0] - 1.0)
    if beside > 0.0 and beside <= CLOSING * float(np.min(steps, where=steps > 0.0, initial=np.inf)):
        phases = np.concatenate([phases[:-1], [phases[0] + 1.0]])
    return phases


def begun_at_zero(phases: Any, values: Any) -> tuple[Any, Any]:
    """The same points with phases from 0 to 1, in order."""
    whole = np.floor(phases[0] + 1e-12)
    phases = np.clip(phases - whole, 0.0, None)
    behind = phases > 1.0 + 1e-9
    turned = np.concatenate([phases[behind] - 1.0, np.minimum(phases[~behind], 1.0)])
    turned = np.maximum.accumulate(turned)  # the last point may be the first again, but for rounding
    return turned, np.concatenate([values[behind], values[~behind]])


def read_curves(raw: object, teeth: Mapping[str, int]) -> tuple[dict[str, Any], list[Problem]]:
    """The curves that a file states, by name, and every problem; ``teeth`` of each shaft, where stated."""
    if not isinstance(raw, Mapping):
        return {}, [Problem(TABLE, shown(raw), f"tables: {', '.join(f'[{TABLE}.{name}]' for name in NAMES)}")]
    found: dict[str, Any] = {}
    problems: list[Problem] = []
    for name, table in raw.items():
        if name not in NAMES:
            problems.append(
                Problem(f"{TABLE}.{name}", shown(table), "a name that exists here", nearest_name(name, NAMES))
            )
        elif not isinstance(table, Mapping):
            problems.append(Problem(f"{TABLE}.{name}", shown(table), "a table"))
        else:
            reader = CurveReader(name, table, teeth)
            curve = reader.read()
            problems += reader.problems
            if curve is not None:
                found[name] = curve
    return found, problems


def _valued(raw: object) -> bool:
    """A number, or a text that may be one with its unit."""
    return isinstance(raw, str) or _finite(raw)


def _finite(raw: object) -> bool:
    return isinstance(raw, int | float) and not isinstance(raw, bool) and abs(raw) < 1e300 and isfinite(raw)
