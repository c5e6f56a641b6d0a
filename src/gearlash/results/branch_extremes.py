"""How far the motions of a branch swing, and how hard they press: by the exact flow.

Of an orbit that is very unstable every base period is begun at its own strobe: what it makes of the rounding
of its state then grows over one base period only, not over all of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.flow.events import gap_displacement
from gearlash.orbits.force_figures import force_figures
from gearlash.system import CARRIED, Family

if TYPE_CHECKING:  # a dataset of a branch is made where there is one
    from gearlash.branches.continuation import Branch, BranchPoint

LEAST, MOST = ("minimum", "force_min"), ("maximum", "force_max")
VERY_UNSTABLE = 1e4  # modulus of a multiplier
FIGURES = (*LEAST, *MOST, "force_rms", "share_without_contact")


def measured(
    family: Family, branch: Branch, points: Iterable[BranchPoint], extremes: bool = True
) -> list[tuple[dict[str, float], np.ndarray]]:
    """Of every point `FIGURES` (of the first clearance, dimensionless; NaN where the motion could not be
    carried; none without ``extremes``) and X (P,) at its strobes."""
    found, props = [], None
    for point in points:
        system = family.system({**branch.values, branch.name: point.value})
        props = flow.propagators(system, props) if extremes else None
        phase = np.arange(len(point.strobes), dtype=np.float64) * system.cycles
        x = gap_displacement(system, phase, point.strobes)
        found.append(({} if props is None else _figures(props, point), x))
    return found


def _figures(props: Propagators, point: BranchPoint) -> dict[str, float]:
    parts, count = [], len(point.strobes)
    at_once = count if float(np.abs(point.multipliers[0])) < VERY_UNSTABLE else 1
    for strobe in point.strobes[::at_once]:
        trace = flow.trace(props, strobe, float(props.system.cycles * at_once))
        if trace.status not in CARRIED:
            return dict.fromkeys(FIGURES, float("nan"))
        parts.append(force_figures(trace))
    every = {name: np.array([part[name] for part in parts]) for name in FIGURES}
    return {
        **{name: float(every[name].min()) for name in LEAST},
        **{name: float(every[name].max()) for name in MOST},
        "force_rms": float(np.sqrt(np.mean(every["force_rms"] ** 2))),
        "share_without_contact": float(every["share_without_contact"].mean()),
    }
