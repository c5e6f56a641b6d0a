"""Impact-free motion in spite of tolerances."""

from .study import tolerance

__all__ = ["tolerance"]
