"""Systems with orbits of which two multipliers coincide."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np

from gearlash.system import Clearance, ContactRule, Family, Parameter, System, constant, cosines


@cache
def fed() -> Family:
    """An oscillator with a gap that is damped in contact and, where ``free`` is negative, fed with energy all
    along: the product of its two multipliers passes 1."""

    def build(p: Mapping[str, float]) -> System:
        matrix = np.array([[0.0, 1.0], [0.0, -p["free"]]])
        forcing = np.array([[0.0, 0.0, 0.0], [p["load"], p["force"], 0.0]])
        stiffness = cosines(1.0, [p["ripple"]], [0.0])
        gap = Clearance(
            np.array([1.0, 0.0]), np.array([0.0, -1.0]), p["gap"], p["gap"], stiffness, stiffness,
            p["contact"], contact=ContactRule.IN_CONTACT, name="gap",
        )  # fmt: skip
        return System(p["omega"], matrix, forcing, (gap,))

    defaults = {"omega": 0.7, "free": 0.0, "contact": 0.1, "load": 0.1, "force": 0.02, "ripple": 0.0}
    parameters = tuple(Parameter(name, value) for name, value in {**defaults, "gap": 1.0}.items())
    return Family(parameters, ("x", "v"), build, lambda p: np.array([p["gap"] + p["load"], 0.0]))


@cache
def side_by_side() -> Family:
    """Two oscillators with gaps that do not feel each other: one folds, the other one doubles."""

    def build(p: Mapping[str, float]) -> System:
        matrix = np.zeros((4, 4))
        matrix[0, 1] = matrix[2, 3] = 1.0
        matrix[3, 3] = -0.02
        forcing = np.zeros((4, 3))
        forcing[1], forcing[3, 0] = [0.1, 0.05, 0.0], 0.1
        one, two = np.eye(4)[[0, 2]]
        first = Clearance(
            one, -np.eye(4)[1], 1.0, 9.0, constant(1.0), constant(0.0), 0.1,
            contact=ContactRule.IN_CONTACT, name="one",
        )  # fmt: skip
        ripple = cosines(p["stiffness"], [p["stiffness"] * p["ripple"]], [0.0])
        second = Clearance(two, -np.eye(4)[3], 0.0, 9.0, ripple, constant(0.0), name="two")
        return System(p["omega"], matrix, forcing, (first, second))

    defaults = {"omega": 0.7, "stiffness": 0.14, "ripple": 0.3}
    parameters = tuple(Parameter(name, value) for name, value in defaults.items())
    start = np.array([1.1, 0.0, 0.5, 0.0])
    return Family(parameters, ("x", "v", "y", "w"), build, lambda _: start)
