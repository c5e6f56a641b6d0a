"""Kinds of case, one folder each; `register` adds one of your own."""

from gearlash.case.quantity import Choice, Quantity
from gearlash.case.units import Dimension

from .kind import Content, Draft, Excitation, Kind
from .registry import forget, is_between_teeth, kind_named, kind_of, kinds, register, registered

__all__ = [
    "Choice",
    "Content",
    "Dimension",
    "Draft",
    "Excitation",
    "Kind",
    "Quantity",
    "forget",
    "is_between_teeth",
    "kind_named",
    "kind_of",
    "kinds",
    "register",
    "registered",
]
