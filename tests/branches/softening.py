"""Oscillators in permanent contact whose linear motion ends to exist at a value known in closed form."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np

from gearlash.system import Clearance, ContactRule, Family, Parameter, System, constant


@cache
def softening(rule: ContactRule = ContactRule.ALWAYS, side: int = 1) -> Family:
    """x″ + 0.2 x′ - κ x + Φ = ±load + E cos ωt with a contact of stiffness 1: its mean is (load + D)/(1 - κ)
    on side +, and at κ = 1 there is none."""

    def build(values: Mapping[str, float]) -> System:
        matrix = np.array([[0.0, 1.0], [values["kappa"], -0.2]])
        forcing = np.array([[0.0, 0.0, 0.0], [side * values["load"], values["error"], 0.0]])
        h, g, gap, stiffness = np.array([1.0, 0.0]), np.array([0.0, -1.0]), values["D"], constant(1.0)
        return System(
            values["omega"],
            matrix,
            forcing,
            (Clearance(h, g, gap, gap, stiffness, stiffness, 0.1, contact=rule),),
        )

    defaults = {"kappa": 0.8, "load": 0.3, "error": 0.4, "omega": 1.3, "D": 1.0}
    parameters = tuple(Parameter(name, value) for name, value in defaults.items())
    return Family(parameters, ("x", "v"), build, lambda values: np.array([side * 4.0, 0.0]))


@cache
def coupled() -> Family:
    """x″ + 0.1 x′ + Φ = load + E cos ωt + y/2, y′ = μ y + (x - D - load)/5 + tilt. In permanent contact a
    multiplier is 1 at μ = -1/10, and the forcing is orthogonal to the adjoint null vector if tilt = 0."""

    def build(values: Mapping[str, float]) -> System:
        matrix = np.array([[0.0, 1.0, 0.0], [0.0, -0.1, 0.5], [0.2, 0.0, values["mu"]]])
        forcing = np.zeros((3, 3))
        forcing[1] = [values["load"], values["error"], 0.0]
        forcing[2, 0] = values["tilt"] - 0.2 * (values["D"] + values["load"])
        h, g, gap, stiffness = np.eye(3)[0], -np.eye(3)[1], values["D"], constant(1.0)
        return System(
            values["omega"], matrix, forcing, (Clearance(h, g, gap, gap, stiffness, stiffness, 0.1),)
        )

    defaults = {"mu": -0.5, "load": 0.5, "error": 0.05, "omega": 1.7, "D": 1.0, "tilt": 0.0}
    parameters = tuple(Parameter(name, value) for name, value in defaults.items())
    return Family(parameters, ("x", "v", "y"), build, lambda values: np.array([1.5, 0.0, 0.0]))
