"""No computation reads what the article claims: with every claimed value off, nothing computed moves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearlash.article import Claim, Reproduction, Scope, load, reproduce
from gearlash.case import load as load_case
from gearlash.results import content_hash

SCOPE = Scope(omega=(0.96, 1.12, 5), backlash=(0.446, 0.47, 2), rules_backlash=(0.44, 0.5))


def perturbed(claim: Claim, index: int) -> Claim:
    """Every number that the article printed as a result, off by about 1 % in either direction."""
    factor = 1.0 + 0.01 * (-1) ** index
    changes = {}
    if claim.value is not None:
        changes["value"] = claim.value * factor
    if claim.interval is not None:
        low, high = claim.interval
        changes["interval"] = (low * factor, high / factor)
    return replace(claim, **changes)


@pytest.fixture(scope="module")
def both() -> tuple[Reproduction, Reproduction, tuple[Claim, ...]]:
    case = load_case("article-first-harmonic")
    others = tuple(perturbed(claim, i) for i, claim in enumerate(load()))
    return (
        reproduce(case, SCOPE, workers=1),
        reproduce(case, SCOPE, workers=1, claims=others),
        others,
    )


def test_something_is_found_at_all(both):
    """So that what follows is not empty."""
    one, _, _ = both
    assert sum(event.found for event in one.events) >= 2
    assert {row.id for row in one.claims if row.verdict == "reproduced"} >= {"window-upper", "window-lower"}
    assert sum(reading.found for zone in one.zones for reading in zone.readings) >= 10


def test_the_claims_were_really_perturbed(both):
    one, other, others = both
    moved = [c for c, d in zip(load(), others, strict=True) if c != d]
    assert len(moved) == sum(c.value is not None or c.interval is not None for c in load()) >= 7
    deviations = [(a.deviation, b.deviation) for a, b in zip(one.claims, other.claims, strict=True)]
    assert any(np.isfinite(a) and abs(a - b) > 0.005 for a, b in deviations)


def test_sweeps_are_the_same_bytes(both):
    one, other, _ = both
    for a, b in ((one.frequency, other.frequency), (one.backlash, other.backlash)):
        assert content_hash(a.dataset) == content_hash(b.dataset)
        assert [replace(m, article=False) for m in a.marks] == [replace(m, article=False) for m in b.marks]


def test_computed_columns_of_the_claims_do_not_move(both):
    one, other, _ = both
    for a, b in zip(one.claims, other.claims, strict=True):
        assert a.id == b.id
        if a.id.endswith("-zone"):
            continue  # which reading is compared follows the claim; the readings are compared below
        assert a.computed == b.computed
        assert np.array_equal(a.computed_value, b.computed_value, equal_nan=True)
        assert a.computed_labels == b.computed_labels
        assert a.branch == b.branch


def test_computed_events_do_not_move(both):
    names = ("found", "value", "a0", "phase", "type", "kind", "exponent", "residual", "leading_below")
    names += ("leading_above", "distance_to_fold", "distance_to_doubling", "conditions", "branch", "method")
    one, other, _ = both
    for a, b in zip(one.events, other.events, strict=True):
        assert a.found == b.found
        if a.found:
            assert {n: getattr(a, n) for n in names} == {n: getattr(b, n) for n in names}
            assert (a.label_below, a.label_above) == (b.label_below, b.label_above)
            for m, n in zip(a.motions, b.motions, strict=True):
                assert (m.displacement == n.displacement).all()


def test_zones_and_table_2_do_not_move(both):
    one, other, _ = both
    pairs = [
        pair
        for a, b in zip(one.zones, other.zones, strict=True)
        for pair in zip(a.readings, b.readings, strict=True)
    ]
    for a, b in pairs:
        assert a.name == b.name
        assert repr((a.lower, a.upper)) == repr((b.lower, b.upper))  # NaN where there is none
        assert (a.labels, a.coexisting) == (b.labels, b.coexisting)
        assert np.array_equal(a.margin, b.margin, equal_nan=True)
    assert one.table2 == other.table2
    for m, n in zip(one.window, other.window, strict=True):
        assert (m.displacement == n.displacement).all()


def test_verdicts_follow_the_perturbed_values(both):
    """Deviation and verdict do move: 1 % is no longer within 0.5 %."""
    one, other, _ = both
    rows = {row.id: row for row in one.claims}, {row.id: row for row in other.claims}
    for name in ("window-upper", "window-lower"):
        assert rows[0][name].verdict == "reproduced"
        assert rows[1][name].verdict == "shifted"


def test_bounds_measured_on_the_run_hold(both):
    assert all(check.holds in (True, None) for check in both[0].checks)
    assert both[0].run.complete
