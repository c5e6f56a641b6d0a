"""Kinds of case, one folder each, and the door for one's own: `register`."""

from .kind import Content, Draft, Excitation, Kind
from .registry import forget, kind_named, kind_of, kinds, register, registered

__all__ = [
    "Content",
    "Draft",
    "Excitation",
    "Kind",
    "forget",
    "kind_named",
    "kind_of",
    "kinds",
    "register",
    "registered",
]
