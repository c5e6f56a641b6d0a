"""An independent model of a gear pair: bodies in space, true flanks, compliance from finite elements.

It exists to be compared with the lumped model, and so knows nothing of it: of `gears` it takes geometry,
materials and bodies. It needs the extra `multibody` (Exudyn and scikit-fem), imported only where it is used.
"""

from .bodies import Bearings, Machine, Modes, RigidBody
from .contact import Details, MeshContact, RimModes
from .dynamics import Contact, Trajectory, natural_frequencies, simulate
from .energy import EnergyBalance, energy_balance
from .extra import MissingExtraError, require_extra
from .flanks import Flanks
from .line_contact import LineContact
from .quasi_static import QuasiStatic, quasi_static
from .reading import Reading, read_motion
from .solvers import SimulationError, Solver
from .topography import Relief, Topography

__all__ = [
    "Bearings",
    "Contact",
    "Details",
    "EnergyBalance",
    "Flanks",
    "LineContact",
    "Machine",
    "MeshContact",
    "MissingExtraError",
    "Modes",
    "QuasiStatic",
    "Reading",
    "Relief",
    "RigidBody",
    "RimModes",
    "SimulationError",
    "Solver",
    "Topography",
    "Trajectory",
    "energy_balance",
    "natural_frequencies",
    "quasi_static",
    "read_motion",
    "require_extra",
    "simulate",
]
