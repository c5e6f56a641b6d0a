"""A doubling and the grazing beside it: both special points of branches, and the orbits in between."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from gearlash.article.branching import Following
from gearlash.article.opening import coincidences, pairs
from gearlash.article.reproduction import Coincidence, Scan
from gearlash.article.rows import distinct, rows
from gearlash.case import load
from gearlash.flow import propagators
from gearlash.jobs import Inline
from gearlash.orbits import orbit_at
from gearlash.results import Axis

AT = {"omega": 0.78}
CASE = load("article")


@cache
def scan() -> Scan:
    swept = rows(CASE, Axis.even("D", 0.336, 0.36, 5), AT, Inline())
    return Following.begun(CASE, "D", AT, swept, Inline()).scan(distinct(swept), Inline())


@cache
def touch() -> Coincidence:
    ((both, directions),) = coincidences(CASE, scan(), Inline())
    assert directions
    return both


def test_labels_and_places_of_the_codimension_2_event():
    both = touch()
    assert both.labels == ("12-12-3", "6-6-1")
    assert (both.single, both.doubled) == ("6-6-1", "12-12-2")
    assert both.grazing.touch.boundary == -1
    assert round(both.doubling.value, 4) == round(both.grazing.value, 4) == 0.3523
    assert both.apart == pytest.approx(both.doubling.value - both.grazing.value, rel=1e-12)
    assert 9e-6 < both.apart < 1e-5


@pytest.mark.parametrize(("part", "label"), [(0.9, "12-12-2"), (1.1, "12-12-3"), (2.0, "12-12-3")])
def test_the_label_changes_at_the_grazing(part: float, label: str):
    """Orbits solved for anew, from the one that touches."""
    (pair,) = pairs(scan())
    value = pair.doubling.value - part * touch().apart
    values = {**CASE.family()[0].complete(), **AT, "D": value}
    orbit = orbit_at(propagators(CASE.family()[0].system(values)), pair.grazing.point.state, 12)
    assert orbit is not None
    assert orbit.label == label


def test_the_doubled_orbit_opens_like_a_square_root():
    both = touch()
    assert both.power == pytest.approx(0.5, abs=2e-3)
    first, last = both.opening[0], both.opening[-1]
    assert first.distance == pytest.approx(both.opens * first.amplitude**2, rel=1e-2)
    assert both.clearance - first.clearance == pytest.approx(both.approaches * first.amplitude, rel=1e-2)
    assert last.distance < both.apart
    assert last.amplitude < both.amplitude
    clearances = [both.clearance, *(o.clearance for o in both.opening), 0.0]
    assert clearances == sorted(clearances, reverse=True)
    assert both.clearance == pytest.approx(0.0193235, abs=1e-7)


def test_why_they_lie_so_near_in_numbers():
    """The square root alone has the order of the distance, its next terms the distance itself."""
    both = touch()
    assert both.predicted == pytest.approx(both.opens * (both.clearance / both.approaches) ** 2, rel=1e-12)
    assert 0.3 * both.apart < both.predicted < both.apart
    assert both.corrected == pytest.approx(both.apart, rel=1e-2)


def test_a_doubling_without_a_grazing_beside_it_has_none():
    """24-24-6 opens from 12-12-3 at D ≈ 0.3374; it touches nothing before its own doubling."""
    doublings = {round(e.value, 5) for e in scan().events if e.kind == "doubling"}
    assert doublings >= {0.33739, 0.35232}
    assert [round(pair.doubling.value, 5) for pair in pairs(scan())] == [0.35232]


def test_an_amplitude_is_that_of_any_mesh_cycle():
    (pair,) = pairs(scan())
    point = pair.grazing.point
    half = np.linalg.norm(np.roll(point.strobes, 3, axis=0) - np.roll(point.strobes, 9, axis=0), axis=1)
    assert touch().amplitude == pytest.approx(0.5 * half.max(), rel=1e-12)
