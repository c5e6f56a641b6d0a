"""A doubling and the grazing beside it: the doubled orbit, followed by its amplitude."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from gearlash.article.doubled import first_touch
from gearlash.article.reproduction import Coincidence
from gearlash.branches.continuation import SpecialKind, SpecialPoint, walk
from gearlash.case import load
from gearlash.flow import propagators
from gearlash.orbits import Orbit, attractor, shoot

FAMILY = load("article").family()[0]
PLACE = {**FAMILY.complete(), "omega": 0.78}


@cache
def doubling(near: float) -> SpecialPoint:
    """The doubling that the attractor at this D meets downwards."""
    values = {**PLACE, "D": near}
    found = attractor(FAMILY.system(values), FAMILY.start(values))
    assert isinstance(found, Orbit)
    way = walk(FAMILY, values, "D", found, near - 0.02)
    return next(p for p in way if isinstance(p, SpecialPoint) and p.kind is SpecialKind.DOUBLING)


@cache
def touch() -> Coincidence:
    found = first_touch(FAMILY, doubling(0.36))
    assert found is not None
    return found


def test_labels_and_places_of_the_codimension_2_event():
    both = touch()
    assert both.labels == ("12-12-3", "6-6-1")
    assert both.doubled == "12-12-2"
    assert both.grazing.boundary == -1
    assert round(both.doubling.value, 4) == round(both.grazing.value, 4) == 0.3523
    assert both.apart == pytest.approx(both.doubling.value - both.grazing.value, rel=1e-12)
    assert 9e-6 < both.apart < 1e-5


@pytest.mark.parametrize(("part", "label"), [(0.1, "12-12-2"), (0.5, "12-12-2"), (2.0, "12-12-3")])
def test_the_label_changes_at_the_grazing(part: float, label: str):
    """Orbits solved for anew, from the followed ones: the middle label lives between the two only."""
    both = touch()
    near = both.grazing.state_zero if part > 0.3 else both.doubling.point.state + 0.3 * (
        both.grazing.state_zero - both.doubling.point.state
    )  # fmt: skip
    props = propagators(FAMILY.system({**PLACE, "D": both.doubling.value - part * both.apart}))
    best = attractor(props, near)
    assert best.label in (label, "unresolved")
    shot = shoot(props, near, 12)
    if shot.status.ok and np.abs(shot.state - both.doubling.point.state).max() > 1e-4:
        assert Orbit(props, shot, 0, shot.status, "").label == label


def test_the_doubled_orbit_opens_like_a_square_root():
    both = touch()
    assert both.power == pytest.approx(0.5, abs=2e-3)
    first, last = both.opening[0], both.opening[-1]
    assert first.amplitude / first.distance**0.5 == pytest.approx(
        both.opening[1].amplitude / both.opening[1].distance ** 0.5, rel=1e-2
    )
    assert last.distance < both.apart
    clearances = [both.clearance, *(o.clearance for o in both.opening), 0.0]
    assert clearances == sorted(clearances, reverse=True)
    assert both.clearance == pytest.approx(0.01932, abs=1e-5)
    assert 0.3 * both.apart < both.predicted < both.apart


def test_a_doubling_without_a_grazing_beside_it_has_none():
    """24-24-6 opens from 12-12-3 at D ≈ 0.3374; it touches nothing within 2 %."""
    point = doubling(0.345)
    assert point.value == pytest.approx(0.33739, abs=1e-5)
    assert first_touch(FAMILY, point) is None
