"""Which cases the article's study is about: its pair, with any values of what the article leaves open."""

from __future__ import annotations

from gearlash.case import Case, CaseError, Entry, Problem, load
from gearlash.case.entries import BY_OVERRIDE

NAME = "article"  # of the bundled case
FITTED = ("window-upper", "window-lower", "period-3", "codimension-2", "back-side")
"""Claims whose printed number the open values of the bundled case were chosen to meet."""
SWEPT = ("omega", "D")  # keys that the study varies anyway
OPTIONS = "model."


def check_pair(case: Case) -> None:
    """Raises `CaseError` for a case that is not the article's pair.

    Every value of its Table 1 must be as printed there, unless an override set it. What the article leaves
    open may have any value."""
    if case.kind != (own := load(NAME)).kind:
        raise _refused(case, f"this is a {case.kind} case, not a {own.kind}")
    differing = [
        _difference(entry, case.entries.get(key))
        for key, entry in own.entries.items()
        if entry.provenance == "given"
        and not key.startswith(OPTIONS)
        and not _agrees(entry, case.entries.get(key))
    ]
    if differing:
        shown, rest = differing[:3], len(differing) - 3
        raise _refused(case, "; ".join(shown) + (f", and {rest} more values" if rest > 0 else ""))


def is_bundled(case: Case) -> bool:
    """Whether all values are those of the bundled case, speed and backlash apart: then the values that are
    not given were fitted to the claims `FITTED`."""
    return _decisive(case) == _decisive(load(NAME))


def _decisive(case: Case) -> dict[str, tuple[str, float | str]]:
    return {key: (entry.path, entry.value) for key, entry in case.entries.items() if key not in SWEPT}


def _agrees(stated: Entry, mine: Entry | None) -> bool:
    return mine is not None and (
        mine.reason == BY_OVERRIDE or (mine.path, mine.value) == (stated.path, stated.value)
    )


def _difference(stated: Entry, mine: Entry | None) -> str:
    if mine is None:
        return f"{stated.path} is not stated, in Table 1 it is {stated.text}"
    named = f"{mine.path} is {mine.text}"
    return f"{named}, in Table 1 {stated.path} is {stated.text}" if mine.path != stated.path else (
        f"{named}, in Table 1 {stated.text}"
    )  # fmt: skip


def _refused(case: Case, why: str) -> CaseError:
    expected = (
        "the article's pair, or a variation of it: what its Table 1 states, changed by --set at most, and "
        f"any values of what the article leaves open ({why}). For any other pair use gearlash run, "
        "sweep, zones, graze or map"
    )
    return CaseError(case.name, [Problem("CASE", repr(case.name), expected)])
