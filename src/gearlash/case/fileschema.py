"""The shape of a case file: pydantic models made from the list of quantities, their errors, and the JSON
Schema."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, partial
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    TypeAdapter,
    ValidationError,
    WithJsonSchema,
    create_model,
)
from pydantic_core import PydanticCustomError

from .errors import MOST_SHOWN, Problem, nearest_name, shown
from .piecewise.fileschema import definitions, piecewise_schema
from .quantities import GEAR_KINDS, KINDS, PIECEWISE, choices, quantities
from .quantity import Choice, Quantity
from .stated import Provenance, Stated, ValueRefusedError, read_stated
from .texts import refused, refused_name
from .units import NAMES


def _held(text: str, rule: Callable[[str], str | None]) -> str:
    expected = rule(text)
    if expected:
        raise PydanticCustomError("value", "expected {expected}", {"expected": expected, "nearest": ""})
    return text


Text = Annotated[str, Field(max_length=20_000), AfterValidator(partial(_held, rule=refused))]
Name = Annotated[str, Field(max_length=20_000), AfterValidator(partial(_held, rule=refused_name))]


class Source(BaseModel):
    """Where a case is from."""

    model_config = ConfigDict(extra="forbid", strict=True)
    title: Text = ""
    authors: list[Text] = []
    doi: Text = ""
    url: Text = ""
    note: Text = ""


class Head(BaseModel):
    """What every file may say of itself, whatever its kind."""

    model_config = ConfigDict(extra="ignore")
    name: Name = ""
    description: Text = ""
    source: Source = Field(default_factory=Source)


@cache
def case_model(kind: str) -> type[BaseModel]:
    """The pydantic model of a whole file of this kind."""
    tables: dict[str, dict[str, Any]] = {}
    for place in (*quantities(kind).values(), *choices(kind).values()):
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


class Checked(NamedTuple):
    """What a parsed file holds: stated values by path, the rest (name, description, source), paths whose
    value is not usable, and every problem."""

    kind: str
    stated: dict[str, Stated]
    rest: dict[str, object]
    wrong: frozenset[str]
    problems: list[Problem]


def check(raw: Mapping[str, object]) -> Checked:
    """A parsed file held against the schema. ``kind`` is empty when it cannot even be guessed."""
    kind, problems = kind_of(raw)
    if kind is None:
        return Checked("", {}, {}, frozenset(), problems)
    content: dict[str, Any] = {**raw, "kind": kind}
    try:
        return Checked(kind, *_contents(kind, content), frozenset(), problems)
    except ValidationError as error:
        errors = error.errors(include_url=False)
    found = _problems(kind, errors)
    for e in errors:  # without what is wrong, the rest can be read and searched for more problems
        content = _without(content, [part for part in e["loc"] if part != kind])
    named = [path for p in found for path in (p.path, p.nearest or "")]
    wrong = frozenset(path for path in named if path in quantities(kind))
    try:
        stated, rest = _contents(kind, content)
    except ValidationError:
        stated, rest = {}, {}
        wrong = frozenset(quantities(kind))
    return Checked(kind, stated, rest, wrong, problems + found)


def check_head(kind: str, raw: Mapping[str, object]) -> tuple[dict[str, object], list[Problem]]:
    """Name, description and source of a parsed file, without what is wrong with them."""
    try:
        return Head.model_validate(raw).model_dump(), []
    except ValidationError as error:
        errors = error.errors(include_url=False)
    content: dict[str, Any] = dict(raw)
    for e in errors:
        content = _without(content, e["loc"])
    return Head.model_validate(content).model_dump(), _problems(kind, errors)


def _contents(kind: str, content: Mapping[str, object]) -> tuple[dict[str, Stated], dict[str, object]]:
    model = case_model(kind).model_validate(content)
    stated = {}
    for table in {path.partition(".")[0] for path in (*quantities(kind), *choices(kind))}:
        fields = getattr(model, table)
        for leaf in fields.model_fields_set if fields is not None else ():
            stated[f"{table}.{leaf}"] = getattr(fields, leaf)
    rest: dict[str, object] = {name: getattr(model, name) for name in ("name", "description")}
    rest["source"] = model.source.model_dump()  # pyright: ignore[reportAttributeAccessIssue]
    return stated, rest


def _without(content: Mapping[str, Any], loc: Sequence[int | str]) -> dict[str, Any]:
    """A copy of nested tables without the value at this place."""
    copy = dict(content)
    if len(loc) > 1 and isinstance(copy.get(str(loc[0])), Mapping):
        copy[str(loc[0])] = _without(copy[str(loc[0])], loc[1:])
    elif loc:
        copy.pop(str(loc[0]), None)
    return copy


def schema() -> dict[str, Any]:
    """JSON Schema (2020-12) of case files, one variant a kind."""
    union: Any = Annotated[
        case_model(GEAR_KINDS[0]) | case_model(GEAR_KINDS[1]),  # pyright: ignore[reportOperatorIssue]
        Field(discriminator="kind"),
    ]
    found = TypeAdapter(union).json_schema()
    pointer = f"#/$defs/{PIECEWISE}"
    found["$defs"] |= {PIECEWISE: piecewise_schema({"$ref": "#/$defs/Source"}), **definitions()}
    found["discriminator"]["mapping"][PIECEWISE] = pointer
    found["oneOf"].append({"$ref": pointer})
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "gearlash case", **found}


def _annotations(place: Quantity | Choice) -> Iterable[object]:
    return BeforeValidator(partial(_validated, place=place)), WithJsonSchema(_json_schema(place))


def _validated(raw: object, place: Quantity | Choice) -> Stated:
    try:
        return read_stated(raw, place)
    except ValueRefusedError as error:
        context = {"expected": error.expected, "nearest": error.nearest or ""}
        raise PydanticCustomError("value", "expected {expected}", context) from None


def _json_schema(place: Quantity | Choice) -> dict[str, Any]:
    if isinstance(place, Choice):
        plain: list[dict[str, Any]] = [{"enum": list(place.choices)}]
    elif place.integer:
        plain = [{"type": "integer", "minimum": place.lower, "maximum": place.upper}, {"type": "string"}]
    elif place.bare:
        plain = [{"type": "number"}, {"type": "string"}]
    else:
        plain = [{"type": "string", "description": f"{NAMES[place.dimension]} with its unit"}]
    table = {
        "type": "object",
        "properties": {
            "value": {"anyOf": plain},
            "provenance": {"enum": list(Provenance)},
            "reason": {"type": "string"},
        },
        "required": ["value"],
        "additionalProperties": False,
    }
    result = {"anyOf": [*plain, table], "description": place.description}
    if isinstance(place, Choice):
        return {**result, "default": place.default}
    return {**result, "examples": [place.example]}


def kind_of(raw: Mapping[str, object]) -> tuple[str | None, list[Problem]]:
    """The kind to read the file as, guessing the nearest one when it is misspelt so that all else is
    checked too."""
    expected = f"one of {', '.join(KINDS)}"
    kind = raw.get("kind")
    if kind is None:
        return None, [Problem("kind", None, f"{expected}, as the first line of a case", missing=True)]
    if isinstance(kind, str) and kind in KINDS:
        return kind, []
    near = nearest_name(kind, KINDS) if isinstance(kind, str) else None
    return near, [Problem("kind", shown(kind), expected, near)]


def _problems(kind: str, errors: Sequence[Any]) -> list[Problem]:
    """In words, as many as can be told; the rest is counted."""
    found = [_problem(kind, error) for error in errors[:MOST_SHOWN]]
    return found + [Problem(str(error["loc"][0]), None, "") for error in errors[MOST_SHOWN:]]


def _problem(kind: str, error: Any) -> Problem:
    path = ".".join(str(part) for part in error["loc"] if part != kind)
    value = shown(error["input"])
    match error["type"]:
        case "value":
            return Problem(path, value, error["ctx"]["expected"], error["ctx"]["nearest"] or None)
        case "extra_forbidden":
            return Problem(path, value, "a name that exists here", _nearest_path(kind, path))
        case "model_type" | "model_attributes_type" | "dict_type":
            return Problem(path, value, f"a table [{path}]")
        case "list_type":
            return Problem(path, value, "a list of texts")
        case "string_type" | "string_too_long":
            return Problem(path, value, "a text of at most 20,000 characters")
        case _:
            return Problem(path, value, error["msg"].lower())


def _nearest_path(kind: str, path: str) -> str | None:
    """The path that was probably meant: the same last name in another table, else the one looking alike."""
    own = () if kind == PIECEWISE else (*quantities(kind), *choices(kind))
    every = [*own, *(f"source.{name}" for name in Source.model_fields)]
    table, _, leaf = path.rpartition(".")
    if not table:
        top = {p.partition(".")[0] for p in every}
        return nearest_name(path, {*top, "name", "description", "kind", "source"})
    leaves = {p.rpartition(".")[2]: p for p in reversed(every)}
    if leaf in leaves:
        return leaves[leaf]
    here = nearest_name(leaf, [p.rpartition(".")[2] for p in every if p.startswith(f"{table}.")])
    if here is not None:
        return f"{table}.{here}"
    anywhere = nearest_name(leaf, leaves)
    return None if anywhere is None else leaves[anywhere]
