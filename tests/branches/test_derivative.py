"""Derivatives along the parameter of a branch: exact where that can be known, and how it is told."""

from __future__ import annotations

from collections.abc import Mapping
from math import isnan

import numpy as np
import pytest

import gearlash as gl
from gearlash.branches.continuation import ContinuationSettings, DerivativeKind
from gearlash.branches.continuation.derivative import Along
from gearlash.branches.continuation.equations import Equations, Line
from gearlash.orbits import Orbit, orbit_at
from gearlash.system import ContactRule, Family, System
from orbits.contacts import one_dof_under, two_gaps
from orbits.members import one_dof, orbit

QUICK = ContinuationSettings(certify=False, longest=0.2)
EXACT, DIFFERENCE = DerivativeKind.EXACT, DerivativeKind.DIFFERENCE


def along(family: Family, name: str, lower: float, upper: float) -> Along:
    return Line(family, family.defaults, name, lower, upper).along


@pytest.mark.parametrize(
    ("name", "lower", "upper", "kind"),
    [
        ("D", 0.4, 1.3, EXACT), ("load", -0.2, 0.3, EXACT), ("error", 0.0, 0.2, EXACT),
        ("back_gap", 0.5, 1.5, EXACT), ("omega", 0.5, 1.5, DIFFERENCE), ("ripple", 0.1, 0.3, DIFFERENCE),
        ("mesh_damping", 0.01, 0.1, DIFFERENCE), ("error_phase", 0.0, 1.0, DIFFERENCE),
    ],
)  # fmt: skip
def test_load_error_and_gap_are_affine_and_nothing_else_is(name, lower, upper, kind):
    assert along(one_dof(error=0.1), name, lower, upper).kind is kind


@pytest.mark.parametrize("rule", ContactRule)
@pytest.mark.parametrize("name", ["force", "load", "stop", "gap", "omega"])
def test_two_gaps(rule, name):
    """Under every rule, the slope of the equations is that of orbits beside."""
    family = two_gaps(rule)
    found = orbit(family)
    value = family.defaults[name]
    line = Line(family, family.defaults, name, 0.5 * value, 1.5 * value)
    assert line.along.kind is (DIFFERENCE if name == "omega" else EXACT)
    equations = Equations.of(line, found)
    here = equations.evaluate(equations.unknowns(found, value))
    assert here is not None
    states = [_beside(found, line.system_at(value + k * 1e-4)).state for k in (-2, -1, 1, 2)]
    moved = (8.0 * (states[2] - states[1]) - (states[3] - states[0])) / 12e-4
    monodromy = np.linalg.matrix_power(np.eye(4), 1) - found.shot.monodromy
    by_value = (equations.slope(here) / line.unit).reshape(equations.segments, -1) * equations.size
    if equations.segments == 1:
        assert monodromy @ moved == pytest.approx(by_value[0], abs=1e-7 * (1.0 + np.abs(moved).max()))


def _beside(found: Orbit, props) -> Orbit:
    near = orbit_at(props, found.state, found.shot.period)
    assert near is not None
    return near


def test_in_permanent_contact_the_orbit_moves_with_load_and_gap_as_its_closed_form():
    """X = D + load/η in the mean, and nothing else of it depends on them."""
    family = one_dof(omega=1.5, D=1.0, load=0.5, error=0.02, mesh_damping=0.05)
    found = orbit(family)
    for name in ("D", "load"):
        line = Line(family, family.defaults, name, 0.4, 1.4)
        equations = Equations.of(line, found)
        here = equations.evaluate(equations.unknowns(found, family.defaults[name]))
        assert here is not None
        slope = equations.slope(here) / line.unit * equations.size
        by_value = np.linalg.solve(np.eye(2) - found.shot.monodromy, slope)
        assert by_value == pytest.approx([1.0, 0.0], abs=1e-13)


def bent(at: float, width: float) -> Family:
    """A gap that is its parameter but for a bump."""
    plain = one_dof()

    def build(values: Mapping[str, float]) -> System:
        bump = 0.01 * max(0.0, 1.0 - abs(values["D"] - at) / width)
        return plain.build({**values, "D": values["D"] + bump})

    return Family(plain.parameters, plain.states, build, plain.cold_start)


