"""What must hold for every branch, on random pairs: exact invariances, contacts counted by marching alone,
and the number of unstable multipliers."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from branches.followed import PLAIN
from gearlash.branches.continuation import Branch, SpecialKind, continue_orbit
from gearlash.orbits import orbit_at
from gearlash.system import ContactRule, Family
from orbits.contacts import one_dof_under
from orbits.members import built, count_by_marching, orbit

CHANGES = {
    SpecialKind.FOLD: 1,
    SpecialKind.DOUBLING: 1,
    SpecialKind.BRANCH_POINT: 1,
    SpecialKind.TORUS: 2,
    SpecialKind.GRAZING: 0,
    SpecialKind.JOINS: 0,
}
SEEDS = [(5, ContactRule.ALWAYS), (8, ContactRule.IN_CONTACT), (13, ContactRule.NO_TENSION)]


def drawn(seed: int, rule: ContactRule, **signs: float) -> tuple[Family, dict[str, float]]:
    """A pair, values drawn from the seed; ``signs`` turn some of them round."""
    rng = np.random.default_rng(seed)
    values = {"load": rng.uniform(0.05, 0.2), "mesh_damping": rng.uniform(0.02, 0.1)}
    values |= {"error": rng.uniform(0.05, 0.2), "ripple": rng.uniform(0.05, 0.3), "D": rng.uniform(0.3, 1.0)}
    omega = float(rng.uniform(1.3, 1.6))
    return one_dof_under(rule, **{k: v * signs.get(k, 1.0) for k, v in values.items()}), {"omega": omega}


def followed(family: Family, values: dict[str, float], start: np.ndarray) -> Branch:
    first = orbit_at(built(family, **values), start, 1)
    assert first is not None
    return continue_orbit(family, values, "omega", first, 0.7, 1.65, PLAIN)


def alike(one: Branch, other: Branch) -> None:
    assert [special.kind for special in one.special] == [special.kind for special in other.special]
    values = [[special.value for special in branch.special] for branch in (one, other)]
    assert values[0] == pytest.approx(values[1], rel=1e-10)
    counts = [[special.unstable_after for special in branch.special] for branch in (one, other)]
    assert counts[0] == counts[1]


@pytest.mark.parametrize(("seed", "rule"), SEEDS)
def test_of_a_random_pair(seed, rule):
    family, values = drawn(seed, rule)
    start = orbit(family, **values).state
    branch = followed(family, values, start)
    assert not branch.unexplained
    assert branch.special

    for left, right in pairwise(branch.points):
        between = [s for s in branch.special if left.arclength < s.arclength < right.arclength]
        most = sum(CHANGES[special.kind] for special in between)
        jumps = any("corner" in special.note for special in between)
        assert jumps or abs(right.unstable - left.unstable) == most

    for point in branch.points[::8]:  # by the counters of the march: no orbit that does not exist
        props = built(family, omega=point.value)
        assert count_by_marching(props, point.state, point.period) == (
            point.signature.drive,
            point.signature.back,
        )

    mirrored, _ = drawn(seed, rule, load=-1.0, error=-1.0)  # X → -X
    mirror = followed(mirrored, values, -start)
    alike(branch, mirror)
    assert {p.signature.drive for p in branch.points} == {p.signature.back for p in mirror.points}

    shifted, _ = drawn(seed, rule, error=-1.0, ripple=-1.0)  # half a period later
    later = orbit_at(built(family, **values), start, 1)
    assert later is not None
    alike(branch, followed(shifted, values, later.trace.at([0.5]).state[0]))

    last = branch.points[-1]  # from its other end
    alike(branch, followed(family, {"omega": last.value}, last.state))
