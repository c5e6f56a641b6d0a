"""Planes in which motions are multiples of each other: what happens at one point happens all along."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from branches.curved import COARSE, followed, lowest, named, only
from gearlash.branches.continuation import SpecialKind, continue_orbit
from gearlash.branches.curves import CodimTwoKind, CodimTwoPoint, Curve
from gearlash.system import GearlashError
from orbits.members import one_dof, orbit

NAMES: tuple[str, str] = ("error", "load")
LIMITS = (0.3, -0.1 / 3.0), (1.2, -0.1 / 9.0)
FAMILY = {"load": -0.2 / 9.0, "error": 0.6, "ripple": 0.2, "mesh_damping": 0.1, "omega": 0.7 / 3.0}


@cache
def meeting() -> CodimTwoPoint:
    """A fold of an orbit on the back side alone, another minimum of which touches that side."""
    family = one_dof(**FAMILY)
    branch = continue_orbit(family, {}, "error", orbit(family), 0.45, 0.65, COARSE)
    fold = lowest(branch, SpecialKind.FOLD)
    over = followed(
        family, {"error": fold.value}, ("error", "omega"), fold, (0.5, 0.22), (0.7, 0.25), steps=COARSE
    )
    return only(over, CodimTwoKind.GRAZING_FOLD)


def begun(kind: SpecialKind) -> Curve:
    values = named(("error", "omega"), meeting().values)
    return followed(one_dof(**FAMILY), values, NAMES, meeting(), *LIMITS, kind, steps=COARSE)


def test_a_graze_with_a_multiplier_one_is_a_line_through_no_error_and_no_load():
    """On one boundary both scale the motion: their ratio alone matters."""
    curve = begun(SpecialKind.GRAZING)
    error, load = curve.parameters.T
    assert np.ptp(error) > 0.5
    assert load / error == pytest.approx(np.full(len(load), FAMILY["load"] / meeting().values[0]), rel=1e-11)
    assert curve.special == ()
    assert curve.throughout == (CodimTwoKind.GRAZING_FOLD,)


def test_the_fold_is_said_to_be_the_same_curve():
    with pytest.raises(GearlashError, match=r"a multiplier is 1: in this plane both are one curve"):
        begun(SpecialKind.FOLD)


def test_in_another_plane_a_point_is_solved_for_again():
    values = named(("error", "omega"), meeting().values)
    curve = followed(
        one_dof(**FAMILY),
        values,
        ("load", "omega"),
        meeting(),
        (-0.04, 0.2),
        (-0.01, 0.3),
        SpecialKind.GRAZING,
    )
    again = only(curve, CodimTwoKind.GRAZING_FOLD)
    assert again.values == pytest.approx((FAMILY["load"], meeting().values[1]), abs=1e-12)
    assert max(again.errors) < 1e-12
    assert curve.throughout == ()
