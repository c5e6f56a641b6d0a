"""Shafts and housings in series with the bearings."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gearlash.case import CaseError, loads

TEXT = (Path(__file__).parents[1] / "cases" / "drawing.toml").read_text(encoding="utf-8")
STATED = TEXT.replace("[gear]", 'bearing_stiffness_y = "3e8 N/m"\nshaft_stiffness_y = "6e8 N/m"\n[gear]')


def test_shaft_and_housing_in_series_are_one_softer_bearing():
    both = loads(STATED, {"pinion.housing_stiffness_y": "2e8 N/m"})
    one = loads(
        STATED.replace('shaft_stiffness_y = "6e8 N/m"\n', ""), {"pinion.bearing_stiffness_y": "1e8 N/m"}
    )
    (family, _), (plain, _) = both.family(), one.family()
    np.testing.assert_allclose(family.system().matrix, plain.system().matrix, rtol=1e-12, atol=1e-14)
    found = {v.path: v for v in both.values()}
    whole = found["derived.support_stiffness_pinion_y"]
    assert whole.value == pytest.approx(1e8, rel=1e-12)
    assert whole.provenance == "derived"
    assert "1/k_bearing" in whole.reason
    assert "derived.support_stiffness_gear_y" not in found


def test_an_estimated_bearing_takes_them_too_and_they_vary():
    case = loads(STATED.replace('bearing_stiffness_y = "3e8 N/m"\n', ""))
    found = {v.path: v for v in case.values()}
    bearing = found["pinion.bearing_stiffness_y"]
    whole = found["derived.support_stiffness_pinion_y"]
    assert 1.0 / float(whole.value) == pytest.approx(1.0 / float(bearing.value) + 1.0 / 6e8)
    assert whole.rests_on == ("pinion.bearing_stiffness_y",)
    family, _ = case.varying("pinion.shaft_stiffness_y").family()
    other, _ = case.with_overrides({"pinion.shaft_stiffness_y": "1e8 N/m"}).family()
    np.testing.assert_allclose(
        family.system({"pinion.shaft_stiffness_y": 1e8}).matrix, other.system().matrix, rtol=1e-9, atol=1e-12
    )


@pytest.mark.parametrize("word", ["shaft_stiffness_y", "housing_stiffness_z", "bearing_stiffness_y"])
def test_a_pair_without_bearings_says_so(word):
    text = TEXT.replace('"helical-pair"', '"spur-1dof"').replace('helix_angle = "15 deg"\n', "")
    with pytest.raises(CaseError, match=f"{word} = '1e8 N/m': expected nothing here.*has no bearings"):
        loads(text.replace("[gear]", f'{word} = "1e8 N/m"\n[gear]'))
    with pytest.raises(CaseError, match="has no bearings"):
        loads(text, {f"pinion.{word}": "1e8 N/m"})


def test_a_stated_frequency_has_all_in_series_in_it():
    text = (
        STATED.replace('bearing_stiffness_y = "3e8 N/m"\n', "")
        + "\n[dimensionless]\nbearing_frequency_yp = 0.5\n"
    )
    with pytest.raises(CaseError, match="bearing_frequency_yp is that of all in series"):
        loads(text)
