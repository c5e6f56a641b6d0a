"""The contact rules compared: the ends of the window against dense samples of the linear motion."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash import flow
from gearlash.article.reproduction import RuleEffect
from gearlash.article.rules import effects
from gearlash.case import load
from gearlash.flow.events import contact_force
from gearlash.jobs import Inline
from gearlash.orbits import shoot

AT = {"omega": 0.78, "D": 1.0}


@pytest.fixture(scope="module")
def found() -> dict[str, RuleEffect]:
    return {e.rule: e for e in effects(load("article-first-harmonic"), (0.44, 0.45, 1.0), AT, Inline())}


def linear_minimum(omega: float, force: bool) -> float:
    """Least X - D, or least Φ, of the motion in permanent contact under the case's own rule, by sampling."""
    family, _ = load("article-first-harmonic").family()
    props = flow.propagators(family.system({"omega": omega, "D": 1.0}))
    quiet = shoot(flow.propagators(family.system({"omega": 1.047})), family.start({}), 1)
    shot = shoot(props, quiet.state, 1)
    samples = flow.trace(props, shot.state, 1.0).samples(100_001)
    if not force:
        return float(samples.displacement.min() - 1.0)
    closed = np.zeros(len(samples.phase), dtype=int)
    return float(
        contact_force(props.system, samples.phase, samples.displacement, samples.velocity, closed).min()
    )


def test_the_rule_of_the_case_comes_first(found):
    assert next(iter(found)) == "always"
    assert [e.stated for e in found.values()] == [True, False, False]
    assert set(found) == {"always", "in-contact", "no-tension"}


@pytest.mark.parametrize("rule", ["always", "in-contact", "no-tension"])
def test_the_linear_motion_touches_at_both_ends(found, rule):
    effect = found[rule]
    for end in (effect.lower, effect.upper):
        assert end is not None
        assert end.surface == ("force" if rule == "no-tension" else "gap")
        assert abs(linear_minimum(end.value, force=rule == "no-tension")) <= 1e-8
        assert {end.label_below, end.label_above} == {"1-0-0", "1-1-0"}


def test_damping_in_the_gap_moves_no_end_and_no_tension_narrows_the_window(found):
    always, contact, pulling = (found[rule] for rule in ("always", "in-contact", "no-tension"))
    assert contact.lower.value == pytest.approx(always.lower.value, rel=1e-12)
    assert contact.upper.value == pytest.approx(always.upper.value, rel=1e-12)
    assert always.lower.value < pulling.lower.value < pulling.upper.value < always.upper.value


def test_labels_and_back_side(found):
    for effect in found.values():
        assert [p.value for p in effect.speeds] == [0.942, 1.047]
        assert [p.value for p in effect.backlash] == [0.44, 0.45, 1.0]
    always = found["always"]
    assert [p.label for p in always.speeds] == ["1-1-0", "1-0-0"]
    assert [p.label for p in always.backlash] == ["6-6-1", "6-6-0", "6-6-0"]
    assert [p.back_hit for p in always.backlash] == [True, False, False]
    (start,) = always.back_side
    assert (start.label_below, start.label_above) == ("6-6-1", "6-6-0")
    assert 0.44 < start.value < 0.45


def test_a_case_without_that_choice_is_left_out():
    class Bare:
        def values(self):
            return ()

    assert effects(Bare(), (1.0,), AT, Inline()) == ()  # pyright: ignore[reportArgumentType]
