"""Curves in two parameters along which orbits graze, fold, double or lose a pair of multipliers to the unit
circle, and the points where two such things happen at once."""

from .begin import Beginning, beginning
from .plane import Plane
from .points import CodimTwoKind, CodimTwoPoint, Curve, CurveEndKind, CurvePoint, EndOfCurve
from .whole import Listener, curve_through

__all__ = [
    "Beginning",
    "CodimTwoKind",
    "CodimTwoPoint",
    "Curve",
    "CurveEndKind",
    "CurvePoint",
    "EndOfCurve",
    "Listener",
    "Plane",
    "beginning",
    "curve_through",
]
