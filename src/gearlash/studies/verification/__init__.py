"""The lumped model beside an independent model of bodies in space with real teeth."""

from .alike import Seen, seen_of_label, seen_of_lumped, seen_of_teeth
from .breathing import Breathing, breathing_of
from .frames import Frames, frames_of
from .inputs import Inputs, inputs_of, with_width
from .lumped import LumpedInputs, LumpedPoint
from .mesh import Mesh
from .plan import DISTANCE_HELD, Configuration, Plan, planned
from .point import PointFound
from .refused import NotVerifiableError
from .settings import Setting, sensitivity
from .whole import MOTIONS, Compared, Verification, verification

__all__ = [
    "DISTANCE_HELD",
    "MOTIONS",
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
    "Seen",
    "Setting",
    "Verification",
    "breathing_of",
    "frames_of",
    "inputs_of",
    "planned",
    "seen_of_label",
    "seen_of_lumped",
    "seen_of_teeth",
    "sensitivity",
    "verification",
    "with_width",
]
