"""A validator for the part of JSON Schema (2020-12) that answers use, written from its specification."""

from __future__ import annotations

from typing import Any

TYPES = {
    "object": dict,
    "array": list,
    "string": str,
    "boolean": bool,
    "null": type(None),
    "integer": int,
    "number": (int, float),
}
KNOWN = {
    "type",
    "properties",
    "required",
    "additionalProperties",
    "items",
    "prefixItems",
    "enum",
    "anyOf",
    "$ref",
}
WORDS = {"examples", "$schema", "$defs", "title", "description"}


def problems(
    value: Any, schema: dict[str, Any], root: dict[str, Any] | None = None, at: str = "$"
) -> list[str]:
    """Every place where the value breaks the schema."""
    root = schema if root is None else root
    unknown = set(schema) - KNOWN - WORDS
    assert not unknown, f"this validator does not know {unknown}"
    found: list[str] = []
    if "$ref" in schema:
        found += problems(value, _pointed(root, schema["$ref"]), root, at)
    if "anyOf" in schema and all(problems(value, one, root, at) for one in schema["anyOf"]):
        found.append(f"{at}: {value!r} fits none of {schema['anyOf']}")
    if "enum" in schema and value not in schema["enum"]:
        found.append(f"{at}: {value!r} is not one of {schema['enum']}")
    if "type" in schema and not _is(value, schema["type"]):
        return [*found, f"{at}: {value!r} is no {schema['type']}"]
    if isinstance(value, dict):
        found += _object(value, schema, root, at)
    if isinstance(value, list):
        found += _array(value, schema, root, at)
    return found


def _is(value: Any, name: str) -> bool:
    if isinstance(value, bool):
        return name == "boolean"
    return isinstance(value, TYPES[name])


def _object(value: dict[str, Any], schema: dict[str, Any], root: dict[str, Any], at: str) -> list[str]:
    properties, rest = schema.get("properties", {}), schema.get("additionalProperties", True)
    found = [f"{at}: {name} is missing" for name in schema.get("required", []) if name not in value]
    for name, item in value.items():
        if name in properties:
            found += problems(item, properties[name], root, f"{at}.{name}")
        elif rest is False:
            found.append(f"{at}: {name} is not described")
        elif rest is not True:
            found += problems(item, rest, root, f"{at}.{name}")
    return found


def _array(value: list[Any], schema: dict[str, Any], root: dict[str, Any], at: str) -> list[str]:
    first = schema.get("prefixItems", [])
    found = [
        p
        for i, (x, s) in enumerate(zip(value, first, strict=False))
        for p in problems(x, s, root, f"{at}[{i}]")
    ]
    rest, items = value[len(first) :], schema.get("items", True)
    if items is False and rest:
        found.append(f"{at}: more than {len(first)} items")
    if isinstance(items, dict):
        found += [p for i, x in enumerate(rest) for p in problems(x, items, root, f"{at}[{len(first) + i}]")]
    return found


def _pointed(root: dict[str, Any], pointer: str) -> dict[str, Any]:
    here = root
    for part in pointer.removeprefix("#/").split("/"):
        here = here[part]
    return here
