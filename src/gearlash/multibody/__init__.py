"""An independent model of a gear pair: bodies in space, true flanks, compliance from finite elements.

It exists to be compared with the lumped model, and so knows nothing of it: of `gears` it takes geometry,
materials and bodies. It needs the extra `multibody` (Exudyn and scikit-fem), imported only where it is used.
"""

from .bodies import Bearings, Machine, Modes, RigidBody
from .dynamics import Contact, Motion, SimulationError, Solver, natural_frequencies, simulate
from .energy import EnergyBalance, energy_balance
from .extra import MissingExtraError, require_extra
from .line_contact import LineContact

__all__ = [
    "Bearings",
    "Contact",
    "EnergyBalance",
    "LineContact",
    "Machine",
    "MissingExtraError",
    "Modes",
    "Motion",
    "RigidBody",
    "SimulationError",
    "Solver",
    "energy_balance",
    "natural_frequencies",
    "require_extra",
    "simulate",
]
