"""The JSON Schema of case files, one variant a kind."""

from __future__ import annotations

from typing import Any

from .head import source_schema
from .kinds import kind_named, kinds

DIALECT = "https://json-schema.org/draft/2020-12/schema"


def schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of case files."""
    definitions: dict[str, Any] = {"Source": source_schema()}
    for name in kinds():
        definitions |= kind_named(name).schema({"$ref": "#/$defs/Source"})
    pointers = {name: f"#/$defs/{name}" for name in kinds()}
    return {
        "$schema": DIALECT,
        "title": "gearlash case",
        "$defs": definitions,
        "discriminator": {"mapping": pointers, "propertyName": "kind"},
        "oneOf": [{"$ref": pointer} for pointer in pointers.values()],
    }
