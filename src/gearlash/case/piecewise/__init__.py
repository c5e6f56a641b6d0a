"""Cases of kind ``piecewise-linear``: any system of the class, in plain arrays with named parameters."""

from .checks import contradictions
from .file import Content, Structure, read
from .model import family, ordered
from .places import override, resolve
from .values import values

__all__ = [
    "Content",
    "Structure",
    "contradictions",
    "family",
    "ordered",
    "override",
    "read",
    "resolve",
    "values",
]
