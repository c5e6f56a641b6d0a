"""The kinds of answers by name; each is imported when it is asked for."""

from __future__ import annotations

from importlib import import_module

ANSWER_KINDS = {
    "new": "NewAnswer",
    "run": "RunAnswer",
    "check": "CheckAnswer",
    "sweep": "SweepAnswer",
    "map": "MapAnswer",
    "branch": "BranchAnswer",
    "curve": "CurveAnswer",
    "atlas": "AtlasAnswer",
    "graze": "GrazeAnswer",
    "zones": "ZonesAnswer",
    "plane_zone": "PlaneZoneAnswer",
    "report": "ReportAnswer",
    "tolerance": "ToleranceAnswer",
    "compare": "CompareAnswer",
    "verify": "VerifyAnswer",
    "reproduce": "ReproduceAnswer",
    "problem": "ProblemAnswer",
}


def answer_kind(name: str) -> type:
    """The dataclass of a kind of answer. Raises `GearlashError` naming the nearest."""
    from gearlash.system import UnknownNameError

    if name not in ANSWER_KINDS:
        raise UnknownNameError("kind of result", name, ANSWER_KINDS)
    return getattr(import_module(f"gearlash.cli.answers.{name}"), ANSWER_KINDS[name])
