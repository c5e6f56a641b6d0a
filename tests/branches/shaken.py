"""An oscillator shaken at its base, with a stiff stop on one side: what it does before the stop is linear."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np
from scipy.optimize import brentq

from gearlash import flow
from gearlash.orbits import Orbit, shoot
from gearlash.system import Clearance, Family, Parameter, System, constant

DEFAULTS = {"omega": 0.79, "a": 0.7 / 1.26, "zeta": 0.01, "beta": 29.0, "gap": 1.0}


@cache
def shaken(side: int = 1) -> Family:
    """x″ + 2ζx′ + x = a ω² cos ωt, and a stop of stiffness β at x = ``side`` · gap; states x, x′."""

    def build(values: Mapping[str, float]) -> System:
        matrix = np.array([[0.0, 1.0], [-1.0, -2.0 * values["zeta"]]])
        forcing = np.zeros((2, 3))
        forcing[1, 1] = values["a"] * values["omega"] ** 2
        hard, soft = constant(values["beta"]), constant(0.0)
        h, g, far = np.array([1.0, 0.0]), np.array([0.0, -1.0]), 1000.0
        if side > 0:
            stop = Clearance(h, g, values["gap"], far, hard, soft, name="stop")
        else:
            stop = Clearance(h, g, far, values["gap"], soft, hard, name="stop")
        return System(values["omega"], matrix, forcing, (stop,))

    parameters = tuple(Parameter(name, default, lower=1e-6) for name, default in DEFAULTS.items())
    return Family(parameters, ("x", "v"), build, lambda values: np.zeros(2))


def response(values: Mapping[str, float]) -> complex:
    """The linear motion is Re of this times exp(iωt)."""
    omega = values["omega"]
    return values["a"] * omega**2 / complex(1.0 - omega**2, 2.0 * values["zeta"] * omega)


def linear(family: Family, values: Mapping[str, float]) -> Orbit:
    """The linear motion as an orbit of the family."""
    z = response(values)
    props = flow.propagators(family.system(values))
    shot = shoot(props, [z.real, -values["omega"] * z.imag], 1)
    assert shot.residual <= 1e-11
    return Orbit(props, shot, 0, shot.status, "")


def touches(values: Mapping[str, float], name: str, lower: float, upper: float) -> list[float]:
    """Every value of a parameter between two at which the amplitude is the gap, ascending."""

    def beyond(value: float) -> float:
        at = {**values, name: value}
        return abs(response(at)) - at["gap"]

    grid = np.geomspace(lower, upper, 4001)
    signs = [beyond(value) for value in grid]
    return [
        float(brentq(beyond, grid[i], grid[i + 1], xtol=1e-15))  # pyright: ignore[reportArgumentType]
        for i in range(len(grid) - 1)
        if signs[i] * signs[i + 1] < 0.0
    ]
