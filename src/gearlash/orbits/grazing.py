"""The article's four grazing conditions, evaluated at every extremum of the gap."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearlash.flow import Extrema

from .results import Attractor

KINDS = {
    (1, 1): "loss of contact on the drive side (minimum of X in S1)",
    (1, -1): "engagement on the drive side (maximum of X in S2)",
    (-1, -1): "loss of contact on the back side (maximum of X in S3)",
    (-1, 1): "engagement on the back side (minimum of X in S2)",
}


@dataclass(frozen=True)
class GrazingCheck:
    """One extremum of X beside one boundary (+1: Σ1, -1: Σ2).

    ``distance`` is H = X ∓ D there (condition 1 wants 0), ``gradient`` = |∇H| (2: not 0), ``velocity`` = X'
    (3: 0, by construction of the extremum), ``a0`` = X'' (4). The article asks a0 > 0, which is loss of
    contact seen from S1; a0 < 0 on Σ1 is engagement seen from S2, and the signs are mirrored on Σ2: `kind`
    says which."""

    phase: float
    boundary: int
    displacement: float
    distance: float
    gradient: float
    velocity: float
    a0: float
    index: int

    @property
    def kind(self) -> str:
        return KINDS[(self.boundary, 1 if self.a0 > 0 else -1)]

    def holds(self, tolerance: float = 1e-9) -> bool:
        """Whether all four conditions hold within ``tolerance`` (lengths in units of the reference
        length)."""
        return (
            abs(self.distance) <= tolerance
            and self.gradient > 0.0
            and abs(self.velocity) <= tolerance
            and abs(self.a0) > tolerance
        )


def grazing_checks(attractor: Attractor, within: float = np.inf) -> tuple[GrazingCheck, ...]:
    """The conditions at every extremum whose distance to a boundary is at most ``within``, nearest first."""
    extrema, system = attractor.extrema, attractor.propagators.system
    clearance = system.clearances[0]
    gradient = float(np.linalg.norm(clearance.h))
    found = []
    for boundary, gap in ((1, clearance.gap_plus), (-1, -clearance.gap_minus)):
        for i in range(len(extrema)):
            distance = float(extrema.displacement[i] - gap)
            if abs(distance) <= within:
                found.append(_check(extrema, i, boundary, distance, gradient, attractor))
    return tuple(sorted(found, key=lambda check: abs(check.distance)))


def _check(
    extrema: Extrema, i: int, boundary: int, distance: float, gradient: float, attractor: Attractor
) -> GrazingCheck:
    from gearlash.flow.events import gap_velocity

    velocity = gap_velocity(attractor.propagators.system, extrema.phase[i : i + 1], extrema.state[i : i + 1])
    return GrazingCheck(
        phase=float(extrema.phase[i]),
        boundary=boundary,
        displacement=float(extrema.displacement[i]),
        distance=distance,
        gradient=gradient,
        velocity=float(velocity[0]),
        a0=float(extrema.curvature[i]),
        index=i,
    )
