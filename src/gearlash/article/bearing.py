"""Impact-free is not quiet: bearings whose own frequency lies inside the window without impacts.

There the body rides on its bearing: it takes up most of the transmission error itself, so that the mesh force
hardly changes and the teeth stay together, while the bearing carries the motion."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gearlash import flow
from gearlash.case import Case
from gearlash.flow import Propagators
from gearlash.gears.helical import BEARINGS, STATES
from gearlash.orbits import shoot

from .reproduction import BearingMode, Reading

BEARING_WORDS = {
    "yp": "pinion, radial",
    "zp": "pinion, axial",
    "yg": "gear, radial",
    "zg": "gear, axial",
}  # fmt: skip


def bearing_modes(
    case: Case, window: Reading, state: np.ndarray, fixed: Mapping[str, float]
) -> tuple[BearingMode, ...]:
    """Every bearing direction whose frequency √(k_i/m_i) lies in the window, with the motion without impacts
    there; ``state`` (n,) is a point of that motion somewhere in the window."""
    pair = case.numbers.pair
    if pair is None or not window.found:
        return ()
    family, found = case.family()[0], []
    for i, (bearing, frequency) in enumerate(zip(BEARINGS, pair.bearing_frequencies, strict=True)):
        if not window.lower.value < frequency < window.upper.value:
            continue
        props = flow.propagators(family.system({**fixed, "omega": frequency}))
        shot = shoot(props, state, 1)
        if shot.status.ok:
            stiffness = frequency**2 / pair.mass_ratios[i // 2]
            found.append(_mode(props, shot.state, STATES[2 * i], BEARING_WORDS[bearing], stiffness))
    return tuple(found)


def _mode(props: Propagators, state: np.ndarray, name: str, words: str, stiffness: float) -> BearingMode:
    """Peak to peak over one mesh cycle; forces over k_m D_c."""
    samples = flow.trace(props, state, 1.0).samples(2_001)
    moved = float(np.ptp(samples.state[:, STATES.index(name)]))
    return BearingMode(
        bearing=words,
        frequency=props.system.omega,
        motion=moved,
        force=stiffness * moved,
        mesh_force=float(np.ptp(samples.force)),
        mesh_mean=float(samples.force.mean()),
    )
