"""What every case file may say of itself, whatever its kind; and errors of pydantic in words of a case."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from functools import partial
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, TypeAdapter, ValidationError
from pydantic_core import PydanticCustomError

from .errors import MOST_SHOWN, Problem, shown
from .texts import refused, refused_name
from .words import nearest_name


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
    """Name, description and source of a case."""

    model_config = ConfigDict(extra="ignore")
    name: Name = ""
    description: Text = ""
    source: Source = Field(default_factory=Source)


KEYS = ("kind", *Head.model_fields)
"""Keys of a file that belong to no kind."""


def read_head(raw: Mapping[str, object], paths: Collection[str]) -> tuple[dict[str, Any], list[Problem]]:
    """Name, description and source of a parsed file, without what is wrong with them; ``paths`` are those
    that files of its kind may hold."""
    content: dict[str, Any] = {key: raw[key] for key in KEYS if key in raw}
    try:
        return Head.model_validate(content).model_dump(), []
    except ValidationError as error:
        errors = error.errors(include_url=False)
    for e in errors:
        content = without(content, e["loc"])
    return Head.model_validate(content).model_dump(), in_words(errors, paths)


def source_schema() -> dict[str, Any]:
    """JSON Schema of the table [source]."""
    return TypeAdapter(Source).json_schema()


def without(content: Mapping[str, Any], place: Sequence[int | str]) -> dict[str, Any]:
    """A copy of nested tables without the value at this place."""
    copy = dict(content)
    if len(place) > 1 and isinstance(copy.get(str(place[0])), Mapping):
        copy[str(place[0])] = without(copy[str(place[0])], place[1:])
    elif place:
        copy.pop(str(place[0]), None)
    return copy


def in_words(errors: Sequence[Any], paths: Collection[str]) -> list[Problem]:
    """Errors of pydantic as problems, as many as can be told; the rest is counted."""
    found = [_problem(error, paths) for error in errors[:MOST_SHOWN]]
    return found + [Problem(str(error["loc"][0]), None, "") for error in errors[MOST_SHOWN:]]


def _problem(error: Any, paths: Collection[str]) -> Problem:
    path = ".".join(str(part) for part in error["loc"])
    value = shown(error["input"])
    match error["type"]:
        case "value":
            return Problem(path, value, error["ctx"]["expected"], error["ctx"]["nearest"] or None)
        case "extra_forbidden":
            return Problem(path, value, "a name that exists here", _nearest_path(path, paths))
        case "model_type" | "model_attributes_type" | "dict_type":
            return Problem(path, value, f"a table [{path}]")
        case "list_type":
            return Problem(path, value, "a list of texts")
        case "string_type" | "string_too_long":
            return Problem(path, value, "a text of at most 20,000 characters")
        case _:
            return Problem(path, value, error["msg"].lower())


def _nearest_path(path: str, paths: Collection[str]) -> str | None:
    """The path that was probably meant: the same last name in another table, else the one looking alike."""
    every = [*paths, *(f"source.{name}" for name in Source.model_fields)]
    table, _, leaf = path.rpartition(".")
    if not table:
        return nearest_name(path, {*(p.partition(".")[0] for p in every), *KEYS})
    leaves = {p.rpartition(".")[2]: p for p in reversed(every)}
    if leaf in leaves:
        return leaves[leaf]
    here = nearest_name(leaf, [p.rpartition(".")[2] for p in every if p.startswith(f"{table}.")])
    if here is not None:
        return f"{table}.{here}"
    anywhere = nearest_name(leaf, leaves)
    return None if anywhere is None else leaves[anywhere]
