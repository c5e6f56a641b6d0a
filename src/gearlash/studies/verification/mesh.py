"""The mesh of the multibody model at one face width: compliance, contact, and what follows of both."""

from __future__ import annotations

from dataclasses import dataclass, replace

from gearlash.gears import CylindricalPair
from gearlash.multibody.contact import MeshContact
from gearlash.multibody.quasi_static import QuasiStatic, quasi_static
from gearlash.multibody.topography import Topography

from .inputs import ORDERS, Inputs

SLICES = 21
PHASES = 32
"""Of a mesh cycle, at which the stiffness is computed."""
CLOSE = 5e-3
"""Of a stiffness to the one wanted, relative."""
MOST_WIDTHS = 4
FINEST = 1e-4
"""Widths are whole multiples of this, m."""


@dataclass(frozen=True)
class Mesh:
    """A pair at one face width.

    Attributes
    ----------
    pair : CylindricalPair
    perfect : MeshContact
        Of flanks without error, undamped.
    static : QuasiStatic
        A mesh cycle under the torque, perfect flanks.
    """

    pair: CylindricalPair
    perfect: MeshContact
    static: QuasiStatic

    @property
    def width(self) -> float:
        """Of the teeth, m."""
        return self.pair.face_width

    @property
    def stiffness(self) -> float:
        """Mean over the mesh cycle, N/m."""
        return self.static.mean_stiffness

    @property
    def ripples(self) -> tuple[float, ...]:
        """ε of the mesh orders 1, 2, …: k = k_m (1 + Σ ε_n cos(n θ + φ_n))."""
        return tuple(self.static.ripple(n)[0] for n in ORDERS)

    @property
    def ripple_phases(self) -> tuple[float, ...]:
        """φ_n, rad."""
        return tuple(self.static.ripple(n)[1] for n in ORDERS)

    def contact(
        self, inputs: Inputs, *, error: float = 0.0, error_phase: float = 0.0, damping: float = 1.0
    ) -> MeshContact:
        """The contact with an error on its flanks, damped as ξ_m asks for.

        Parameters
        ----------
        inputs : Inputs
        error : float
            Zero to peak, once a mesh cycle, m.
        error_phase : float
            rad.
        damping : float
            Over what matches ξ_m: the damping time 2 ξ_m/√(k/m_e).

        Returns
        -------
        MeshContact
        """
        time = 2.0 * damping * inputs.mesh_damping / inputs.natural_frequency(self.stiffness)
        shape = Topography(error=((error, error_phase, 1),)) if error else Topography()
        return self.perfect.with_(damping_time=time, topography=shape)


def mesh_of(inputs: Inputs, width: float, torque: float) -> Mesh:
    """The mesh of the inputs at a face width.

    Parameters
    ----------
    inputs : Inputs
    width : float
        m.
    torque : float
        On the pinion, N·m.

    Returns
    -------
    Mesh
    """
    from gearlash.multibody.compliance import pair_compliances

    pair = replace(inputs.pair, face_width=width)
    contact = MeshContact.of(pair, pair_compliances(pair, (width, width)), slices=SLICES)
    return Mesh(pair, contact, quasi_static(contact, torque, phases=PHASES))


def matched_mesh(inputs: Inputs, full: Mesh) -> Mesh:
    """The face width whose computed stiffness is that of the case, and its mesh.

    Parameters
    ----------
    inputs : Inputs
    full : Mesh
        Of the width of the case: where the search begins.

    Returns
    -------
    Mesh
    """
    wanted, found = inputs.mean_stiffness, full
    slope = found.stiffness / found.width
    for _ in range(MOST_WIDTHS):
        if abs(found.stiffness / wanted - 1.0) < CLOSE:
            break
        width = found.width + (wanted - found.stiffness) / slope
        last, found = found, mesh_of(inputs, FINEST * round(width / FINEST), inputs.torque)
        slope = (last.stiffness - found.stiffness) / (last.width - found.width)
    return found
