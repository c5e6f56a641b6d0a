"""A report looks at fewer values where each takes long, and says so."""

from __future__ import annotations

from pathlib import Path

import pytest

import gearlash as gl
from gearlash.results import Axis
from gearlash.studies.grids import FINE, LEAST_PIXELS, LEAST_SPEEDS, PIXELS, SPEEDS, Grids

DRIVE = Path(__file__).parents[1] / "cases" / "drive.toml"


@pytest.fixture(scope="module")
def case():
    return gl.load_case(str(DRIVE))


def test_a_pair_at_a_usual_speed_is_looked_at_as_closely_as_ever(case):
    grids = Grids.of_case(case)
    assert (grids.speeds, grids.fine, grids.pixels, grids.told) == (SPEEDS, FINE, PIXELS, "")
    axis = Axis.even("omega", 0.5, 1.0, FINE)
    assert grids.fewer(axis) is axis


def test_a_slow_pair_is_looked_at_less_closely_and_that_is_told(case):
    grids = Grids.of_case(case.with_overrides({"pinion_speed": "40 rpm"}))
    assert LEAST_SPEEDS <= grids.speeds < SPEEDS
    assert LEAST_PIXELS[0] <= grids.pixels[0] < PIXELS[0]
    few = grids.fewer(Axis.even("omega", 0.5, 1.0, FINE))
    assert (len(few), few.values[0], few.values[-1]) == (grids.fine, 0.5, 1.0)
    assert f"maps {grids.pixels[0]} by {grids.pixels[1]} values in place of 40 by 20" in grids.told
