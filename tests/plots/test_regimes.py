"""Labels as kinds of motion."""

from __future__ import annotations

import pytest

from gearlash.plots.fills import fills
from gearlash.plots.regimes import APERIODIC, BACK, BACK_ONLY, DRIVE, FREE, UNRESOLVED, regime
from gearlash.plots.strip import key
from gearlash.system import read_label


@pytest.mark.parametrize(
    ("label", "kind"),
    [
        ("1-0", FREE),
        ("2-0-0", FREE),
        ("1-1-0", DRIVE),
        ("6-6-1", BACK),
        ("1-0-0/0-0", FREE),
        ("1-0-0/1-0", DRIVE),
        ("2-2-0/1-3", BACK),
        ("1-0-1", BACK_ONLY),
        ("3-0-0/0-2", BACK_ONLY),
        ("1-0-1/1-0", BACK),
        ("aperiodic", APERIODIC),
        ("unresolved", UNRESOLVED),
        ("", UNRESOLVED),
    ],
)
def test_impacts_of_all_gaps_count(label, kind):
    assert regime(read_label(label)) is kind


def test_no_legend_tells_drive_side_impacts_of_motions_that_have_none():
    """Also not of those that share one look in a map, as they are many."""
    labels = [read_label(f"{p}-0-{p}") for p in range(1, 9)]
    assert [entry.get_label() for entry in key({regime(label) for label in labels})] == ["back-side impacts"]
    assert not any("drive" in fill.words for fill in fills(labels).values())
