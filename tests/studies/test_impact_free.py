"""The impact-free speeds that a run names, against the grazing points that end them."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from gearlash import continue_branch, flow
from gearlash.branches.continuation import SpecialKind
from gearlash.case import load
from gearlash.gears import spur
from gearlash.orbits import Orbit, attractor, orbit_at
from gearlash.orbits.sign_change import first_sign_change
from gearlash.studies.impact_free import SPEED_REACH, closed_margin, ending, impact_free_speeds, linear_states
from gearlash.system import ContactRule, System
from recorded.record import CASES

FAMILY = load("article-first-harmonic").family()[0]


def unhit(system: System, state: NDArray[np.float64]) -> Orbit | None:
    """The orbit of the pair itself at this state, if it is one and meets no boundary."""
    orbit = orbit_at(flow.propagators(system), state, 1)
    return None if orbit is None or len(orbit.events) else orbit


PAIR = {"D": 1.0, "load": 0.1, "error": 0.08, "mesh_damping": 0.05, "ripple": 0.2, "omega": 0.55}
LINES = {
    "article": (FAMILY, {"omega": 1.03}),
    "drive": (load(CASES / "drive.toml").family()[0], {}),
    "other side": (
        spur.family({**PAIR, "back_stiffness": 0.4, "back_gap": 2.0}),
        {"load": -0.1, "omega": 0.4},
    ),
    "one-sided": (spur.family({**PAIR, "back_stiffness": 0.0}), {}),
    "no-tension": (spur.family(PAIR, ContactRule.NO_TENSION), {}),
    "in-contact": (spur.family(PAIR, ContactRule.IN_CONTACT), {}),
}


@pytest.mark.parametrize("name", LINES)
def test_ends_are_the_grazings_of_the_branch(name: str):
    """Two ways to one number: zeros of the margin of a linear motion, and special points of the branch."""
    family, values = LINES[name]
    values = family.complete(values)
    found = impact_free_speeds(family, values)
    assert found is not None
    assert found.here
    assert found.nearest is None
    ends = (
        (found.lower, found.lower_error, found.lower_ending, 1.001),
        (found.upper, found.upper_error, found.upper_ending, 0.999),
    )
    assert found.lower or found.upper
    for end, error, why, inwards in ends:
        if end is None:
            continue
        assert why == "contact"
        assert error is not None
        assert error < 1e-12
        inside = values | {"omega": inwards * end}
        system = family.system(inside)
        quiet = next(orbit for state in linear_states(system) if (orbit := unhit(system, state)))
        branch = continue_branch(
            family, "omega", quiet, lower=0.998 * end, upper=1.002 * end, values=inside
        )  # fmt: skip
        grazings = [special for special in branch.special if special.kind is SpecialKind.GRAZING]
        apart = min(abs(special.value - end) for special in grazings)
        assert apart <= 3.0 * (error + min(special.error for special in grazings))


@pytest.mark.parametrize(("omega", "end"), [(0.942, "lower"), (1.15, "upper")])
def test_nearest_from_outside_is_the_near_end_and_lies_inside(omega: float, end: str):
    inside = impact_free_speeds(FAMILY, FAMILY.complete({"omega": 1.03}))
    found = impact_free_speeds(FAMILY, FAMILY.complete({"omega": omega}))
    assert found is not None
    assert not found.here
    assert found.nearest is not None
    assert found.nearest == pytest.approx(getattr(inside, end), rel=1e-13)
    assert found.nearest_error is not None
    assert found.nearest_error < 1e-12
    assert closed_margin(FAMILY.system({"omega": found.nearest}), 1) > 0.0


def test_margin_is_the_least_compression_of_the_orbit_itself():
    orbit = attractor(FAMILY.system({"omega": 1.05}), FAMILY.start({"omega": 1.05}))
    margin = closed_margin(FAMILY.system({"omega": 1.05}), 1)
    assert margin == pytest.approx(orbit.extrema.displacement.min() - 1.0, rel=1e-10)


def test_load_reversed_and_error_shifted_mirrors_the_window():
    """X → −X with load and error negated is the same motion, on the back side."""
    mirrored = FAMILY.complete({"omega": 1.03, "load": -0.09, "error": -0.27018})
    found, plain = (impact_free_speeds(FAMILY, v) for v in (mirrored, FAMILY.complete({"omega": 1.03})))
    assert found is not None
    assert plain is not None
    assert found.lower == pytest.approx(plain.lower, rel=1e-13)
    assert found.upper == pytest.approx(plain.upper, rel=1e-13)


def test_closed_form_of_the_constant_stiffness():
    """Without damping X has the amplitude ω² E/|1 − ω²|, and contact is kept while that is below the load."""
    family = spur.family({"omega": 0.5, "D": 1.0, "load": 0.1, "error": 0.05, "mesh_damping": 1e-9})
    found = impact_free_speeds(family, family.complete({"omega": 0.6}))
    assert found is not None
    assert found.upper == pytest.approx(np.sqrt(0.1 / 0.15), rel=1e-6)  # ω² E = f (1 − ω²)


def test_no_side_carries_without_load():
    assert impact_free_speeds(FAMILY, FAMILY.complete({"load": 0.0})) is None


@pytest.mark.parametrize("centre", [1.3, 1.3021, 1.3047])
@pytest.mark.parametrize("factor", [1.01, 1.0 / 1.01])
def test_a_loss_of_contact_between_two_steps_is_found(centre: float, factor: float):
    """A resonance narrower than a step, whose flanks are seen: Δ(ω) = 1 − h/(1 + ((ω − c)/w)²)."""

    def margin(omega: float) -> float:
        return 1.0 - 1.5 / (1.0 + ((omega - centre) / 5e-3) ** 2)

    start, last = (1.0, 1.7) if factor > 1.0 else (1.7, 1.0)
    found, _ = first_sign_change(margin, (start, margin(start)), factor, last)
    assert found is not None
    edge = 5e-3 * np.sqrt(0.5)
    assert found.value == pytest.approx(centre - edge if factor > 1.0 else centre + edge, rel=1e-14)
    assert ending(found) == "contact"


def test_an_end_of_stability_is_not_called_a_loss_of_contact():
    """Mathieu: with the stiffness 1 + 0.3 cos ωτ and little damping, X at rest in contact is unstable near
    ω = 2; its load keeps it far from the gap."""
    family = spur.family(
        {"omega": 1.5, "D": 1.0, "load": 1.0, "ripple": 0.3, "mesh_damping": 0.01, "error": 0.0}
    )
    found = impact_free_speeds(family, family.complete({"omega": 1.5}))
    assert found is not None
    assert found.here
    assert found.upper_ending == "stability"
    assert found.upper is not None
    assert found.upper_error is not None
    assert 1.8 < found.upper < 1.9
    doubling = continue_branch(family, "omega", lower=1.7, upper=1.95, values={"omega": 1.7}).special[0]
    assert doubling.kind is SpecialKind.DOUBLING
    assert abs(found.upper - doubling.value) <= found.upper_error + doubling.error
    assert found.upper_error < 1e-11


def test_the_interval_says_how_finely_it_was_looked_at():
    found = impact_free_speeds(FAMILY, FAMILY.complete({"omega": 1.03}))
    assert found is not None
    assert found.step == pytest.approx(0.01)
    assert (found.lower_ending, found.upper_ending) == ("contact", "contact")


def test_where_the_motion_cannot_be_solved_for_it_is_not_called_unstable():
    def margin(omega: float) -> float:
        return 1.0 if omega < 1.25 else np.nan

    found, reached = first_sign_change(margin, (1.0, 1.0), 1.01, 2.0)
    assert found is not None
    assert found.value == pytest.approx(1.25, rel=1e-14)
    assert ending(found) == "unsolved"
    assert 1.25 <= reached < 1.27


def test_no_speed_is_looked_at_beyond_what_is_said():
    asked: list[float] = []

    def margin(omega: float) -> float:
        asked.append(omega)
        return -1.0

    assert first_sign_change(margin, (1.0, -1.0), 1.01, 2.0) == (None, 2.0)
    assert first_sign_change(margin, (1.0, -1.0), 1.0 / 1.01, 0.5) == (None, 0.5)
    assert (min(asked), max(asked)) == (0.5, 2.0)


def test_what_lies_farther_off_than_the_nearest_was_not_searched():
    found = impact_free_speeds(FAMILY, FAMILY.complete({"omega": 0.942}))
    assert found is not None
    assert found.nearest is not None
    assert found.searched_to <= 1.01 * found.nearest
    assert found.searched_from == pytest.approx(0.942 - (found.nearest - 0.942))
    assert found.searched_from > 0.942 / SPEED_REACH
