"""The square-root law of a touch, predicted from the field, against computed orbits."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from branches.followed import PLAIN, bundled, linear, random_pair, six, window
from gearlash.branches.continuation import (
    Branch,
    GrazingLaw,
    SpecialKind,
    SpecialPoint,
    continue_orbit,
    law_at,
)
from gearlash.branches.continuation.extrema import Extrema
from gearlash.orbits import orbit_at
from gearlash.system import ContactRule, Family, GearlashError
from orbits.contacts import one_dof_under
from orbits.members import built, one_dof, orbit


def drawn(rule: ContactRule) -> Family:
    """The family of `followed.random_pair` with seed 5."""
    rng = np.random.default_rng(5)
    values = {"load": rng.uniform(0.05, 0.3), "mesh_damping": rng.uniform(0.02, 0.1)}
    values |= {"error": rng.uniform(0.02, 0.2), "ripple": rng.uniform(0.0, 0.3)}
    return one_dof_under(rule, **values)


def branch_of(name: str) -> tuple[Family, Branch]:
    if name == "linear":
        return one_dof(error=0.05), linear()
    if name in ("six", "window"):
        return bundled(), six() if name == "six" else window()
    rule = ContactRule(name)
    return drawn(rule), random_pair(5, rule)


def deeper(family: Family, branch: Branch, special: SpecialPoint, law: GrazingLaw, depth: float):
    """The multipliers of the orbit about as deep beyond the touch, in the order of the law; and how deep."""
    extremum = special.extremum
    assert extremum is not None
    value = special.value - np.sign(extremum.a0) * depth / law.rate
    props = built(family, **{**branch.values, branch.name: value})
    found = orbit_at(props, special.point.state, special.point.period)
    assert found is not None
    nearest = [each for each in Extrema.of(found).all if each.group == extremum.group]
    at = min(nearest, key=lambda each: abs((each.phase - extremum.phase + 0.5) % special.point.period - 0.5))
    assert at.distance * extremum.a0 < 0.0
    known, order = np.linalg.eigvals(found.shot.monodromy), []
    for expected in law.at(abs(at.distance)):
        order.append(int(np.argmin(np.abs(known - expected))))
    return known[order], abs(at.distance)


@pytest.mark.parametrize("name", ["linear", "six", "window", "in-contact", "no-tension"])
def test_every_multiplier_moves_as_the_law_says(name):
    """What the law leaves is of first order in the depth."""
    family, branch = branch_of(name)
    for special in branch.of_kind(SpecialKind.GRAZING):
        if special.label_before == special.label_after:
            continue  # a corner of the map: tests of its own
        law = law_at(family, branch, special)
        assert law.generic
        left = []
        for depth in (1e-6, 1e-8):
            found, here = deeper(family, branch, special, law, depth)
            left.append(float(np.abs(found - law.at(here)).max()) / np.sqrt(here))
        size = float(np.abs(law.coefficients).max())
        assert left[1] < 0.2 * left[0] + 2e-3 * size
        assert left[0] < 0.05 * max(size, 0.1)


@cache
def weak(damping: float) -> tuple[Family, Branch]:
    """A lightly damped pair whose response only just reaches the boundary: folds close to its touches."""
    width = 2.0 * damping
    family, values = one_dof(error=0.15 * width, mesh_damping=damping), {"omega": 1.0 + 8.0 * width}
    lower, upper = 1.0 - 12.0 * width, 1.0 + 10.0 * width
    return family, continue_orbit(family, values, "omega", orbit(family, **values), lower, upper, PLAIN)


@pytest.mark.parametrize(("damping", "close"), [(0.02, 2e-3), (0.005, 3e-4)])
def test_the_next_fold_is_as_deep_as_predicted(damping, close):
    """The nearer the fold, the better; and where the parameter turns round."""
    family, branch = weak(damping)
    touch = min(branch.of_kind(SpecialKind.GRAZING), key=lambda special: special.value)
    law = law_at(family, branch, touch)
    assert law.predicted_kind is law.computed_kind is SpecialKind.FOLD
    assert law.predicted_depth == pytest.approx(law.computed_depth, rel=close)
    ahead = law.computed_value - law.value
    assert law.predicted_value - law.value == pytest.approx(ahead, rel=10.0 * close)


def test_where_there_is_no_law_it_is_said():
    family, branch = branch_of("linear")
    with pytest.raises(GearlashError, match="no touch"):
        law_at(family, branch, branch.of_kind(SpecialKind.FOLD)[0])
