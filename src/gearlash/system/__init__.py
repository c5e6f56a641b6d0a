"""Piecewise-linear systems with clearances, families of them, and statuses. Knows nothing else."""

from . import given
from .annotated import arguments
from .family import Family, Parameter
from .harmonics import Fourier, constant, cosines, derivative, evaluate, padded
from .piecewise import Clearance, ContactRule, System
from .record import Record
from .short_text import shown
from .status import BuildError, GearlashError, Named, Status, UnknownNameError

__all__ = [
    "BuildError",
    "Clearance",
    "ContactRule",
    "Family",
    "Fourier",
    "GearlashError",
    "Named",
    "Parameter",
    "Record",
    "Status",
    "System",
    "UnknownNameError",
    "arguments",
    "constant",
    "cosines",
    "derivative",
    "evaluate",
    "given",
    "padded",
    "shown",
]
