"""The lumped model beside an independent model of bodies in space with real teeth."""

from .breathing import Breathing, breathing_of
from .frames import Frames, frames_of
from .inputs import Inputs, NotVerifiableError, inputs_of, with_width
from .lumped import LumpedInputs, LumpedPoint
from .mesh import Mesh
from .plan import DISTANCE_HELD, Configuration, Plan
from .point import PointFound
from .settings import Setting, sensitivity
from .whole import Compared, Verification, verification

__all__ = [
    "DISTANCE_HELD",
    "Breathing",
    "Compared",
    "Configuration",
    "Frames",
    "Inputs",
    "LumpedInputs",
    "LumpedPoint",
    "Mesh",
    "NotVerifiableError",
    "Plan",
    "PointFound",
    "Setting",
    "Verification",
    "breathing_of",
    "frames_of",
    "inputs_of",
    "sensitivity",
    "verification",
    "with_width",
]
