"""A contact that ends in a touch, just before the extremum that touches merges with the next one."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

import numpy as np
import pytest

from branches.curved import COARSE, followed
from gearlash.branches.continuation import ContinuationSettings, SpecialKind, continue_orbit
from gearlash.branches.curves import CodimTwoKind
from gearlash.orbits import orbit_at
from gearlash.system import Clearance, ContactRule, Family, Parameter, System, constant, cosines
from orbits.members import built

WIDE = ContinuationSettings(certify=False, longest=0.3)


def two_bodies() -> Family:
    """A body between stops, and another one that is coupled to it through a gap and pushed with it."""

    def build(p: Mapping[str, float]) -> System:
        matrix = np.zeros((4, 4))
        matrix[0, 1] = matrix[2, 3] = 1.0
        matrix[1, :2], matrix[3, 2:] = (-1.0, -0.17152071762), (-0.4, -0.12727586078)
        forcing = np.zeros((4, 3))
        forcing[1], forcing[3] = (p["load"], p["force"], 0.0), (-p["load"], 0.49737808 * p["force"], 0.0)
        forcing[3, 2] = 0.05113820 * p["force"]
        x, v, y, w = np.eye(4)
        hard = constant(1.58474781865)
        stop = Clearance(x, -v, 0.38546111124, 0.77092222249, hard, hard, 0.21884907128, name="stop")
        link = cosines(2.3815508209, [0.32193719437], [0.3])
        gap = Clearance(
            x - y, 1.32287885215 * w - v, 0.20435709823, 0.20435709823, link, link, 0.05705920122,
            contact=ContactRule.IN_CONTACT, name="gap",
        )  # fmt: skip
        return System(1.0967264616219, matrix, forcing, (stop, gap))

    parameters = Parameter("force", 0.67), Parameter("load", -0.18)
    return Family(parameters, ("x", "v", "y", "w"), build, lambda _: np.zeros(4))


def test_both_touches_of_a_short_contact_are_found():
    """It is born and ends along the fold. Behind its end the extremum is soon gone, within the same step."""
    family, values = two_bodies(), {"force": 0.6706004270685733, "load": -0.1765}
    start = orbit_at(built(family, **values), [-0.9048640992, 0.7949568693, -1.2329059962, 1.4284626539], 1)
    assert start is not None
    branch = continue_orbit(family, values, "load", start, -0.26, -0.16, COARSE)
    fold = branch.of_kind(SpecialKind.FOLD)[-1]
    limits = (0.667, -0.2435), (0.675, -0.237)
    values["load"] = fold.value
    curve = followed(family, values, ("force", "load"), fold, *limits, steps=WIDE)
    met = curve.of_kind(CodimTwoKind.GRAZING_FOLD)
    places = np.array(sorted(each.values for each in met))
    assert places == pytest.approx(np.array([[0.66924145, -0.24098780], [0.67170809, -0.24185779]]), abs=1e-7)
    for left, right in pairwise(curve.points):
        between = [each for each in met if left.arclength <= each.arclength <= right.arclength]
        assert (left.signature != right.signature) == (len(between) % 2 == 1)
