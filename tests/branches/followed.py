"""Branches that several tests look at, followed once a process."""

from __future__ import annotations

from functools import cache

import numpy as np

from gearlash import case
from gearlash.branches.continuation import Branch, ContinuationSettings, SpecialKind, continue_orbit
from gearlash.system import ContactRule, Family
from orbits.contacts import one_dof_under
from orbits.members import one_dof, orbit

PLAIN = ContinuationSettings(certify=False)


@cache
def linear() -> Branch:
    """One degree of freedom with constant stiffness: the resonance, where the teeth separate and bend it."""
    family = one_dof(error=0.05)
    start = orbit(family, omega=1.45)
    return continue_orbit(family, {"omega": 1.45}, "omega", start, 0.5, 1.6, PLAIN)


@cache
def parametric() -> Branch:
    """The same with a ripple of 0.3, in permanent contact: a parametric resonance at twice its frequency."""
    family = one_dof(error=0.0005, ripple=0.3)
    start = orbit(family, omega=2.4)
    return continue_orbit(family, {"omega": 2.4}, "omega", start, 1.7, 2.5, PLAIN)


@cache
def bundled() -> Family:
    return case.load("article").family()[0]


@cache
def six() -> Branch:
    """The article's 6-6-1 in the gap, from its doubling to the 3-3-1 that it comes from."""
    family = bundled()
    return continue_orbit(
        family, {"omega": 0.78, "D": 0.37}, "D", orbit(family, omega=0.78, D=0.37), 0.34, 0.5, PLAIN
    )


@cache
def window() -> Branch:
    """The article's impact-free window and what lies beside it."""
    family = bundled()
    start = orbit(family, omega=1.05)
    return continue_orbit(family, {"omega": 1.05}, "omega", start, 0.91, 1.13, PLAIN)


@cache
def random_pair(seed: int, rule: ContactRule, fine: bool = False) -> Branch:
    """A pair with one degree of freedom, its values drawn at random."""
    rng = np.random.default_rng(seed)
    drawn = {"load": rng.uniform(0.05, 0.3), "mesh_damping": rng.uniform(0.02, 0.1)}
    drawn |= {"error": rng.uniform(0.02, 0.2), "ripple": rng.uniform(0.0, 0.3)}
    family = one_dof_under(rule, **drawn)
    values = {"omega": float(rng.uniform(1.3, 1.6))}
    settings = ContinuationSettings(certify=False, longest=0.1)
    if fine:
        settings = ContinuationSettings(certify=False, longest=0.02, angle=0.1)
    return continue_orbit(family, values, "omega", orbit(family, **values), 0.6, 1.7, settings)


def values_of(branch: Branch, kind: SpecialKind) -> list[float]:
    return [special.value for special in branch.of_kind(kind)]
