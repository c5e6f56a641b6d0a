"""The article's study: its claims as data, what is computed beside them, and the verdicts.

Source: "Analysis on the Characteristics of Grazing Bifurcation of Helical Gear Transmission System".
"""

from .claims import Claim, load
from .judge import NOT_FOUND, REPRODUCED, SHIFTED
from .reproduce import STAGES, Scope, reproduce
from .reproduction import ClaimRow, Diagram, Event, Reproduction, Zone

__all__ = [
    "NOT_FOUND",
    "REPRODUCED",
    "SHIFTED",
    "STAGES",
    "Claim",
    "ClaimRow",
    "Diagram",
    "Event",
    "Reproduction",
    "Scope",
    "Zone",
    "load",
    "reproduce",
]
