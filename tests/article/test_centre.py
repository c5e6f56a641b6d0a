"""The point of two parameters behind the article's D ≈ 0.3523, and the curves that leave it."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from gearlash.article.branching import Following
from gearlash.article.centre import centres
from gearlash.article.claims import load as claims
from gearlash.article.opening import coincidences
from gearlash.article.report import centre as told
from gearlash.article.report.quantities import Quantities
from gearlash.article.reproduction import Centre, Coincidence, Scan
from gearlash.article.rows import distinct, rows
from gearlash.article.table2 import fill
from gearlash.case import load
from gearlash.jobs import Inline
from gearlash.report.blocks import Table, Text
from gearlash.results import Axis

AT = {"omega": 0.78}
CASE = load("article")
SECOND = ("bearing_damping", "omega", "error_phase", "ripple_2")


@cache
def found() -> tuple[Centre, Scan, Coincidence]:
    swept = rows(CASE, Axis.even("D", 0.336, 0.39, 7), AT, Inline())
    scan = Following.begun(CASE, "D", AT, swept, Inline()).scan(distinct(swept), Inline())
    beside = coincidences(CASE, scan, Inline())
    (centre,) = centres(CASE, claims(), scan, beside, Inline())
    return centre, scan, beside[0][0]


def test_it_is_where_another_program_has_it():
    """In every plane; those of (D, ξ_b) and (D, ω) are known from another program."""
    centre = found()[0]
    assert [place.parameters for place in centre.places] == [("D", name) for name in SECOND]
    assert centre.places[0].values == pytest.approx((0.3448140829648626, 0.0475457194044527), abs=1e-12)
    assert centre.places[1].values == pytest.approx((0.3372309544876, 0.7919290494845), abs=1e-12)
    assert centre.labels == ("6-6-1", "6-6-2")
    assert centre.boundary == -1


@pytest.mark.parametrize("which", range(4))
def test_both_conditions_hold(which: int):
    place = found()[0].places[which]
    assert max(place.errors) < 1e-12
    assert max(place.multiplier, place.distance, place.residual) < 1e-12
    assert abs(place.exponent) < 1e-12


def test_its_curves_are_cut_where_the_sweep_has_its_events():
    """Curves that were followed from the point over damping, cut at the damping of the case."""
    centre, scan, both = found()
    doubling, single, doubled = centre.lines
    assert doubling.crosses == pytest.approx(both.doubling.value, abs=1e-11)
    assert doubled.crosses == pytest.approx(both.grazing.value, abs=1e-11)
    touches = [s.value for branch in scan.branches for s in branch.special if s.is_grazing]
    assert min(abs(value - single.crosses) for value in touches) < 1e-11
    assert round(single.crosses, 4) == 0.3855
    assert [line.labels for line in centre.lines] == [("6-6-1",), centre.labels, ("12-12-2", "12-12-3")]
    assert {line.values[0] for line in centre.lines} == {centre.places[0].values}


def test_the_doubled_orbit_grazes_on_a_curve_tangent_to_the_doubling():
    """Beside the point their distance is far less than the way along them."""
    doubling, _, doubled = found()[0].lines
    base, there = (np.array(line.values) for line in (doubling, doubled))
    apart = np.abs(np.interp(there[:, 1], base[::-1, 1], base[::-1, 0]) - there[:, 0])
    way = np.abs(there[:, 0] - there[0, 0])
    assert apart[1:].max() < 1.2e-5
    assert (apart[1:] < 3e-3 * way[1:]).all()


def test_a_row_of_table_2_has_it_in_every_plane():
    centre, scan, _ = found()
    row = next(row for row in fill((scan,), (), (centre,)) if "the point itself" in row.type)
    assert row.events[0] == "(D, ξ_b) = (0.344814083, 0.0475457194)"
    assert [event.split(" = ")[0] for event in row.events] == ["(D, ξ_b)", "(D, ω)", "(D, ψ₁)", "(D, ε₂)"]
    assert set(row.patterns) == {"6-6-1 → 6-6-2"}


def test_the_report_tells_places_and_cuts():
    centre = found()[0]
    quantities = Quantities.of(CASE)
    blocks = told.blocks(centre, quantities)
    (table,) = [block for block in blocks if isinstance(block, Table)]
    assert len(table.rows) == len(SECOND)
    said = " ".join(str(part) for block in blocks if isinstance(block, Text) for part in block.parts)
    for line in centre.lines:
        assert f"{told.words(line)} at D = {line.crosses:.10g}" in said
    picture = told.picture(centre, (), quantities)
    assert picture is not None
    assert picture.stem == told.stem(centre)


def test_no_coincidence_no_point():
    _, scan, _ = found()
    assert centres(CASE, claims(), scan, (), Inline()) == ()
