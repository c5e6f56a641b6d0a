"""The mesh of the multibody model at one face width: compliance, contact, and what follows of both."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from gearlash.gears import CylindricalPair
from gearlash.gears.gear_body import GearBody
from gearlash.multibody import Modes
from gearlash.multibody.contact import MeshContact, RimModes
from gearlash.multibody.quasi_static import QuasiStatic, quasi_static
from gearlash.multibody.topography import Relief, Topography

from .inputs import ORDERS, Inputs

SLICES = 21
PHASES = 32
"""Of a mesh cycle, at which the stiffness is computed."""
CLOSE = 5e-3
"""Of a stiffness to the one wanted, relative."""
MODES = 5
"""Of the gear body, at least."""
MODAL_DAMPING = 0.005
"""Of each of them: that of a steel body, assumed."""
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
        Of flanks without error, undamped; with what modification they have.
    bending : MeshContact
        The same with a gear body that bends.
    modes : Modes
        Of that body.
    static : QuasiStatic
        A mesh cycle under the torque, flanks without error.
    """

    pair: CylindricalPair
    perfect: MeshContact
    bending: MeshContact
    modes: Modes
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
        self,
        inputs: Inputs,
        *,
        error: float = 0.0,
        error_phase: float = 0.0,
        damping: float = 1.0,
        flexible: bool = False,
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
        flexible : bool
            Whether the gear's body bends.

        Returns
        -------
        MeshContact
        """
        time = 2.0 * damping * inputs.mesh_damping / inputs.natural_frequency(self.stiffness)
        waves = ((error, error_phase, 1),) if error else ()
        shape = Topography(error=waves, relief=self.perfect.topography.relief)
        flanks = self.bending if flexible else self.perfect
        return flanks.with_(damping_time=time, topography=shape)


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
    compliances = pair_compliances(pair, (width, width))
    contact = MeshContact.of(pair, compliances, slices=SLICES)
    rim, modes = _bending_gear(inputs, contact)
    bending = MeshContact.of(pair, compliances, slices=SLICES, modes=rim)
    return Mesh(pair, contact, bending, modes, quasi_static(contact, torque, phases=PHASES))


def _bending_gear(inputs: Inputs, contact: MeshContact) -> tuple[RimModes, Modes]:
    """The lowest modes of the gear as a solid disc of its pitch diameter, which has its mass.

    Modes of one wave are left out: their hub moves across the shaft, in a direction that rotates.
    """
    from gearlash.multibody.reduced import flexible_body

    width = inputs.body_widths[1]
    found = flexible_body(GearBody(2.0 * inputs.radii[1], width)).first(MODES)
    pair = contact.flanks.pair
    gear = pair.gear.mirrored() if pair.gear.helix_angle * pair.pinion.helix_angle > 0.0 else pair.gear
    kept = found.waves != 1
    shape = found.at_flanks(gear, pair.working_pressure_angle, contact.tables.slices)[:, kept]
    waves = found.waves[kept]
    rim = RimModes(np.ones(len(waves), np.int64), waves, np.ascontiguousarray(shape))
    hub = tuple(tuple(map(float, row)) for row in found.hub[kept])
    return rim, Modes(tuple(map(float, found.frequency[kept])), MODAL_DAMPING, hub)  # pyright: ignore[reportArgumentType]


def modified(mesh: Mesh, relief: Relief) -> Mesh:
    """The same teeth with modified flanks.

    Parameters
    ----------
    mesh : Mesh
    relief : Relief

    Returns
    -------
    Mesh
    """
    shape = Topography(relief=relief)
    flanks, bending = mesh.perfect.with_(topography=shape), mesh.bending.with_(topography=shape)
    static = quasi_static(flanks, mesh.static.torque, phases=PHASES)
    return replace(mesh, perfect=flanks, bending=bending, static=static)


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
