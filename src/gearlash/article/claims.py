"""The article's claims as data."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib.resources import files
from typing import Any

from gearlash.system import GearlashError

KINDS = ("grazing", "codimension-2", "exponent", "zone", "insensitive", "routes", "label")


@dataclass(frozen=True)
class Claim:
    """One claim: what the article says (``sentence``), of which quantity, where (``fixed``), and what it
    printed.

    ``below`` and ``above`` are the labels on both sides of a boundary for a rising parameter; ``value`` its
    place; ``interval`` a zone; ``of`` the claim whose event an exponent belongs to; ``sign`` of that exponent
    (0: about zero); ``at`` and ``label`` a motion at one place. What does not apply is None or empty."""

    id: str
    title: str
    kind: str
    sentence: str
    quantity: str
    printed: str
    parameter: str = ""
    fixed: Mapping[str, float] = field(default_factory=dict)
    value: float | None = None
    below: str = ""
    above: str = ""
    either_order: bool = False
    boundary: int = 0
    type: str = ""
    portrait: bool = False
    of: str = ""
    sign: int | None = None
    zone: str = ""
    interval: tuple[float, float] | None = None
    at: float | None = None
    label: str = ""


def load() -> tuple[Claim, ...]:
    """The claims that come with the package, in the order of the article's events."""
    text = (files("gearlash.article") / "claims.toml").read_text(encoding="utf-8")
    return tuple(_claim(table) for table in tomllib.loads(text)["claim"])


def _claim(table: dict[str, Any]) -> Claim:
    if table.get("kind") not in KINDS:
        raise GearlashError(
            f"claim {table.get('id')!r}: kind {table.get('kind')!r}, expected one of {', '.join(KINDS)}"
        )
    if "interval" in table:
        table = {**table, "interval": tuple(table["interval"])}
    return Claim(**table)
