"""JSON Schema of the answers, made from their dataclasses: what is documented cannot differ from what is
printed.

A field's description is the first text in its ``Annotated``. A number that may be undefined is ``float |
None``.
"""

from __future__ import annotations

import types
from collections.abc import Mapping
from dataclasses import MISSING, fields, is_dataclass
from enum import Enum
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from gearlash.system import Label, Status

DIALECT = "https://json-schema.org/draft/2020-12/schema"
SIMPLE = {
    float: "number",
    int: "integer",
    str: "string",
    Label: "string",
    Status: "string",
    bool: "boolean",
    type(None): "null",
}


def answer_schema(answer: type) -> dict[str, Any]:
    """The schema of one kind of answer."""
    definitions: dict[str, Any] = {}
    head = _object(answer, definitions)
    return {"$schema": DIALECT, "title": f"gearlash {_title(answer)}", **head, "$defs": definitions}


def described_fields(record: type) -> list[tuple[str, Any, str]]:
    """(name, type, description) of every field of a dataclass."""
    hints = get_type_hints(record, include_extras=True)
    found = []
    for field in fields(record):
        kind, text = hints[field.name], ""
        if get_origin(kind) is Annotated:
            kind, text = get_args(kind)[:2]
        found.append((field.name, kind, text))
    return found


def _title(answer: type) -> str:
    return (answer.__doc__ or answer.__name__).split("\n")[0].rstrip(".")


def _object(record: type, definitions: dict[str, Any]) -> dict[str, Any]:
    properties = {}
    for name, kind, text in described_fields(record):
        schema = _of(kind, definitions)
        properties[name] = {**schema, "description": text} if text else schema
    required = [f.name for f in fields(record) if f.default is MISSING and f.default_factory is MISSING]
    constant = [f.name for f in fields(record) if f.name not in required]
    return {
        "type": "object",
        "description": " ".join((record.__doc__ or "").split()),
        "properties": properties,
        "required": [*required, *constant],  # what has a default is printed too
        "additionalProperties": False,
    }


def _of(kind: Any, definitions: dict[str, Any]) -> dict[str, Any]:
    """Schema of a type: of what answers are made of, and nothing else."""
    if kind in SIMPLE:
        return {"type": SIMPLE[kind]}
    if isinstance(kind, type) and is_dataclass(kind):
        if kind.__name__ not in definitions:
            definitions[kind.__name__] = {}  # holds the place: a record may contain itself
            definitions[kind.__name__] = _object(kind, definitions)
        return {"$ref": f"#/$defs/{kind.__name__}"}
    if isinstance(kind, type) and issubclass(kind, Enum):
        return {"enum": [str(member.value) for member in kind]}
    origin, inside = get_origin(kind), get_args(kind)
    if origin is Literal:
        return {"enum": list(inside)}
    if origin is Annotated:
        return {**_of(inside[0], definitions), "description": inside[1]}
    if origin in (Union, types.UnionType):
        return {"anyOf": [_of(one, definitions) for one in inside]}
    if origin is tuple and inside[-1] is Ellipsis:
        return {"type": "array", "items": _of(inside[0], definitions)}
    if origin is tuple:
        return {"type": "array", "prefixItems": [_of(one, definitions) for one in inside], "items": False}
    if origin in (dict, Mapping):
        return {"type": "object", "additionalProperties": _of(inside[1], definitions)}
    raise TypeError(f"{kind!r} has no place in an answer")
