"""On which sides of a grazing the folds of both sides lie: of the reduced map
x + ν + a x² − c (x − σ)^{3/2} one on each where a and c have unlike signs, both on one where they have the
same."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from branches.curved import fold_over_backlash, followed, lowest, only
from branches.followed import linear
from gearlash.branches.continuation import ContinuationSettings, SpecialKind, continue_orbit
from gearlash.branches.curves import CodimTwoKind, Curve, secondary
from orbits.contacts import two_gaps
from orbits.members import one_dof, orbit

STEPS = ContinuationSettings(certify=False, longest=0.1)


def over_backlash() -> Curve:
    fold = lowest(linear(), SpecialKind.FOLD)
    limits = (0.7, 0.13), (0.72, 1.1)
    return followed(one_dof(error=0.05), {"omega": fold.value}, ("omega", "D"), fold, *limits, steps=STEPS)


def of_two_bodies() -> Curve:
    values = {"force": 0.5824328450001884, "load": -0.21516203079686086, "stop": 0.45887321729130215}
    values |= {"omega": 1.1977362164767853, "gap": 0.4724847461502535}
    branch = continue_orbit(two_gaps(), values, "omega", orbit(two_gaps(), **values), 1.0, 1.56, STEPS)
    fold = branch.of_kind(SpecialKind.FOLD)[0]
    limits = (1.34, 0.44), (1.5, 0.7)
    values |= {"omega": fold.value}
    return followed(two_gaps(), values, ("omega", "force"), fold, *limits, steps=STEPS)


@cache
def seen(curve) -> tuple[Curve, list[float], list[float]]:
    """The quadratic coefficients on both sides, from the touch on."""
    plain, values = secondary.quadratic, {}

    def noted(node, part=1.0):
        found = plain(node, part)
        values[node.place.tobytes()] = found
        return found

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(secondary, "quadratic", noted)
        found = curve()
    touch = only(found, CodimTwoKind.GRAZING_FOLD)
    sides: tuple[list[float], list[float]] = [], []
    for point in sorted(found.points, key=lambda each: abs(each.arclength - touch.arclength)):
        known = values.get(np.array(point.values).tobytes())
        if known is not None:
            sides[int(sum(map(sum, point.signature.counts)) > least(found))].append(known)
    return found, *sides


def least(curve: Curve) -> int:
    return min(sum(map(sum, point.signature.counts)) for point in curve.points)


@pytest.mark.parametrize("curve", [over_backlash, of_two_bodies])
def test_sides_by_the_sign_of_the_local_law(curve):
    found, clear, beyond = seen(curve)
    assert abs(beyond[0]) > 2.0 * abs(clear[0])
    touch = only(found, CodimTwoKind.GRAZING_FOLD)
    unit = np.subtract(found.upper, found.lower)
    ways = [np.subtract(point.values, touch.values) / unit for point in found.points]
    places = [point.arclength - touch.arclength for point in found.points]
    before = ways[max(i for i, place in enumerate(places) if place < -1e-9)]
    after = ways[min(i for i, place in enumerate(places) if place > 1e-9)]
    assert (before @ after > 0.0) == (clear[0] * beyond[0] < 0.0) == (curve is of_two_bodies)


def test_a_coefficient_that_changes_sign_through_infinity_is_no_cusp():
    found, clear, beyond = seen(of_two_bodies)
    touch, cusp = only(found, CodimTwoKind.GRAZING_FOLD), only(found, CodimTwoKind.CUSP)
    assert clear[0] * beyond[0] < 0.0
    assert np.ptp(np.sign(clear)) == 0.0
    assert (
        np.ptp(np.sign(beyond)) == 2.0
    )  # the cusp is one of the side with the impact: there the curve turns
    assert abs(cusp.values[0] - touch.values[0]) > 0.005
    assert not fold_over_backlash().of_kind(CodimTwoKind.CUSP)
