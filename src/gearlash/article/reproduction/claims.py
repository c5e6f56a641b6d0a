"""The table of claims and Table 2, row by row."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Table2Row:
    """A row of the article's Table 2: its own words, and what was located of it.

    Attributes
    ----------
    type, condition : str
    reported_effect_p, reported_effect_qr, reported_region : str
        What the article says of the effect on P, on Q and R, and of where it occurs.
    events : tuple of str
        Some that were located; ``exponent``, ``periods`` and ``patterns`` are theirs.
    exponent : tuple of float
    periods, patterns : tuple of str
    verdict, note : str
    """

    type: str
    condition: str
    reported_effect_p: str
    reported_effect_qr: str
    reported_region: str
    events: tuple[str, ...]
    exponent: tuple[float, ...]
    periods: tuple[str, ...]
    patterns: tuple[str, ...]
    verdict: str
    note: str


@dataclass(frozen=True)
class Part:
    """One of several things that a claim says, judged by itself.

    Attributes
    ----------
    what, reported, computed, verdict, note : str
    """

    what: str
    reported: str
    computed: str
    verdict: str
    note: str


@dataclass(frozen=True)
class ClaimRow:
    """A row of the table of claims.

    Attributes
    ----------
    id, sentence, quantity, where, printed : str
        Of the claim.
    computed : str
    value, computed_value : float
        Printed and computed, as numbers; NaN where there is none.
    unit : str
    reported_labels, computed_labels : str
    deviation : float
        Relative.
    verdict, branch, note : str
        ``branch``: along which sweeps, or from which start.
    rests_on : tuple of str
        Values of the case that decide it and were not given, by path.
    needs : str
        The ways of scanning without which it does not come out; empty where each gives it.
    fitted : bool
        Open values of the case were chosen to meet this number, which then tests nothing.
    parts : tuple of Part
        What it says, where it says several things.
    """

    id: str
    sentence: str
    quantity: str
    where: str
    printed: str
    computed: str
    value: float
    computed_value: float
    unit: str
    reported_labels: str
    computed_labels: str
    deviation: float
    verdict: str
    branch: str
    note: str
    rests_on: tuple[str, ...]
    needs: str = ""
    fitted: bool = False
    parts: tuple[Part, ...] = ()
