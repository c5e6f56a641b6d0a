"""Which cases the article's study takes."""

from __future__ import annotations

from collections.abc import Callable
from importlib.resources import files

import pytest

from gearlash.article import reproduce
from gearlash.article.pair import check_pair, is_bundled
from gearlash.case import Case, CaseError, bundled, load, loads

TEXT = (files("gearlash.case") / "data" / "article.toml").read_text(encoding="utf-8")


def test_the_pair_and_its_variations_are_taken():
    for case in (
        load("article"),
        load("article-first-harmonic"),
        load("article", {"omega": 0.9, "D": 0.7, "projection": "base", "model.contact": "no-tension"}),
        load("article", {"mesh.damping_ratio": 0.05, "pinion.mass": "6.1 kg", "helix_angle": "17 deg"}),
        loads(TEXT.replace("value = 0.0378", "value = 0.02").replace('name = "article"', 'name = "mine"')),
        loads(TEXT.replace('"20 deg"', '"0.3490658503988659 rad"')),
        Case.from_json(load("article", {"load": 0.2}).to_json()),
    ):
        check_pair(case)


def test_every_other_bundled_case_is_refused():
    others = [name for name in bundled() if not name.startswith("article")]
    assert len(others) >= 5
    for name in others:
        with pytest.raises(CaseError, match="gearlash run, sweep, zones, graze or map"):
            check_pair(load(name))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda t: t.replace("teeth = 28", "teeth = 25"), "pinion.teeth is 25, in Table 1 28"),
        (lambda t: t.replace('"18 deg"', '"15 deg"'), "mesh.helix_angle is 15 deg, in Table 1 18 deg"),
        (lambda t: t.replace('"8.0e8 N/m"', '"7.0e8 N/m"'), "pinion.bearing_stiffness_y is 7.0e8 N/m"),
        (lambda t: t.replace("damping_ratio = 0.07", "damping_ratio = 0.05"), "mesh.damping_ratio is 0.05"),
    ],
)
def test_a_copy_with_another_table_1_is_refused(change: Callable[[str], str], said: str):
    changed = change(TEXT)
    assert changed != TEXT
    with pytest.raises(CaseError, match=said.replace(".", r"\.")):
        reproduce(loads(changed), workers=0)


def test_many_differences_are_counted():
    changed = TEXT.replace("teeth = 28", "teeth = 25").replace("teeth = 70", "teeth = 57")
    changed = (
        changed.replace('"4 mm"', '"3 mm"').replace('"18 deg"', '"15 deg"').replace('"20 deg"', '"25 deg"')
    )
    with pytest.raises(CaseError, match="and 2 more values"):
        check_pair(loads(changed))


def test_values_fitted_to_claims_are_those_of_the_bundled_case_only():
    assert is_bundled(load("article", {"pinion_speed": "3600 rpm", "D": 0.4}))
    assert not is_bundled(load("article", {"bearing_damping": 0.0377}))
    assert not is_bundled(load("article-first-harmonic"))
    assert not is_bundled(load("article", {"projection": "base"}))
