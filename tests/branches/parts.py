"""An oscillator before a soft stop, shaken at a frequency and very weakly at a part of it."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np

from gearlash.system import Clearance, Family, Parameter, System, constant


@cache
def parts(count: int) -> Family:
    """x″ + 0.2 x′ + x = cos ωt + weak · cos ωt/count: so many maxima of nearly one height; states x, x′."""

    def build(values: Mapping[str, float]) -> System:
        matrix = np.array([[0.0, 1.0], [-1.0, -0.2]])
        forcing = np.zeros((2, 2 * count + 1))
        forcing[1, 1], forcing[1, 2 * count - 1] = values["weak"], 1.0
        stop = Clearance(
            np.array([1.0, 0.0]), np.array([0.0, -1.0]), values["gap"], 1000.0, constant(0.5), constant(0.0),
            name="stop",
        )  # fmt: skip
        return System(values["omega"], matrix, forcing, (stop,), cycles=count)

    defaults = {"omega": 1.4, "weak": 1e-7, "gap": 1.2}
    parameters = tuple(Parameter(name, value) for name, value in defaults.items())
    return Family(parameters, ("x", "v"), build, lambda values: np.zeros(2))
