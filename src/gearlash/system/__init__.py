"""Piecewise-linear systems with clearances, families of them, statuses and labels of motions. Knows nothing
else."""

from . import given
from .annotated import arguments
from .family import Family, Parameter
from .harmonics import Fourier, constant, cosines, derivative, evaluate, padded
from .label import Label, MotionKind, label_text, read_label
from .model import HasFamily, family_of, plain_values, short_name
from .piecewise import Clearance, ContactRule, System
from .record import Record
from .short_text import shown
from .signature import Signature
from .status import CARRIED, BuildError, GearlashError, Named, Status, UnknownNameError

__all__ = [
    "CARRIED",
    "BuildError",
    "Clearance",
    "ContactRule",
    "Family",
    "Fourier",
    "GearlashError",
    "HasFamily",
    "Label",
    "MotionKind",
    "Named",
    "Parameter",
    "Record",
    "Signature",
    "Status",
    "System",
    "UnknownNameError",
    "arguments",
    "constant",
    "cosines",
    "derivative",
    "evaluate",
    "family_of",
    "given",
    "label_text",
    "padded",
    "plain_values",
    "read_label",
    "short_name",
    "shown",
]
