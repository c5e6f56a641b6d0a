"""Real motions and a small real sweep to draw, computed once a process."""

from __future__ import annotations

from functools import cache
from threading import Event

import numpy as np
import xarray as xr

from gearlash.branches import locate_grazing
from gearlash.branches.curves import Curve
from gearlash.case import Case, load
from gearlash.jobs import Execution
from gearlash.orbits import Orbit, attractor, grazing_checks
from gearlash.results import Axis, plane_dataset, sweep_dataset
from gearlash.results.branch_dataset import branch_dataset
from gearlash.results.tolerance import Tolerance
from gearlash.studies import Zones, continue_branch, continue_curve, map_plane, sweeps
from gearlash.studies.motion import Motion, motion, touching
from gearlash.studies.plane_zone import PlaneZone
from gearlash.studies.plane_zones import plane_zone
from gearlash.studies.tolerances import tolerance
from gearlash.studies.zones import zones_of_kinds


@cache
def article() -> Case:
    """The article's pair."""
    return load("article-first-harmonic")


@cache
def orbit(omega: float, gap: float) -> Orbit:
    """The attractor from the cold start, which must be periodic here."""
    family, _ = article().family()
    values = {"omega": omega, "D": gap}
    found = attractor(family.system(values), family.start(values))
    assert isinstance(found, Orbit)
    return found


@cache
def moving(omega: float, gap: float, value: float = float("nan")) -> Motion:
    """That attractor as a motion."""
    return motion(orbit(omega, gap), value=value)


@cache
def aperiodic() -> Motion:
    """A motion that does not repeat."""
    family, _ = article().family()
    values = {"omega": 1.2, "D": 1.0}
    found = attractor(family.system(values), family.start(values))
    assert not isinstance(found, Orbit)
    return motion(found, value=1.2)


@cache
def around_grazing() -> tuple[Motion, Motion, Motion]:
    """Before, at and after the lower end of the 1-0 window."""
    family, _ = article().family()
    inside = orbit(0.98, 1.0)
    values = family.complete({"omega": 0.98, "D": 1.0})
    point = locate_grazing(family, "omega", inside, grazing_checks(inside)[0], values=values)
    return moving(0.968, 1.0, 0.968), touching(family, point), moving(0.977, 1.0, 0.977)


@cache
def dataset(axis: str = "omega") -> xr.Dataset:
    """A few values around the upper end of the window (ω), or with impacts on the back side (D)."""
    values = np.linspace(1.08, 1.13, 6) if axis == "omega" else np.array([0.386, 0.39, 0.46, 0.48])
    fixed = {"D": 1.0} if axis == "omega" else {"omega": 0.78}
    return sweep_dataset(article(), sweeps(article(), Axis(axis, values), values=fixed))


@cache
def curves() -> tuple[Curve, ...]:
    """Of the window of the article, over speed and load."""
    found = continue_branch(article(), "omega", lower=0.94, upper=1.14, values={"omega": 1.05})
    low, high = (0.94, 0.05), (1.14, 0.2)
    return tuple(
        continue_curve(article(), ("omega", "load"), special, branch=found, lower=low, upper=high)
        for special in found.special[:3]
    )


@cache
def branch() -> xr.Dataset:
    """The motion of the window, from before it to beyond its doubling."""
    found = continue_branch(article(), "omega", lower=0.94, upper=1.14, values={"omega": 1.05})
    return branch_dataset(article(), found)


@cache
def plane() -> xr.Dataset:
    """A small map with every kind of motion, and a pixel that failed."""
    found = map_plane(
        article(), Axis.even("omega", 0.74, 1.2, 8), Axis("D", np.array([-0.1, 0.25, 0.39, 0.7]))
    )
    return plane_dataset(article(), found)


@cache
def zoned() -> tuple[xr.Dataset, tuple[Zones, ...]]:
    """Zones of both kinds over a coarse axis, and the sweeps they come from."""
    found = zones_of_kinds(article(), Axis.even("omega", 0.94, 1.13, 12), ["impact-free", "drive-side-only"])
    return sweep_dataset(article(), found[0].sweeps), found


@cache
def tolerated() -> Tolerance:
    """Bands of a small pair whose load and error have limits."""
    case = load("kahraman-singh")
    limits = {"load": (0.1, 0.3), "error": (0.05, 0.1)}
    return tolerance(case, Axis.even("omega", 0.5, 0.9, 5), limits, samples=2, replicates=2)


@cache
def begun(combinations: int) -> Tolerance:
    """The same, stopped when so many combinations were done."""
    case, cancel = load("kahraman-singh"), Event()
    limits = {"load": (0.1, 0.3), "error": (0.05, 0.1)}
    stopping = Execution(
        chunk=1, cancel=cancel, progress=lambda at: cancel.set() if at.done >= combinations else None
    )
    speeds = Axis.even("omega", 0.5, 0.9, 5)
    return tolerance(case, speeds, limits, samples=4, replicates=4, execution=stopping)


@cache
def planar() -> PlaneZone:
    """The zone without impacts of a spur pair, up to where it grazes."""
    return plane_zone(
        load("kahraman-singh"), ("omega", "load"), lower=(0.78, 0.095), upper=(0.85, 0.105),
        values={"omega": 0.81},
        tolerances={"omega": 0.005, "load": 0.002}, lines=0,
    )  # fmt: skip
