"""Labels against brute force: what is read off strobes, and why labels differ."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.labels import (
    APERIODIC,
    CHANCE,
    EXPLAINED,
    LATE,
    LATER,
    brute_force,
    compare,
    explain,
    page,
    read,
)
from benchmarks.pixels import pixel_values
from benchmarks.works import family
from gearlash import flow


def test_read_takes_the_least_period_and_counts_over_it():
    strobes = np.array([[0.0, 1.0], [2.0, 3.0]] * 130)[:257]
    contacts = np.zeros((256, 4), dtype=np.int64)
    contacts[::2, 0], contacts[1::2, 1] = 3, 1
    assert read(strobes, contacts) == ("2-3-1", 0.0)
    rng = np.random.default_rng(1)
    label, least = read(rng.uniform(size=(257, 2)), contacts)
    assert label == APERIODIC
    assert least > 0.1


@pytest.mark.parametrize(("omega", "D", "label"), [(1.05, 1.0, "1-0-0"), (0.95, 1.0, "1-1-0")])
def test_brute_force_knows_the_article(omega, D, label):
    pairs = family("article-first-harmonic")
    values = {"omega": omega, "D": D}
    props = flow.propagators(pairs.system(values))
    assert brute_force(props, pairs.start(values), 2_000)[0] == label


def test_a_search_that_would_name_another_orbit_is_not_explained_away():
    """A label that no start near this one leads to, and no longer wait, stays open."""
    pairs, values = family("article-first-harmonic"), {"omega": 1.05, "D": 1.0}
    props = flow.propagators(pairs.system(values))
    why, figures = explain(props, pairs.start(values), "7-7-7", "1-0-0", 500, "")
    assert why == "not explained"
    assert "1-0-0" in figures


def test_a_motion_called_aperiodic_too_early_is_told_with_the_time_it_took():
    pairs, values = family("article-first-harmonic"), {"omega": 0.95, "D": 1.0}
    props = flow.propagators(pairs.system(values))
    why, figures = explain(props, pairs.start(values), APERIODIC, "1-1-0", 1_000, "")
    assert why == LATE
    assert "settled at" in figures


def test_a_long_transient_is_no_matter_of_rounding():
    """Chaos for 150,000 periods and more, from every start beside it, and then 2-1-0."""
    pairs, values = family("article-first-harmonic"), {"omega": 1.159167, "D": 1.092734}
    props = flow.propagators(pairs.system(values))
    brute, used = brute_force(props, pairs.start(values), LATER)
    assert brute == "2-1-0"
    why, figures = explain(props, pairs.start(values), APERIODIC, brute, used, "")
    assert why == LATE
    assert "all starts beside it" in figures


def test_page_of_a_few_pixels():
    found = [compare(values) for values in pixel_values(6)]
    text = page(found)
    assert f"of {len(found)} labels are equal" in text
    assert all(name in text for name in EXPLAINED)
    assert all(one.why in ("", *EXPLAINED) for one in found)
    assert CHANCE in text
