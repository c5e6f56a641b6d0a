"""The nearest valid name: what was meant, or nothing."""

import pytest

from gearlash.case.words import nearest_name
from gearlash.system.nearest import nearest

NAMES = ["pinion_speed", "mesh_frequency", "torque", "backlash", "error", "ripple", "normal_module", "omega"]


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("bakclash", "backlash"),
        ("Torque", "torque"),
        ("mesh-frequency", "mesh_frequency"),
        ("ripple_1", "ripple"),
        ("speed", "pinion_speed"),
        ("omgea", "omega"),
    ],
)
def test_a_misspelt_name_or_a_part_of_one_is_understood(typed, meant):
    assert nearest(typed, NAMES) == meant


@pytest.mark.parametrize(
    "typed", ["power", "colour", "include", "order", "", "x" * 1000, 7, None, ["torque"]]
)
def test_a_name_like_no_other_gets_none(typed):
    assert nearest(typed, NAMES) is None


def test_a_part_of_two_names_stands_for_neither():
    assert nearest("stiffness", ["bearing_stiffness_y", "back_stiffness_ratio"]) is None


@pytest.mark.parametrize(
    ("typed", "meant"),
    [("rpm", "pinion_speed"), ("module", "normal_module"), ("j_bn", "backlash"), ("moment", "torque")],
)
def test_words_of_drawings_are_understood_where_what_they_mean_exists(typed, meant):
    assert nearest_name(typed, NAMES) == meant
    assert nearest_name(typed, ["teeth"]) is None
