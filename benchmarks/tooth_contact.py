"""Forces between the teeth of the article's pair in space: what one evaluation takes."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, radians

import numpy as np
from numpy.typing import NDArray

from gearlash.gears import CylindricalGear, CylindricalPair
from gearlash.multibody.compliance import SectorSettings, pair_compliances
from gearlash.multibody.contact import MeshContact, contact_forces, new_memory
from gearlash.multibody.tooth_section import Fineness

from .results import OWN, Row
from .timing import Runner, in_turns

TASK = "contact of teeth in space"
WIDTH = 0.065
APPROACH = 1e-6  # m, of both flanks under the load of the article, about
HOW = "forces on both bodies from a pose, 65 mm of face; poses follow each other as in a simulation"
COARSE = SectorSettings(Fineness(flank=3, fillet=1, core=1, rim=1, axial=6), teeth=3)
"""The time of an evaluation does not depend on how fine the elements were."""

Reals = NDArray[np.float64]


def contact_rows(repeats: int, quick: bool) -> list[Row]:
    """Apart and pressed, by the number of slices."""
    pinion, gear = (CylindricalGear(z, 4e-3, radians(18.0), thickness_allowance=-50e-6) for z in (28, 70))
    drawn = CylindricalPair(pinion.nominal(), gear.nominal())
    pair = CylindricalPair(pinion, gear, drawn.centre_distance, WIDTH)
    compliance = pair_compliances(pair, (WIDTH, WIDTH), settings=COARSE)
    runners, evaluations = [], 20 if quick else 2000
    for slices in (15, 21, 31):
        contact = MeshContact.of(pair, compliance, slices=slices)
        for name, approach in (("apart", -0.5 * contact.flanks.play), ("pressed", APPROACH)):
            work = f"{slices} slices, {name}"
            runners.append(Runner(work, _evaluating(contact, approach, evaluations), evaluations))
    times = in_turns(runners, repeats)
    return [
        Row(TASK, name, OWN, "evaluation", each.median, each.best, how=HOW) for name, each in times.items()
    ]


def _evaluating(contact: MeshContact, approach: float, count: int) -> Callable[[], None]:
    """One mesh cycle in so many steps."""
    flanks = contact.flanks
    first, second = flanks.base_radii
    behind = (approach + 0.5 * flanks.play) / cos(flanks.base_helix)
    poses = np.zeros((count, 12))
    poses[:, 5] = np.arange(count) / count * flanks.phase_pitch
    poses[:, 11] = (behind - first * poses[:, 5]) / second
    still, out, report = np.zeros(12), np.empty(12), np.empty(8)

    def run() -> None:
        memory = new_memory(contact.tables)
        for pose in poses:
            contact_forces(contact.tables, pose, still, out, report, memory)

    return run
