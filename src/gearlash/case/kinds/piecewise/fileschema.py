"""The JSON Schema of a piecewise-linear case file."""

from __future__ import annotations

from typing import Any

from gearlash.case.stated import Provenance
from gearlash.system import ContactRule

from .file import MOST_CYCLES, MOST_STATES
from .places import CONTACT
from .reading import HIGHEST_ORDER, MOST_HARMONICS

NUMBER_SCHEMA = "piecewise-linear number"
SERIES_SCHEMA = "piecewise-linear series"
VECTOR = "piecewise-linear vector"
_TEXT = {"type": "string", "maxLength": 20_000}


def _ref(name: str) -> dict[str, Any]:
    return {"$ref": f"#/$defs/{name}"}


def _table(description: str, properties: dict[str, Any], required: tuple[str, ...] = ()) -> dict[str, Any]:
    found = {"type": "object", "description": description, "properties": properties}
    return {**found, "required": list(required), "additionalProperties": False}


def _by_state(what: str, item: dict[str, Any]) -> dict[str, Any]:
    table = {"type": "object", "additionalProperties": item}
    return {"description": what, "anyOf": [table, {"type": "array", "items": item}]}


def definitions() -> dict[str, dict[str, Any]]:
    """The parts that `piecewise_schema` points to."""
    numbers = {"type": "array", "items": _ref(NUMBER_SCHEMA), "maxItems": MOST_HARMONICS}
    order = {"type": "integer", "minimum": 1, "maximum": HIGHEST_ORDER}
    series = {
        "mean": _ref(NUMBER_SCHEMA),
        "cos": numbers,
        "sin": numbers,
        "amplitudes": numbers,
        "phases": numbers,
        "orders": {"type": "array", "items": order, "maxItems": MOST_HARMONICS},
    }
    what = (
        "mean + Σ cos_i cos(n_i θ/cycles) + sin_i sin(n_i θ/cycles), or "
        "mean + Σ amplitude_i cos(n_i θ/cycles + phase_i); n_i are the orders, 1, 2, 3 … unless stated"
    )
    text = {"type": "string", "description": "an expression of parameters and definitions"}
    return {
        NUMBER_SCHEMA: {"title": NUMBER_SCHEMA, "anyOf": [{"type": "number"}, text]},
        SERIES_SCHEMA: {"title": SERIES_SCHEMA, "anyOf": [{"type": "number"}, text, _table(what, series)]},
        VECTOR: {
            "title": VECTOR,
            **_by_state("a number a state: by name, or all in order", _ref(NUMBER_SCHEMA)),
        },
    }


def piecewise_schema(source: dict[str, Any]) -> dict[str, Any]:
    """The schema of a whole file; ``source`` is that of its table [source]."""
    properties: dict[str, Any] = {
        "kind": {"const": "piecewise-linear"},
        "name": _TEXT,
        "description": _TEXT,
        "source": source,
        "states": {
            "type": "array",
            "description": "names of the states",
            "items": {"type": "string"},
            "minItems": 1,
            "maxItems": MOST_STATES,
        },
        "cycles": {
            "type": "integer",
            "description": "cycles of ω in the base period",
            "minimum": 1,
            "maximum": MOST_CYCLES,
            "default": 1,
        },
        "parameters": {
            "type": "object",
            "description": "named numbers to set and to vary; omega is one of them",
            "additionalProperties": {"anyOf": [{"type": "number"}, {"type": "string"}, _parameter()]},
            "required": ["omega"],
        },
        "definitions": {
            "type": "object",
            "description": "names for expressions, each of parameters and of definitions before it",
            "additionalProperties": _ref(NUMBER_SCHEMA),
        },
        "matrix": _by_state("the rows of M in z' = M z + b(θ) + Σ g Φ", _ref(VECTOR)),
        "forcing": _by_state("b(θ), a Fourier series a state", _ref(SERIES_SCHEMA)),
        "initial": {**_ref(VECTOR), "description": "the cold start; zero where nothing is stated"},
        "clearance": {"type": "array", "items": _clearance(), "minItems": 1},
    }
    required = ("kind", "states", "parameters", "matrix", "clearance")
    return {"title": "piecewise-linear", **_table("", properties, required)}


def _parameter() -> dict[str, Any]:
    properties = {
        "value": {"anyOf": [{"type": "number"}, {"type": "string"}]},
        "provenance": {"enum": list(Provenance)},
        "reason": {"type": "string"},
        "description": {"type": "string", "maxLength": 1000},
        "lower": {"type": "number"},
        "upper": {"type": "number"},
    }
    return _table("a default with its range, meaning and where it is from", properties, ("value",))


def _clearance() -> dict[str, Any]:
    number, series, vector = _ref(NUMBER_SCHEMA), _ref(SERIES_SCHEMA), _ref(VECTOR)
    properties = {
        "name": {"type": "string"},
        "h": {**vector, "description": "the gap coordinate is X = h·z - offset"},
        "g": {**vector, "description": "z' = … + g Φ, Φ the contact force"},
        "gap_plus": {**number, "description": "contact of side + is X > gap_plus"},
        "gap_minus": {**number, "description": "contact of side - is X < -gap_minus"},
        "stiffness_plus": {**series, "description": "stiffness of side +"},
        "stiffness_minus": {**series, "description": "stiffness of side -; 0: none"},
        "damping": {
            **number,
            "description": "damping of both sides; a side without stiffness does not take it over from one "
            "that has stiffness",
            "default": 0.0,
        },
        "damping_minus": {
            **number,
            "description": "damping of side -, which acts even without stiffness; damping is that of side + "
            "alone then",
        },
        "offset": {**series, "description": "e(θ)", "default": 0.0},
        "contact": {
            "enum": [rule.value for rule in ContactRule],
            "description": CONTACT,
            "default": "always",
        },
    }
    required = ("name", "h", "g", "gap_plus", "gap_minus", "stiffness_plus", "stiffness_minus")
    return _table("one gap with its two sides", properties, required)
