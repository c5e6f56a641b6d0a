"""How the bodies of both gears bend: their free modes, at the teeth and at the bearings."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearlash.multibody import Modes
from gearlash.multibody.contact import MeshContact, RimModes

from .inputs import Inputs

MODES = 5
"""Of a body, at least."""
MODAL_DAMPING = 0.005
"""Of each of them: that of a steel body, assumed."""
SHAFT = 0.5
"""Diameter of the pinion's shaft over the pitch diameter, where no bore is stated; assumed."""
INTERFACE_MODES = 12
"""Of the pinion with the ends of its shaft held, for each number of waves."""


@dataclass(frozen=True)
class Bending:
    """Modes of a body.

    Attributes
    ----------
    rim : RimModes
        How they move the flanks.
    modes : Modes
        How they swing, and what bearings feel of them.
    """

    rim: RimModes
    modes: Modes

    def and_(self, other: Bending) -> Bending:
        """These modes and those of the other body."""
        return Bending(self.rim.and_(other.rim), self.modes.and_(other.modes))


def bending_gear(inputs: Inputs, contact: MeshContact) -> Bending:
    """The lowest modes of the gear.

    Modes of one wave are left out: their hub moves across the shaft, in a direction that rotates.

    Parameters
    ----------
    inputs : Inputs
    contact : MeshContact
        Whose slices they move.

    Returns
    -------
    Bending
    """
    from gearlash.multibody.reduced import flexible_body

    found = flexible_body(inputs.bodies[1], inputs.materials[1]).first(MODES)
    pair = contact.flanks.pair
    gear = pair.gear.mirrored() if pair.gear.helix_angle * pair.pinion.helix_angle > 0.0 else pair.gear
    kept = found.waves != 1
    shape = found.at_flanks(gear, pair.working_pressure_angle, contact.tables.slices)[:, kept]
    waves = found.waves[kept]
    rim = RimModes(np.ones(len(waves), np.int64), waves, np.ascontiguousarray(shape))
    hub = tuple(tuple(map(float, row)) for row in found.hub[kept])
    frequencies = tuple(map(float, found.frequency[kept]))
    return Bending(rim, Modes(frequencies, MODAL_DAMPING, hub, (1,) * len(waves)))  # pyright: ignore[reportArgumentType]


def bending_pinion(inputs: Inputs, contact: MeshContact) -> Bending:
    """The lowest modes of the pinion in one piece with its shaft, whose ends lie in the bearings.

    The coordinates of modes of one wave, in which the shaft bends, are taken along directions that stand
    still: so bearings feel them, and the teeth meet them at one place. What such a pair of modes feels of the
    rotation (2 Ω over its frequency) is left out.

    Parameters
    ----------
    inputs : Inputs
    contact : MeshContact
        Whose slices they move.

    Returns
    -------
    Bending
    """
    from gearlash.multibody.reduced import flexible_shaft

    pair, body = contact.flanks.pair, inputs.bodies[0]
    thick = body.bore or SHAFT * pair.pinion.reference_diameter
    length = max(inputs.bearing_spans[0], body.face_width)
    found = flexible_shaft(
        body.outer_diameter,
        body.face_width,
        thick,
        length,
        inputs.materials[0],
        interface_modes=INTERFACE_MODES,
    ).first(MODES)
    shape = found.at_flanks(pair.pinion, pair.working_pressure_angle, contact.tables.slices)
    order = np.where(found.waves == 1, 0, found.waves)  # on the line of centres: ψ = 0
    rim = RimModes(np.zeros(len(order), np.int64), order, np.ascontiguousarray(shape))
    hub = tuple(tuple(map(float, row)) for row in found.hub)
    frequencies = tuple(map(float, found.frequency))
    return Bending(rim, Modes(frequencies, MODAL_DAMPING, hub, (0,) * len(order)))  # pyright: ignore[reportArgumentType]
