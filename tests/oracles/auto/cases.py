"""What AUTO-07p is asked: a family, where its branch begins, between which ω, how wide its corners are."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from branches.shaken import shaken
from gearlash.system import ContactRule, Family
from orbits.contacts import one_dof_under
from orbits.members import article, one_dof


@dataclass(frozen=True)
class Asked:
    """``width``: the first of `WIDTHS`, each half of the one before. The rest: of
    AUTO; a branch point cannot be had to more than 1e-6, as its orbit is singular."""

    family: Callable[[], Family]
    omega: float
    lower: float
    upper: float
    width: float
    values: Mapping[str, float] = field(default_factory=dict)
    steps: int = 1500
    longest: float = 0.01
    mesh: int = 300
    tolerance: float = 1e-9


WIDTHS = 4

CASES = {
    "gear pair": Asked(lambda: one_dof(error=0.05), 1.45, 0.6, 1.5, 0.01, longest=0.007),
    "gear pair in contact": Asked(
        lambda: one_dof_under(ContactRule.IN_CONTACT, error=0.05), 1.45, 0.5, 1.5, 0.01
    ),
    "parametric resonance": Asked(lambda: one_dof(error=0.0005, ripple=0.3), 2.4, 1.8, 2.45, 0.004),
    "one-sided stop": Asked(
        lambda: shaken(), 0.7, 0.7, 0.9, 0.004, {"zeta": 0.05, "beta": 10.0, "a": 0.5}, longest=0.004
    ),
    "symmetric": Asked(
        lambda: one_dof(load=0.0, error=1.0, D=0.2, mesh_damping=0.02),
        0.6,
        0.46,
        0.61,
        0.02,
        longest=0.002,
        tolerance=1e-6,
    ),
    "torus, low": Asked(lambda: article(), 0.73, 0.725, 0.75, 0.01),
    "torus, high": Asked(lambda: article(), 0.93, 0.91, 0.935, 0.01),
}
