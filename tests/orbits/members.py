"""Members of families that tests of orbits and branches share, solved once a process."""

from __future__ import annotations

from functools import cache

import numpy as np

from gearlash import case, flow
from gearlash.flow import Propagators
from gearlash.gears import spur
from gearlash.orbits import Attractor, Orbit, attractor
from gearlash.system import Family


@cache
def article() -> Family:
    """The article's pair with a ripple of the first harmonic."""
    return case.load("article-first-harmonic").family()[0]


@cache
def one_dof(**defaults: float) -> Family:
    """A pair with one degree of freedom, states X, X′; what is not named is that of a mild pair."""
    return spur.family({"omega": 0.7, "D": 1.0, "load": 0.1, "error": 0.1, "mesh_damping": 0.05, **defaults})


def built(family: Family, **values: float) -> Propagators:
    return flow.propagators(family.system(values))


@cache
def cold(family: Family, **values: float) -> Attractor:
    """The attractor of the cold start."""
    return attractor(built(family, **values), family.start(values))


@cache
def orbit(family: Family, **values: float) -> Orbit:
    """The same, where it is to be periodic."""
    found = cold(family, **values)
    assert isinstance(found, Orbit), found.message
    return found


def displaced(family: Family, seed: int, **values: float) -> np.ndarray:
    """A start far from the cold one."""
    rng = np.random.default_rng(seed)
    return family.start(values) + rng.normal(0.0, 0.3, len(family.states))


def count_by_marching(props: Propagators, state: np.ndarray, periods: int) -> tuple[int, int]:
    """Engagements on the drive and on the back side, by the counters of the march, not the trace."""
    contacts = flow.march(props, state, periods).contacts
    return int(contacts[:, 0].sum()), int(contacts[:, 1].sum())
