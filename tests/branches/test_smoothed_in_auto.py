"""Special points beside those that AUTO-07p found on systems whose corners are rounded over a width.

`make oracles` keeps them in `oracles/auto/kept.json`; nothing is run here. A crossing at a speed sees a
rounded corner as the sharp one up to the square of its width; an orbit that touches with its width to the
power 3/2, which is the time it spends there times the height.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from branches.followed import PLAIN
from gearlash.branches.continuation import Branch, SpecialPoint, continue_orbit
from oracles.auto.cases import CASES, WIDTHS
from orbits.members import orbit

PRINTED = 1e-9  # AUTO prints eleven digits; a motion that meets no corner is the same to these
KEPT = json.loads((Path(__file__).parents[1] / "oracles" / "auto" / "kept.json").read_text())


@cache
def followed(name: str) -> Branch:
    asked = CASES[name]
    family, values = asked.family(), {**asked.values, "omega": asked.omega}
    start = orbit(family, **values)
    return continue_orbit(family, family.complete(values), "omega", start, asked.lower, asked.upper, PLAIN)


def theirs(name: str, special: SpecialPoint) -> np.ndarray:
    """AUTO's values for falling widths, of its point of this kind that is nearest at the smallest one."""
    by_width = [KEPT["cases"][name][repr(CASES[name].width / 2**k)] for k in range(WIDTHS)]
    found, last = [], special.value
    for points in reversed(by_width):
        mine = [value for kind, value in points if kind == special.kind.value]
        last = min(mine, key=lambda value: abs(value - last))
        found.append(last)
    return np.array(found[::-1])


@pytest.mark.parametrize("name", CASES)
def test_special_points_of_rounded_corners_go_to_ours_as_the_corners_become_sharp(name):
    """At the expected order; one step of extrapolation leaves a tenth of the difference."""
    branch = followed(name)
    assert branch.special
    for special in branch.special:
        values = theirs(name, special)
        away = np.abs(values - special.value)
        if special.linear and special.extremum is None:
            assert away.max() < PRINTED * special.value
            continue
        order = 1.5 if special.extremum is not None else 2.0
        assert np.log2(away[-2] / away[-1]) == pytest.approx(order, abs=0.1)
        limit = values[-1] + (values[-1] - values[-2]) / (2.0**order - 1.0)
        assert abs(limit - special.value) < 0.1 * away[-1]


def test_what_is_kept_is_what_is_asked():
    assert KEPT["program"].startswith("AUTO-07p 0.9")
    assert {name: len(widths) for name, widths in KEPT["cases"].items()} == dict.fromkeys(CASES, WIDTHS)