def test_what_only_looks_affine_is_found_out_by_the_systems_that_are_built():
    one = along(bent(0.7, 0.02), "D", 0.4, 1.0)
    assert one.kind is EXACT
    for value, kind in ((0.5, EXACT), (0.7, DIFFERENCE), (0.5, DIFFERENCE)):
        one.hold(value, one.build(value))
        assert one.kind is kind


@pytest.mark.parametrize("name", ["omega", "ripple", "error_phase"])
def test_differences_over_the_interval_and_beside_the_orbit_agree(name):
    """The speed is a polynomial in all numbers, and a phase is not."""
    family = one_dof(error=0.1, ripple=0.2)
    one = along(family, name, 0.4, 1.2)
    value, step = 0.83, 1e-4
    change = one.at(value, one.build(value))
    rates = {name: (one.build(value + step), one.build(value - step))}
    high, low = rates[name]
    for found, above, below in (
        (change.omega, high.omega, low.omega),
        (change.forcing, high.forcing, low.forcing),
        (change.clearances[0].stiffness[0], *(s.clearances[0].stiffness_plus for s in (high, low))),
    ):
        assert found == pytest.approx((np.asarray(above) - below) / (2.0 * step), rel=1e-7, abs=1e-10)
    assert one.error < (1e-12 if name == "omega" else 1e-9)


def test_a_branch_says_which_it_used(tmp_path):
    family = one_dof_under(ContactRule.IN_CONTACT, omega=1.5, error=0.02)
    exact = gl.continue_branch(family, "D", lower=0.9, upper=1.1, steps=QUICK)
    other = gl.continue_branch(family, "omega", lower=1.45, upper=1.55, steps=QUICK)
    assert (exact.derivative, exact.derivative_error) == (EXACT, 0.0)
    assert other.derivative is DIFFERENCE
    assert 0.0 < other.derivative_error < 1e-7
    again = gl.load_branch(gl.save_branch(other, tmp_path / "branch.json", family))
    assert (again.derivative, again.derivative_error) == (DIFFERENCE, other.derivative_error)


def test_a_file_of_before_says_nothing_of_it(tmp_path):
    family = one_dof(omega=1.5, D=1.0)
    branch = gl.continue_branch(family, "D", lower=0.9, upper=1.1, steps=QUICK)
    path = gl.save_branch(branch, tmp_path / "branch.json", family)
    text = path.read_text(encoding="utf-8")
    assert text.count('"derivative"') == 1
    path.write_text(
        text.replace('"derivative"', '"of_before"').replace('"derivative_error"', '"too"'), "utf-8"
    )
    old = gl.load_branch(path)
    assert old.derivative is None
    assert isnan(old.derivative_error)


def test_a_physical_name_is_as_affine_as_its_own():
    case = gl.load_case("article")
    branch = gl.continue_branch(
        case, "backlash", lower="98 um", upper="102 um", values={"omega": 1.05}, steps=QUICK
    )
    assert branch.derivative is EXACT


@pytest.mark.parametrize("width", [0.0, 1e-12, 1e-6])
def test_a_narrow_interval_costs_no_digits(width):
    one = along(one_dof(error=0.1), "D", 0.9, 0.9 + width)
    assert one.kind is EXACT
    assert one.at(0.9, one.build(0.9)).clearances[0].gaps == pytest.approx([1.0, 1.0], rel=1e-13)
    at_end = along(one_dof(), "D", 0.0, width)
    assert at_end.at(0.0, at_end.build(0.0)).clearances[0].gaps == pytest.approx([1.0, 1.0], rel=1e-9)


def test_beside_a_value_at_which_the_family_ends():
    """To first order there, which its error says."""
    plain = one_dof()

    def build(values: Mapping[str, float]) -> System:
        return plain.build({**values, "mesh_damping": 0.5 * np.sin(values["mesh_damping"])})

    one = along(Family(plain.parameters, plain.states, build, plain.cold_start), "mesh_damping", 0.0, 1.0)
    for value in (0.0, 0.1 * np.pi):
        change = one.at(value, one.build(value))
        assert change.clearances[0].dampings == pytest.approx([np.cos(value), np.cos(value)], rel=1e-6)
    assert one.error >= 1e-7
