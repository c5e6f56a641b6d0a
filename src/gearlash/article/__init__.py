"""The article's study: its claims as data, what is computed beside them, and the verdicts.

It uses the library as anybody would. Everything here is imported when it is first used.

Source: "Analysis on the Characteristics of Grazing Bifurcation of Helical Gear Transmission System".
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:  # the same list for type checkers; a test keeps the two equal
    from .claims import Claim as Claim
    from .claims import load as load
    from .judge import NOT_FOUND as NOT_FOUND
    from .judge import REPRODUCED as REPRODUCED
    from .judge import SHIFTED as SHIFTED
    from .kinds import table2_type as table2_type
    from .reproduction import BearingMode as BearingMode
    from .reproduction import Centre as Centre
    from .reproduction import CentreLine as CentreLine
    from .reproduction import CentrePlace as CentrePlace
    from .reproduction import Check as Check
    from .reproduction import ClaimRow as ClaimRow
    from .reproduction import Coexisting as Coexisting
    from .reproduction import Coincidence as Coincidence
    from .reproduction import Diagram as Diagram
    from .reproduction import DiagramMark as DiagramMark
    from .reproduction import End as End
    from .reproduction import Event as Event
    from .reproduction import Explained as Explained
    from .reproduction import Opening as Opening
    from .reproduction import Part as Part
    from .reproduction import Reading as Reading
    from .reproduction import ReportedZone as ReportedZone
    from .reproduction import Reproduction as Reproduction
    from .reproduction import RuleEffect as RuleEffect
    from .reproduction import RuleGrazing as RuleGrazing
    from .reproduction import RuleLabel as RuleLabel
    from .reproduction import Run as Run
    from .reproduction import Scan as Scan
    from .reproduction import Stretch as Stretch
    from .reproduction import Table2Row as Table2Row
    from .reproduction import Together as Together
    from .scope import Scope as Scope
    from .stages import STAGES as STAGES
    from .study import reproduce as reproduce

_WHERE = {
    "claims": ("Claim", "load"),
    "judge": ("NOT_FOUND", "REPRODUCED", "SHIFTED"),
    "kinds": ("table2_type",),
    "reproduction": (
        "BearingMode",
        "Centre",
        "CentreLine",
        "CentrePlace",
        "Check",
        "ClaimRow",
        "Coexisting",
        "Coincidence",
        "Diagram",
        "End",
        "Event",
        "DiagramMark",
        "Opening",
        "Part",
        "Reading",
        "Reproduction",
        "RuleEffect",
        "RuleLabel",
        "Run",
        "Explained",
        "Scan",
        "Stretch",
        "Together",
        "Table2Row",
        "RuleGrazing",
        "ReportedZone",
    ),
    "scope": ("Scope",),
    "stages": ("STAGES",),
    "study": ("reproduce",),
}

__all__ = [
    "NOT_FOUND",
    "REPRODUCED",
    "SHIFTED",
    "STAGES",
    "BearingMode",
    "Centre",
    "CentreLine",
    "CentrePlace",
    "Check",
    "Claim",
    "ClaimRow",
    "Coexisting",
    "Coincidence",
    "Diagram",
    "DiagramMark",
    "End",
    "Event",
    "Explained",
    "Opening",
    "Part",
    "Reading",
    "ReportedZone",
    "Reproduction",
    "RuleEffect",
    "RuleGrazing",
    "RuleLabel",
    "Run",
    "Scan",
    "Scope",
    "Stretch",
    "Table2Row",
    "Together",
    "load",
    "reproduce",
    "table2_type",
]


def __getattr__(name: str) -> Any:
    from importlib import import_module

    for module, names in _WHERE.items():
        if name in names:
            value = getattr(import_module(f"{__name__}.{module}"), name)
            globals()[name] = value
            return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
