"""What the article's study came to: plain data, ready to be shown. All numbers are dimensionless."""

from .branches import Explained, Scan, Stretch, Together
from .centre import Centre, CentreLine, CentrePlace
from .claims import ClaimRow, Part, Table2Row
from .events import Coincidence, Event, Opening
from .rules import BearingMode, RuleEffect, RuleGrazing, RuleLabel
from .whole import Check, Diagram, DiagramMark, Reproduction, Run
from .zones import Coexisting, End, Reading, ReportedZone

NAN = float("nan")

__all__ = [
    "NAN",
    "BearingMode",
    "Centre",
    "CentreLine",
    "CentrePlace",
    "Check",
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
    "Stretch",
    "Table2Row",
    "Together",
]
