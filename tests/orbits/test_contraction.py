"""The test that proves one attractor: where it must hold, and where other motions are known to exist."""

from __future__ import annotations

import numpy as np
import pytest

import gearlash as gl
from gearlash.orbits.contraction import contracts
from gearlash.system import constant


def bilinear(
    soft: float, stiff: float, damping: float, contact: str = "always", gap: float = 0.0
) -> gl.System:
    """x″ + 2 damping x′ + k(x) x = cos τ with k = stiff for x > 0, soft for x < 0."""
    matrix = np.array([[0.0, 1.0], [0.0, -2.0 * damping]])
    forcing = np.array([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    h, g = np.array([1.0, 0.0]), np.array([0.0, -1.0])
    clearance = gl.Clearance(h, g, gap, gap, constant(stiff), constant(soft), contact=gl.ContactRule(contact))
    return gl.System(0.9, matrix, forcing, (clearance,))


@pytest.mark.parametrize("ratio", [0.5, 0.9, 0.999, 1.001, 1.1, 3.0])
def test_the_bilinear_oscillator_contracts_up_to_its_known_bound(ratio: float):
    """Circle criterion: all stiffnesses between a² and b² share a quadratic form if and only if
    b - a < 2 damping."""
    soft, damping = 0.8, 0.1
    stiff = (np.sqrt(soft) + 2.0 * damping * ratio) ** 2
    assert contracts(bilinear(soft, stiff, damping)) is (ratio < 1.0)


def test_where_it_holds_all_starts_lead_to_one_orbit():
    system = bilinear(0.8, 1.1, 0.1)
    assert contracts(system)
    found = [gl.attractor(system, start) for start in ([0.0, 0.0], [5.0, -3.0], [-40.0, 7.0])]
    assert {each.period for each in found if isinstance(each, gl.Orbit)} == {1}
    for each in found[1:]:
        assert each.final_state == pytest.approx(found[0].final_state, abs=1e-9)


def test_no_gap_without_stiffness_contracts():
    """Nothing brings two motions together in the gap: the mean of a difference in x stays."""
    assert contracts(bilinear(0.8, 0.8, 0.1))
    assert not contracts(bilinear(0.8, 0.8, 0.1, gap=0.2))


@pytest.mark.parametrize("case", ["kahraman-singh", "article", "shaw-holmes"])
def test_cases_whose_motions_coexist_do_not_contract(case: str):
    family, _ = gl.load_case(case).family()
    assert not contracts(family.system({}))


def test_a_field_that_jumps_is_not_asked():
    matrix = np.array([[0.0, 1.0], [0.0, -0.2]])
    forcing = np.array([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    h, g = np.array([1.0, 0.0]), np.array([0.0, -1.0])
    stop = gl.Clearance(
        h, g, 0.0, 0.0, constant(1.0), constant(0.9), damping=0.1, contact=gl.ContactRule.IN_CONTACT
    )
    assert not contracts(gl.System(0.9, matrix, forcing, (stop,)))
