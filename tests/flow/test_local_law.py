"""The local law of grazing: what an excursion of depth d does, for all contact rules.

3/2 in d for `always` and `in-contact`, and for `no-tension` where the pressing force touches zero. Not for
`no-tension` where contact is met from the gap: the damper pushes on the way in and does not pull on the way
out, so the change is ζ d to leading order, and the derivative of the flow jumps by ζ g hᵀ at the touch.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearlash import flow
from gearlash.system import ContactRule, Status

pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
from oracles import region_oracle
from oracles.local_law import Excursion, excursion

TOUCHES = {
    "always, from the gap": (ContactRule.ALWAYS, False, False),
    "always, from contact": (ContactRule.ALWAYS, False, True),
    "in-contact, from the gap": (ContactRule.IN_CONTACT, False, False),
    "in-contact, from contact": (ContactRule.IN_CONTACT, False, True),
    "no-tension, from the gap": (ContactRule.NO_TENSION, False, False),
    "no-tension, force lost": (ContactRule.NO_TENSION, True, True),
    "no-tension, force found in the overlap": (ContactRule.NO_TENSION, True, False),
}
FROM_THE_GAP = "no-tension, from the gap"


def _draws(name: str, depth: float, count: int):
    rng = np.random.default_rng([7, list(TOUCHES).index(name)])
    rule, early, from_contact = TOUCHES[name]
    made = 0
    while made < count:
        found = excursion(rng, int(rng.choice([4, 5])), rule, early, from_contact, depth)
        if np.linalg.norm(found.predicted) > 3e-12 * (depth / 1e-8) ** 1.5:  # far above double rounding
            made += 1
            yield found


@pytest.mark.slow
@pytest.mark.parametrize("name", TOUCHES)
def test_law_in_80_bits(name):
    """Within 1 % at d = 1e-8, and the rest falls with d: that coefficient, no other."""
    worst = {}
    for depth in (1e-5, 1e-8):
        apart = [
            float(np.linalg.norm(e.measured() - e.predicted) / np.linalg.norm(e.predicted))
            for e in _draws(name, depth, 4)
        ]
        worst[depth] = max(apart)
    assert worst[1e-8] < 0.01
    assert worst[1e-8] < worst[1e-5]


@pytest.mark.parametrize("name", TOUCHES)
def test_law_in_the_flow(name):
    """The flow with the boundary held and not, from the same start: their difference at d = 1e-8."""
    for e in _draws(name, 1e-8, 4):
        start, span = e.start.astype(float), e.end - e.begin
        props = flow.propagators(e.system)
        hold = flow.Hold(e.side.sign, e.begin - 1e-3, e.end + 1e-3)
        real = flow.carry(props, start, span, e.begin)
        held = flow.carry(props, start, span, e.begin, hold=hold)
        assert real.status is held.status is Status.OK
        assert real.contacts.sum() == 2
        assert held.contacts.sum() == 0
        apart = np.linalg.norm((real.state - held.state) - e.predicted)
        assert apart < 0.01 * np.linalg.norm(e.predicted)


def test_hold_of_the_second_clearance():
    """The same where another clearance is listed first: the hold names the one that is meant."""
    (e,) = _draws("in-contact, from the gap", 1e-8, 1)
    (c,) = e.system.clearances
    idle = replace(c, gap_plus=50.0, gap_minus=50.0, name="far")
    both = replace(e.system, clearances=(idle, c))
    start, span, props = e.start.astype(float), e.end - e.begin, flow.propagators(both)
    hold = replace(flow.Hold(e.side.sign, e.begin - 1e-3, e.end + 1e-3), clearance=1)
    real, held = flow.carry(props, start, span, e.begin), flow.carry(props, start, span, e.begin, hold=hold)
    assert real.contacts.reshape(-1, 4).sum(axis=1).tolist() == [0, 2]
    assert held.contacts.sum() == 0
    apart = np.linalg.norm((real.state - held.state) - e.predicted)
    assert apart < 0.01 * np.linalg.norm(e.predicted)


@pytest.mark.parametrize("name", TOUCHES)
def test_exponent(name):
    """From 80-bit runs through one touch at depths a hundred times apart; no law in it."""
    found = [excursion(np.random.default_rng(5), 4, *TOUCHES[name], depth) for depth in (1e-6, 1e-8)]
    assert np.array_equal(found[0].system.matrix, found[1].system.matrix)
    assert abs(found[0].start - found[1].start).max() < 1e-3
    sizes = [float(np.linalg.norm(e.measured())) for e in found]
    exponent = np.log10(sizes[0] / sizes[1]) / 2
    assert exponent == pytest.approx(1.0 if name == FROM_THE_GAP else 1.5, abs=0.01)


@pytest.mark.parametrize("name", TOUCHES)
def test_derivative_at_a_touch(name):
    """As d → 0 the derivative tends to that of the smooth system, except under no-tension from the gap:
    there it differs by ζ g hᵀ between the flows before and after. Flow and 80 bits alike."""
    (e,) = _draws(name, 1e-10, 1)
    start, span, half = e.start.astype(float), e.end - e.begin, e.at - e.begin
    held = (e.side.clearance, e.side.sign, e.from_contact)
    _, real = _derivative(e, e.start, e.begin, span, None)
    _, smooth = _derivative(e, e.start, e.begin, span, held)
    there, before = _derivative(e, e.start, e.begin, half, held)
    _, after = _derivative(e, there, e.at, span - half, held)
    (c,) = e.system.clearances
    jump = after @ np.outer(c.g, c.h) @ before * e.side.damping
    expected = smooth + (jump if name == FROM_THE_GAP else 0.0)
    size = float(np.abs(smooth).max())
    assert float(np.abs(real - expected).max()) < 1e-3 * size
    assert float(np.abs(jump).max()) > 1e-2 * size or name != FROM_THE_GAP
    carried = flow.variational(flow.propagators(e.system), start, span, e.begin)
    assert carried.jacobian is not None
    assert (
        np.abs(carried.jacobian - real).max() < 1e-4 * size
    )  # a start rounded by 1e-16 moves d by 1e-6 of it


def _derivative(e: Excursion, state, begin: float, span: float, held):
    """(end state, Jacobian) in 80 bits."""
    walk = region_oracle.run(e.system, state, span, begin, variational=True, held=held)
    assert walk.jacobian is not None
    return walk.state, walk.jacobian
