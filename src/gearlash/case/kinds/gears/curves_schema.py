"""The JSON Schema of the table ``[curves]``."""

from __future__ import annotations

from typing import Any

from gearlash.case.stated import Provenance

from .curves import ANGLES, LOADED, MOST_HARMONICS, MOST_POINTS, NAMES, PERIODS, UNLOADED

_NUMBER = {"anyOf": [{"type": "number"}, {"type": "string"}]}
_WHAT = {
    "stiffness": "mesh stiffness over an angle: its mean is mesh.mean_stiffness where it has a unit",
    "error": "transmission error over an angle; its mean is not used",
}


def curves_schema() -> dict[str, Any]:
    """Of ``[curves.stiffness]`` and ``[curves.error]``."""
    return {
        "type": "object",
        "description": "stiffness and error as they come: points, a file of points, a rectangle, harmonics",
        "properties": {name: _curve(name) for name in NAMES},
        "additionalProperties": False,
    }


def _curve(name: str) -> dict[str, Any]:
    numbers = {"type": "array", "items": _NUMBER, "maxItems": MOST_HARMONICS}
    pair = {"type": "array", "items": _NUMBER, "minItems": 2, "maxItems": 2}
    properties: dict[str, Any] = {
        "points": {
            "type": "array",
            "description": "pairs [angle, value]; an angle twice is a step",
            "items": pair,
            "minItems": 2,
            "maxItems": MOST_POINTS,
        },
        "file": {"type": "string", "description": "text file of two columns, beside the case file"},
        "low": {**_NUMBER, "description": "with the smaller number of tooth pairs in contact"},
        "high": {**_NUMBER, "description": "with the larger number of tooth pairs in contact"},
        "contact_ratio": {"type": "number", "description": "pairs of teeth in contact on average, above 1"},
        "mean": {**_NUMBER, "description": "beside amplitudes"},
        "amplitudes": {**numbers, "description": "of cosines, from the first harmonic on"},
        "phases": {**numbers, "description": "of these cosines, in rad or with their unit"},
        "angle": {"enum": list(ANGLES), "default": "cycle", "description": "unit of the angles"},
        "unit": {"type": "string", "description": "of the values; without, over the mean or over D_c"},
        "over": {"enum": list(PERIODS), "default": PERIODS[0], "description": "after which it repeats"},
        "harmonics": {
            "type": "integer",
            "minimum": 1,
            "maximum": MOST_HARMONICS,
            "description": "kept of a mesh cycle; without, as many as its shape needs, within limits",
        },
        "provenance": {"enum": list(Provenance)},
        "reason": {"type": "string"},
    }
    if name == "error":
        properties |= {
            "state": {
                "enum": [UNLOADED, LOADED],
                "default": UNLOADED,
                "description": "a loaded error has the stiffness in it, which is taken out",
            },
            "torque": {"type": "string", "description": "pinion torque of a loaded error"},
        }
    return {
        "type": "object",
        "description": _WHAT[name],
        "properties": properties,
        "additionalProperties": False,
    }
