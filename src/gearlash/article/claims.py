"""The article's claims as data."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib.resources import files
from typing import Any

from gearlash.system import GearlashError

CLAIM_KINDS = ("grazing", "codimension-2", "exponent", "zone", "insensitive", "routes", "label")


@dataclass(frozen=True)
class Claim:
    """One claim of the article. What does not apply to its kind is None or empty.

    Attributes
    ----------
    id, title : str
    kind : str
        One of `CLAIM_KINDS`; it decides how the claim is judged.
    sentence : str
        What the article says, in its words.
    quantity : str
        What it says it about.
    printed : str
        The number as printed.
    parameter : str
        Short name of the parameter along which it is looked for.
    fixed : mapping of str to float
        Values of the other parameters.
    value : float or None
        Place of a boundary between two motions.
    below, above : str
        Labels on both sides of it, for a rising parameter.
    either_order : bool
        The article does not say which label is on which side.
    boundary : int
        That is touched: +1 (Σ1), -1 (Σ2).
    type : str
        Of the bifurcation, as in Table 2.
    portrait : bool
        Motions around it are drawn.
    of : str
        Id of the claim whose event an exponent belongs to.
    sign : int or None
        Of that exponent; 0 is about zero.
    zone : str
        What kind of zone ``interval`` is.
    interval : (float, float) or None
    at : float or None
        Place of a motion with the label ``label``.
    """

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
    """The claims that come with the package.

    Returns
    -------
    tuple of Claim
        In the order of the article's events.

    Examples
    --------
    >>> from gearlash.article import load
    >>> claim = next(claim for claim in load() if claim.kind == "codimension-2")
    >>> claim.parameter, claim.printed
    ('D', '0.3523')
    """
    text = (files("gearlash.article") / "claims.toml").read_text(encoding="utf-8")
    return tuple(_claim(table) for table in tomllib.loads(text)["claim"])


def _claim(table: dict[str, Any]) -> Claim:
    if table.get("kind") not in CLAIM_KINDS:
        raise GearlashError(
            f"claim {table.get('id')!r}: kind {table.get('kind')!r}, expected one of {', '.join(CLAIM_KINDS)}"
        )
    if "interval" in table:
        table = {**table, "interval": tuple(table["interval"])}
    return Claim(**table)
