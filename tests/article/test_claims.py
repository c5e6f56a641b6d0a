"""The article's claims as data, and the rules of the verdicts."""

from __future__ import annotations

import re
from dataclasses import fields

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.article import NOT_FOUND, REPRODUCED, SHIFTED, Claim, load
from gearlash.article.claims import CLAIM_KINDS, _claim
from gearlash.article.judge import CLOSE, FAR, coincides, deviation, same_label, verdict, worst
from gearlash.case import load as load_case
from gearlash.orbits import Signature
from gearlash.system import GearlashError, read_label

CLAIMS = load()
NAMES = set(load_case("article").family()[0].defaults)


def by_id(name: str) -> Claim:
    return next(claim for claim in CLAIMS if claim.id == name)


def test_ids_are_unique_and_ordered_as_loaded():
    ids = [claim.id for claim in CLAIMS]
    assert len(set(ids)) == len(ids) >= 15


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.id)
def test_every_claim_is_whole(claim):
    assert claim.kind in CLAIM_KINDS
    assert len(claim.sentence) > 40
    assert claim.title
    assert claim.quantity
    assert claim.printed
    assert set(claim.fixed) <= NAMES
    if claim.parameter:
        assert claim.parameter in NAMES
        assert claim.parameter not in claim.fixed
    for label in (claim.below, claim.above, claim.label):
        assert not label or Signature.parse(label).period >= 1


@pytest.mark.parametrize("claim", [c for c in CLAIMS if c.value is not None], ids=lambda claim: claim.id)
def test_values_are_the_printed_digits(claim):
    assert float(claim.printed) == claim.value
    assert claim.printed.rstrip("0") in claim.sentence or claim.printed in claim.sentence


@pytest.mark.parametrize(
    "claim", [c for c in CLAIMS if c.kind in ("grazing", "codimension-2")], ids=lambda c: c.id
)
def test_boundaries_have_two_labels(claim):
    """A standard grazing keeps P and changes one count by one; the coincidence halves P."""
    below, above = Signature.parse(claim.below), Signature.parse(claim.above)
    assert claim.boundary in (1, -1)
    assert claim.portrait
    if claim.kind == "grazing":
        assert below.period == above.period
        changed = (abs(below.drive - above.drive), abs(below.back - above.back))
        assert changed == ((1, 0) if claim.boundary > 0 else (0, 1))
    else:
        assert below.period == 2 * above.period


@pytest.mark.parametrize("claim", [c for c in CLAIMS if c.kind == "zone"], ids=lambda c: c.id)
def test_zones_have_an_interval(claim):
    assert claim.interval is not None
    low, high = claim.interval
    assert low < high
    assert claim.zone in ("impact-free", "drive side only")
    assert [float(x) for x in re.findall(r"\d+\.\d+", claim.printed)] == [low, high]


@pytest.mark.parametrize("claim", [c for c in CLAIMS if c.kind == "exponent"], ids=lambda c: c.id)
def test_exponents_belong_to_an_event(claim):
    assert by_id(claim.of).kind in ("grazing", "codimension-2")
    assert claim.sign in (-1, 0)


def test_what_the_article_says_is_there():
    """The places named in its text, with the labels on both sides."""
    events = {(c.printed, c.below, c.above) for c in CLAIMS if c.portrait}
    assert events == {
        ("1.112", "1-0", "1-1"),
        ("0.972", "1-1", "1-0"),
        ("0.830", "3-3", "3-2"),
        ("0.3523", "12-12-3", "6-6-1"),
        ("0.3855", "6-6-1", "6-6-2"),
    }
    assert by_id("frequency-zone").interval == (0.973, 1.112)
    assert by_id("backlash-zone").interval == (0.459, 1.0)
    assert (by_id("motion-0.942").at, by_id("motion-0.942").label) == (0.942, "1-1")
    assert (by_id("motion-1.047").at, by_id("motion-1.047").label) == (1.047, "1-0")


def test_a_claim_of_another_kind_is_refused():
    table = {f.name: "x" for f in fields(Claim)} | {"kind": "hearsay"}
    with pytest.raises(GearlashError, match="hearsay"):
        _claim(table)


def test_thresholds():
    assert (CLOSE, FAR) == (0.005, 0.10)


@pytest.mark.parametrize(
    ("deviations", "equal", "expected"),
    [
        ([0.0], True, REPRODUCED),
        ([0.005], True, REPRODUCED),
        ([-0.005], True, REPRODUCED),
        ([0.0050001], True, SHIFTED),
        ([-0.09], True, SHIFTED),
        ([0.1], True, SHIFTED),
        ([0.1000001], True, NOT_FOUND),
        ([0.0, 0.06], True, SHIFTED),
        ([0.001, -0.2], True, NOT_FOUND),
        ([0.0], False, NOT_FOUND),
        ([], True, NOT_FOUND),
        ([float("nan")], True, NOT_FOUND),
        ([0.0, float("inf")], True, NOT_FOUND),
    ],
)
def test_verdicts(deviations, equal, expected):
    assert verdict(deviations, labels_equal=equal) == expected


@given(st.lists(st.floats(-0.3, 0.3), min_size=1, max_size=3), st.booleans())
def test_verdicts_by_their_definition(deviations, equal):
    worst = max(abs(d) for d in deviations)
    found = verdict(deviations, labels_equal=equal)
    assert (found == REPRODUCED) == (equal and worst <= 0.005)
    assert (found == SHIFTED) == (equal and 0.005 < worst <= 0.10)
    assert found == verdict([-d for d in reversed(deviations)], labels_equal=equal)


@given(st.floats(0.1, 10.0), st.floats(-0.2, 0.2))
def test_deviation_is_relative_to_the_reported_value(reported, part):
    assert deviation(reported * (1 + part), reported) == pytest.approx(part, abs=1e-12)


@pytest.mark.parametrize(
    ("computed", "reported", "same"),
    [
        ("1-1-0", "1-1", True),
        ("1-0-0", "1-0", True),
        ("6-6-1", "6-6-1", True),
        ("6-6-1", "6-6", False),
        ("2-2-0", "1-1", False),
        ("12-12-3", "12-12-2", False),
        ("aperiodic", "1-1", False),
        ("unresolved", "1-1", False),
        ("", "1-1", False),
        ("1-1-0", "", False),
    ],
)
def test_labels_are_compared_as_signatures(computed, reported, same):
    assert same_label(read_label(computed), reported) is same


@pytest.mark.parametrize(
    ("apart", "expected"),
    [(0.0, REPRODUCED), (9.6e-6, REPRODUCED), (1e-4, REPRODUCED), (1.01e-4, SHIFTED), (0.0353, NOT_FOUND)],
)
def test_two_places_coincide_to_the_printed_digits(apart, expected):
    assert coincides(apart, 0.3523, "0.3523") == expected
    assert coincides(float("nan"), 0.3523, "0.3523") == NOT_FOUND


def test_the_worst_of_several_verdicts_counts():
    assert worst([REPRODUCED, SHIFTED]) == SHIFTED
    assert worst([NOT_FOUND, REPRODUCED]) == NOT_FOUND
    assert worst([REPRODUCED]) == REPRODUCED
    assert worst([]) == NOT_FOUND
