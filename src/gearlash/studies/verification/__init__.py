"""The lumped model beside an independent model of bodies in space with real teeth."""

from .inputs import Inputs, NotVerifiableError, inputs_of
from .lumped import LumpedInputs, LumpedPoint
from .mesh import Mesh
from .plan import Configuration, Plan
from .point import PointFound
from .settings import Setting, sensitivity
from .whole import Compared, Verification, verification

__all__ = [
    "Compared",
    "Configuration",
    "Inputs",
    "LumpedInputs",
    "LumpedPoint",
    "Mesh",
    "NotVerifiableError",
    "Plan",
    "PointFound",
    "Setting",
    "Verification",
    "inputs_of",
    "sensitivity",
    "verification",
]
