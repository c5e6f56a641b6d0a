"""Ends of zones do not depend on the axis: what lies between two of its values is found."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from gearlash import case, orbits, studies
from gearlash.branches import locate_multiplier
from gearlash.studies import Axis
from gearlash.studies.zone_end import RANGE, UNKNOWN
from studies.classical import CLASSICAL, loss_of_contact


def sharp_loss_of_contact(damping: float, load: float, error: float) -> tuple[float, float]:
    """Frequencies at which the amplitude ω²E/|1 − ω² + 2iζω| is the load: a quadratic in w = ω²."""
    a, b, c = 1.0 - (error / load) ** 2, 4.0 * damping**2 - 2.0, 1.0
    root = math.sqrt(b * b - 4.0 * a * c)
    return math.sqrt((-b - root) / (2.0 * a)), math.sqrt((-b + root) / (2.0 * a))


@pytest.mark.parametrize("count", [2, 3, 5, 15])
def test_impacts_between_two_quiet_points_end_the_zones(count: int):
    """However few points: motion is quiet at both ends of the range, and has impacts around the resonance."""
    low, high = loss_of_contact()
    found = studies.zones(CLASSICAL, Axis.even("omega", 0.3, 1.6, count))
    intervals = [*found.zones, *found.wider]
    assert not any(z.lower.value < 0.5 * (low + high) < z.upper.value for z in intervals)
    solved = [end for z in intervals for end in (z.lower, z.upper) if end.kind == "grazing"]
    assert any(abs(end.value - low) < 1e-9 for end in solved)
    assert any(abs(end.value - high) < 1e-9 for end in solved)


@pytest.mark.slow
def test_an_end_does_not_depend_on_the_step_of_the_sweep():
    """The impacting motion of this pair is lost in a step of a 128th of the axis, but goes on to a fold."""
    drive = case.load(str(Path(__file__).parents[1] / "cases" / "drive.toml"))
    family, scales = drive.family()
    values = scales.omega_from_rpm(np.array([1000.0, 3500.0, 6000.0]))
    down = studies.sweep(family, Axis("omega", np.linspace(0.503, 0.517, 15)), direction="down")
    assert down.points[0].label == "1-1-0"
    orbit = orbits.attractor(family.system({"omega": 0.503}), down.points[0].state)
    assert isinstance(orbit, orbits.Orbit)
    fold = locate_multiplier(family, "omega", orbit, 1, values={"omega": 0.503})
    end = studies.zones(drive, Axis("omega", values)).zones[0].upper
    assert (end.kind, end.inside, end.outside) == ("fold", "1-0-0", "1-1-0")
    assert end.value == pytest.approx(fold.value, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("range_", [(0.5, 1.5), (0.4, 1.31), (0.73, 1.9)])
def test_a_loss_of_contact_narrower_than_a_step_is_found_by_its_flanks(range_: tuple[float, float]):
    """A resonance with ζ = 0.001, in which contact is lost over 1.3e-3 in ω only."""
    values = {"mesh_damping": 1e-3, "load": 0.1, "error": 2.4e-4}
    low, high = sharp_loss_of_contact(1e-3, 0.1, 2.4e-4)
    assert 1e-3 < high - low < 2e-3
    found = studies.zones(CLASSICAL, Axis.even("omega", *range_, 5), values=values)
    assert found.resolution > 3.0 * (high - low)
    intervals = [*found.zones, *found.wider]
    assert not any(z.contains(0.5 * (low + high)) for z in intervals)
    ends = {round(e.value, 9) for z in intervals for e in (z.lower, z.upper) if e.kind == "grazing"}
    assert {round(low, 9), round(high, 9)} <= ends


def test_a_load_that_changes_sides_is_no_quiet_interval_through_zero():
    """Contact on the drive side and contact on the back side have the gap between them."""
    values = {"omega": 0.5, "mesh_damping": 0.3}
    found = studies.zones(CLASSICAL, Axis.even("load", -0.2, 0.2, 2), values=values)
    intervals = [*found.zones, *found.wider]
    amplitude = 0.05 * 0.25 / abs(0.75 + 0.3j)
    assert not any(z.lower.value < 0.0 < z.upper.value for z in intervals)
    ends = [e.value for z in intervals for e in (z.lower, z.upper) if e.kind == "grazing"]
    assert min(abs(e - amplitude) for e in ends) < 1e-9
    assert min(abs(e + amplitude) for e in ends) < 1e-9


def test_the_step_that_is_told_is_that_between_orbits_of_a_branch():
    found = studies.zones(CLASSICAL, Axis.even("omega", 0.3, 0.6, 4))
    assert found.resolution == pytest.approx(0.1)
    (branch,) = found.branches
    assert found.step == pytest.approx(float(np.diff(branch.parameter).max()), rel=1e-9)


def test_one_quiet_point_is_enough_to_follow_its_motion():
    axis = Axis("D", np.array([-1.0, 0.5]))
    found = studies.zones(CLASSICAL, axis, values={"omega": 0.5})
    (zone,) = found.zones
    assert (zone.lower.kind, zone.upper.value) == (UNKNOWN, 0.5)
    assert found.complete


def test_what_cannot_be_computed_ends_a_zone_without_a_bound():
    axis = Axis("D", np.array([-1.0, -0.5, 0.5, 1.0]))
    found = studies.zones(CLASSICAL, axis, values={"omega": 0.5})
    (zone,) = found.zones
    assert (zone.lower.kind, zone.upper.kind) == (UNKNOWN, RANGE)
    assert zone.lower.value == pytest.approx(0.0, abs=1e-6)
    assert zone.lower.outside is None
    assert "no system" in zone.lower.reason
    assert found.wider == ()
