"""Files made of tables with listed places: a pydantic model from the list, its errors, its JSON Schema."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    ValidationError,
    WithJsonSchema,
    create_model,
)
from pydantic_core import PydanticCustomError

from gearlash.case.errors import Problem
from gearlash.case.head import Name, Source, Text, in_words, without
from gearlash.case.quantity import Choice
from gearlash.case.stated import Provenance, Stated, ValueRefusedError, read_stated
from gearlash.case.units import DIMENSION_NAMES

from .listed import Place, Places

_made: dict[str, Tables] = {}


class Found(NamedTuple):
    """What the tables of a file hold: stated values by path, paths whose value is not usable, and every
    problem."""

    stated: dict[str, Stated]
    present: frozenset[str]
    problems: list[Problem]


class Tables:
    """Files of one kind, with a value at any of these places and at no other."""

    def __init__(self, kind: str, places: Places):
        self.kind, self.places = kind, places
        self._model = _model(kind, places)

    def read(self, tables: Mapping[str, object]) -> Found:
        """The tables of a parsed file held against the model."""
        content: dict[str, Any] = {**tables, "kind": self.kind}
        try:
            return Found(self._stated(content), frozenset(), [])
        except ValidationError as error:
            errors = error.errors(include_url=False)
        problems = in_words(errors, self.places)
        for e in errors:  # without what is wrong, the rest can be read and searched for more problems
            content = without(content, e["loc"])
        named = [path for p in problems for path in (p.path, p.nearest or "")]
        try:
            return Found(self._stated(content), frozenset(named) & frozenset(self.places), problems)
        except ValidationError:
            return Found({}, frozenset(self.places), problems)

    def schema(self, source: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
        """JSON Schemas of a whole file and of its tables; ``source`` is that of the table [source]."""
        whole = self._model.model_json_schema()
        parts: dict[str, Any] = whole.pop("$defs")
        del parts[Source.__name__]
        whole["properties"]["source"] = dict(source)
        return {self.kind: whole, **parts}

    def _stated(self, content: Mapping[str, object]) -> dict[str, Stated]:
        model = self._model.model_validate(content)
        stated = {}
        for table in {path.partition(".")[0] for path in self.places}:
            fields = getattr(model, table)
            for leaf in fields.model_fields_set if fields is not None else ():
                stated[f"{table}.{leaf}"] = getattr(fields, leaf)
        return stated


def tables_of(kind: str, places: Places) -> Tables:
    """The tables of a kind, made once."""
    if kind not in _made or _made[kind].places is not places:
        _made[kind] = Tables(kind, places)
    return _made[kind]


def _model(kind: str, places: Places) -> type[BaseModel]:
    """The pydantic model of a whole file of this kind."""
    tables: dict[str, dict[str, Any]] = {}
    for place in places.values():
        table, _, leaf = place.path.partition(".")
        tables.setdefault(table, {})[leaf] = (Annotated[Any, *_annotations(place)], None)
    config = ConfigDict(extra="forbid")
    models: dict[str, Any] = {
        name: (create_model(f"{kind} {name}", __config__=config, **fields), None)
        for name, fields in tables.items()
    }
    head: dict[str, Any] = {
        "kind": (Literal[kind], ...),  # pyright: ignore[reportInvalidTypeForm]
        "name": (Name, ""),
        "description": (Text, ""),
        "source": (Source, Field(default_factory=Source)),
    }
    return create_model(kind, __config__=config, **head, **models)


def _annotations(place: Place) -> Iterable[object]:
    return BeforeValidator(partial(_validated, place=place)), WithJsonSchema(_json_schema(place))


def _validated(raw: object, place: Place) -> Stated:
    try:
        return read_stated(raw, place)
    except ValueRefusedError as error:
        context = {"expected": error.expected, "nearest": error.nearest or ""}
        raise PydanticCustomError("value", "expected {expected}", context) from None


def _limits_schema(plain: list[dict[str, Any]]) -> dict[str, Any]:
    """Two limits as an array; as one text they are a string like any value with its unit."""
    return {
        "type": "array",
        "items": {"anyOf": plain},
        "minItems": 2,
        "maxItems": 2,
        "description": "both limits, the smaller one first",
    }


def _json_schema(place: Place) -> dict[str, Any]:
    if isinstance(place, Choice):
        plain: list[dict[str, Any]] = [{"enum": list(place.choices)}]
        plain += [{"type": "string"}] if place.reader is not None else []
    elif place.integer:
        plain = [{"type": "integer", "minimum": place.lower, "maximum": place.upper}, {"type": "string"}]
    elif place.bare:
        plain = [{"type": "number"}, {"type": "string"}]
    else:
        plain = [{"type": "string", "description": f"{DIMENSION_NAMES[place.dimension]} with its unit"}]
    limits = [] if isinstance(place, Choice) or place.integer or place.alone else [_limits_schema(plain)]
    table = {
        "type": "object",
        "properties": {
            "value": {"anyOf": plain},
            **({"range": {"anyOf": [*limits, {"type": "string"}]}} if limits else {}),
            "provenance": {"enum": list(Provenance)},
            "reason": {"type": "string"},
        },
        **(
            {"anyOf": [{"required": ["value"]}, {"required": ["range"]}]}
            if limits
            else {"required": ["value"]}
        ),
        "additionalProperties": False,
    }
    result = {"anyOf": [*plain, *limits, table], "description": place.description}
    if isinstance(place, Choice):
        return {**result, "default": place.default}
    return {**result, "examples": [place.example]}
