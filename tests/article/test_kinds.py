"""The types of the article's Table 2."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from gearlash.article import table2_type
from gearlash.article.kinds import CODIMENSION_TWO, SMOOTH, STANDARD
from gearlash.branches import GrazingPoint, locate_grazing, locate_multiplier
from gearlash.orbits import grazing_checks
from orbits.members import article, one_dof, orbit


@cache
def touch() -> GrazingPoint:
    family, values = one_dof(), {"omega": 0.7, "load": 0.3}
    start = orbit(family, **values)
    return locate_grazing(family, "load", start, grazing_checks(start)[0], values=values)


@pytest.mark.parametrize(
    ("multipliers", "kind"),
    [
        ([0.5, 0.1], STANDARD),
        ([-0.9995, 0.1], CODIMENSION_TWO),
        ([0.9995, 0.1], CODIMENSION_TWO),
        ([0.6 + 0.8j, 0.6 - 0.8j], STANDARD),
    ],
)
def test_a_grazing_is_of_codimension_two_where_a_multiplier_is_critical(multipliers, kind):
    point = replace(touch(), multipliers=np.array(multipliers, dtype=complex))
    assert table2_type(point) == kind


def test_a_doubling_is_smooth():
    start = orbit(article(), omega=0.79)
    assert table2_type(locate_multiplier(article(), "omega", start, -1, values={"omega": 0.79})) == SMOOTH
