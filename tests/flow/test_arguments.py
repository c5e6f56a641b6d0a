"""Functions of one system take the system, or its propagators."""

from __future__ import annotations

import numpy as np

from gearlash import flow
from oracles.oscillators import oscillator


def test_a_system_and_its_propagators_are_taken_alike():
    system = oscillator(omega=0.8, stiffness=(3.0, 2.0), damping=0.05, force=(0.2, 1.0, 0.3))
    starts = [[0.3, -0.4], [1.2, 0.1]]
    for call in (
        lambda given: flow.march(given, starts[0], 5).states,
        lambda given: flow.march_many(given, starts, 5).states,
        lambda given: flow.trace(given, starts[0], 1.5, 0.2).polynomials,
        lambda given: flow.carry(given, starts[0], 1.5, 0.2).state,
        lambda given: flow.growth(given, starts[0], [1.0, 0.0], 4, 2).logarithms,
    ):
        assert np.array_equal(call(system), call(flow.propagators(system)))
    first, second = (flow.variational(given, starts[0], 1.5) for given in (system, flow.propagators(system)))
    assert first.jacobian is not None
    assert second.jacobian is not None
    assert np.array_equal(first.jacobian, second.jacobian)
