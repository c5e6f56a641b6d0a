"""Cases of kind ``piecewise-linear``: any system of the class, in plain arrays with named parameters."""

from .kind import KIND

__all__ = ["KIND"]
