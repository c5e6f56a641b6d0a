"""Zones as one way of scanning shows them: ends of basins, and what several rows have in common."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash import case, studies
from gearlash.jobs import Execution
from gearlash.studies import Axis, Direction, Quiet, ZoneEnd
from gearlash.studies.model import Source
from gearlash.studies.quiet import Row, Search
from gearlash.studies.scanned import scanned_zones
from gearlash.studies.zone_end import BASIN
from studies.classical import CLASSICAL, SPEEDS, loss_of_contact

ARTICLE = case.load("article-first-harmonic")


def test_a_basin_that_ends_is_no_bifurcation():
    """From far outside, the cold start falls into the impacting motion long before the quiet one ends."""
    axis = Axis.even("omega", 0.65, 0.8, 7)
    cold = studies.sweep(CLASSICAL, axis, start=[2.0, 0.0])
    found = scanned_zones(CLASSICAL, axis, "impact-free", [cold], start=[2.0, 0.0])
    (zone,) = found.zones
    assert zone.upper.kind == BASIN
    assert 0.0 < zone.upper.uncertainty <= 1e-6
    assert zone.upper.value < loss_of_contact()[0]


def test_an_orbit_that_ends_in_a_fold_beside_chaos():
    """The 2-1-0 motion of the article's pair ends at a fold; what is seen beyond is aperiodic."""
    settings = studies.Settings(patience=600, budget=1_500, exponent_periods=600)
    axis = Axis.even("omega", 1.14, 1.18, 3)
    up = studies.sweep(ARTICLE, axis, direction="up", settings=settings)
    assert up.points[-1].label == "aperiodic"
    (zone,) = scanned_zones(ARTICLE, axis, "drive-side-only", [up], settings=settings).zones
    assert zone.upper.kind == "fold"
    assert zone.upper.inside == "2-1-0"
    beside = Axis("omega", zone.upper.value + np.array([-1e-3, -1e-5, 1e-4]))
    seen = studies.sweep(ARTICLE, beside, direction="up", settings=settings, start=up.points[0].state)
    assert [p.label for p in seen.points[:2]] == ["2-1-0", "2-1-0"]
    assert not seen.points[2].periodic
    assert seen.points[1].leading.real == pytest.approx(1.0, abs=0.1)


def test_an_end_of_one_row_is_looked_at_in_the_others():
    """A grazing that ends another sweep's interval between two quiet points of this one is probed there."""
    axis = Axis.even("omega", 0.4, 0.6, 2)
    (up,) = studies.sweeps(CLASSICAL, axis, ["up"])
    search = Search(Source.of(CLASSICAL), (), studies.Settings(), Quiet.IMPACT_FREE, None, Execution())
    row = Row(up.direction, up.points, frozenset(p.value for p in up.points))
    known = studies.sweeps(CLASSICAL, SPEEDS, ["up"])
    point = scanned_zones(CLASSICAL, SPEEDS, "impact-free", known).zones[0].upper.point
    assert point is not None
    assert point.is_grazing
    end = ZoneEnd(0.5, "grazing", 1e-12, point=point)
    ((at, found),) = search.probes(row, {(Direction.COLD, 0.4, 0.6): end})
    assert (at, found) == (0, end)
    (probed,) = search.probed([row], [[(at, found)]], "omega", 0.1)
    values = [p.value for p in probed.points]
    assert values == pytest.approx([0.4, 0.5, 0.5, 0.6], abs=1e-6)
    assert values[1] < 0.5 < values[2]
    assert search.probes(probed, {(Direction.COLD, 0.4, 0.6): end}) == []
