"""Systems with two gaps and with other contact rules, for tests of orbits."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np

from gearlash.gears import spur
from gearlash.system import Clearance, ContactRule, Family, Parameter, System, constant, cosines

RATIO = 0.5  # mass of the first over that of the second body


@cache
def two_gaps(rule: ContactRule = ContactRule.ALWAYS) -> Family:
    """A body on a spring that hits a stop on one side only, and a second one coupled to it through a gap of
    its own; states x, x', y, y'."""

    def build(values: Mapping[str, float]) -> System:
        matrix = np.array(
            [[0.0, 1.0, 0.0, 0.0], [-1.0, -0.1, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0], [0.0, 0.0, -0.3, -0.08]]
        )
        forcing = np.zeros((4, 3))
        forcing[1] = [values["load"], values["force"], 0.0]
        stop = Clearance(
            np.array([1.0, 0.0, 0.0, 0.0]), np.array([0.0, -1.0, 0.0, 0.0]), values["stop"], 0.0,
            constant(4.0), constant(0.0), 0.2, contact=rule, name="stop",
        )  # fmt: skip
        link = Clearance(
            np.array([1.0, 0.0, -1.0, 0.0]), np.array([0.0, -1.0, 0.0, RATIO]), values["gap"], values["gap"],
            cosines(2.0, [0.4], [0.3]), cosines(2.0, [0.4], [0.3]), 0.15, contact=rule, name="link",
        )  # fmt: skip
        return System(values["omega"], matrix, forcing, (stop, link))

    parameters = tuple(
        Parameter(name, default)
        for name, default in {"omega": 0.9, "force": 1.0, "load": 0.2, "stop": 0.6, "gap": 0.3}.items()
    )
    return Family(parameters, ("x", "x'", "y", "y'"), build, lambda values: np.zeros(4))


@cache
def one_dof_under(rule: ContactRule, **defaults: float) -> Family:
    """The mild pair of `members.one_dof` under a contact rule."""
    mild = {"omega": 0.7, "D": 1.0, "load": 0.1, "error": 0.1, "mesh_damping": 0.05}
    return spur.family({**mild, **defaults}, rule)
