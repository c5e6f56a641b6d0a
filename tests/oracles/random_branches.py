"""Branches of pairs with one degree of freedom that are drawn at random: several harmonics of stiffness and
error, any damping, load on either side, one stop or two, every contact rule, any parameter."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearlash import flow
from gearlash.branches.continuation import Branch, ContinuationSettings, continue_orbit
from gearlash.gears import spur
from gearlash.orbits import Orbit, attractor
from gearlash.system import ContactRule, Family

LONGEST = 8  # base periods of the first orbit
NAMES = "omega", "omega", "D", "load", "error"


@dataclass(frozen=True)
class Drawn:
    """A family, and the interval of one of its parameters around its own value."""

    family: Family
    name: str
    lower: float
    upper: float
    rule: ContactRule


def draw(seed: int) -> Drawn:
    rng = np.random.default_rng([0, seed])
    values = {
        "omega": rng.uniform(0.3, 2.2),
        "D": 10 ** rng.uniform(-1.3, 0.3),
        "load": rng.choice([-1, 1], p=[0.25, 0.75]) * 10 ** rng.uniform(-2, -0.3),
        "mesh_damping": 10 ** rng.uniform(np.log10(0.0025), np.log10(0.3)),
        "error": 10 ** rng.uniform(-2.0, 0),
        "error_phase": rng.uniform(0, 6.28),
        "ripple": rng.choice([0, rng.uniform(0, 0.5)]),
        "ripple_phase": rng.uniform(0, 6.28),
    }
    for order in (2, 3):
        for stem, size in (("error", 0.3 * values["error"]), ("ripple", 0.3)):
            if rng.uniform() < 0.4:
                values[f"{stem}_{order}"] = rng.uniform(0, size)
                values[f"{stem}_phase_{order}"] = rng.uniform(0, 6.28)
    side = rng.uniform()
    if side < 0.15 and values["load"] > 0:
        values["back_stiffness"] = 0.0
    elif side < 0.3:
        values["back_stiffness"], values["back_gap"] = rng.uniform(0.2, 3), rng.uniform(0.3, 3)
    rule = list(ContactRule)[int(rng.integers(3))]
    plain = {name: float(value) for name, value in values.items()}
    name, width = str(rng.choice(NAMES)), rng.uniform(0.15, 0.6)
    lower, upper = sorted((plain[name] * (1 - width), plain[name] * (1 + width)))
    return Drawn(spur.family(plain, rule), name, float(lower), float(upper), rule)


def followed(drawn: Drawn) -> Branch | None:
    """The branch through the motion from the cold start; None where that is not a short orbit."""
    family = drawn.family
    values = family.complete({})
    found = attractor(flow.propagators(family.system(values)), family.start(values))
    if not isinstance(found, Orbit) or found.shot.period > LONGEST:
        return None
    steps = ContinuationSettings(certify=False)
    return continue_orbit(family, values, drawn.name, found, drawn.lower, drawn.upper, steps)
