"""Piecewise-linear systems with clearances, families of them, and statuses. Knows nothing else."""

from .family import Family, Parameter
from .harmonics import Fourier, constant, cosines, derivative, evaluate, padded
from .piecewise import Clearance, ContactRule, System
from .status import GearlashError, Status, UnknownNameError

__all__ = [
    "Clearance",
    "ContactRule",
    "Family",
    "Fourier",
    "GearlashError",
    "Parameter",
    "Status",
    "System",
    "UnknownNameError",
    "constant",
    "cosines",
    "derivative",
    "evaluate",
    "padded",
]
