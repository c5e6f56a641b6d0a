"""What a search was allowed is what it takes: base periods of the motion, whatever it turns out to be."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash import case
from gearlash.orbits import Orbit, Settings, Unresolved, attractor
from orbits.members import article, built, one_dof

BUDGETS = [1, 10, 96, 97, 500, 1_100]
PLACES = {
    "article": (article, {}),
    "chaos": (article, {"omega": 0.78, "D": 0.3}),
    "long period": (article, {"omega": 0.858}),
    "quasi-periodic": (article, {"omega": 0.875}),
    "more chaos": (article, {"omega": 0.6}),
    "one degree of freedom": (one_dof, {"omega": 1.35, "D": 0.56, "error": 0.22}),
    "hardly damped": (one_dof, {"omega": 0.5, "mesh_damping": 1e-4}),
    "three cycles a base period": (lambda: case.load("two-stage").family()[0], {}),
}


@pytest.mark.parametrize("kind", PLACES)
@pytest.mark.parametrize("budget", BUDGETS)
def test_a_budget_is_not_exceeded(kind, budget):
    """Short of patience, beyond it, with long averages asked for, and long orbits."""
    made, place = PLACES[kind]
    family = made()
    props, start = built(family, **place), family.start(place)
    for settings in (
        Settings(budget=budget),
        Settings(budget=budget, patience=50, exponent_periods=50),
        Settings(budget=budget, max_period=4_096),
        Settings(budget=budget, max_period=1, patience=1, exponent_periods=10_000),
    ):
        found = attractor(props, start, settings)
        assert found.periods_used <= budget, found.message
        assert "nan" not in found.message


def test_what_a_short_search_says():
    """No number is told that was not computed, and no more periods than were."""
    props, start = built(article(), omega=0.78, D=0.3), article().start({"D": 0.3})
    short = attractor(props, start, Settings(budget=10))
    assert type(short) is Unresolved
    assert "within 10;" in short.message
    assert np.isnan(short.largest_exponent)
    longer = attractor(props, start, Settings(budget=900))
    assert type(longer) is Unresolved
    assert "within 900;" in longer.message
    assert longer.largest_exponent > longer.exponent_error > 0.0


def test_a_neighbours_orbit_is_tried_without_a_motion():
    """So it costs nothing of the budget; where it fails the search has all of it."""
    family = article()
    props, start = built(family), family.start({})
    known = attractor(props, start)
    assert isinstance(known, Orbit)
    tried = attractor(props, start, Settings(budget=1), trial=(known.state, known.shot.period))
    assert isinstance(tried, Orbit)
    assert tried.periods_used == 0
    failed = attractor(built(family, omega=0.78, D=0.3), start, Settings(budget=60), trial=(start + 9.0, 3))
    assert failed.periods_used <= 60
