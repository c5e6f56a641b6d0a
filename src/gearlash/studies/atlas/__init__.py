"""An atlas of a rectangle of two parameters: its curves, where they meet, and the map that checks them."""

from .whole import atlas

__all__ = ["atlas"]
