"""What the article's study came to: plain data, ready to be shown. All numbers are dimensionless."""

from .claims import ClaimRow, Part, Table2Row
from .events import Coincidence, Event, Opening
from .rules import BearingMode, RuleEffect, RuleLabel, Touch
from .whole import Check, Diagram, Mark, Reproduction, Run
from .zones import Coexisting, End, Reading, Zone

NAN = float("nan")

__all__ = [
    "NAN",
    "BearingMode",
    "Check",
    "ClaimRow",
    "Coexisting",
    "Coincidence",
    "Diagram",
    "End",
    "Event",
    "Mark",
    "Opening",
    "Part",
    "Reading",
    "Reproduction",
    "RuleEffect",
    "RuleLabel",
    "Run",
    "Table2Row",
    "Touch",
    "Zone",
]
