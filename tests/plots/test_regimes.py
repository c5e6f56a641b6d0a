"""Labels as kinds of motion."""

from __future__ import annotations

import pytest

from gearlash.plots.regimes import APERIODIC, BACK, DRIVE, FREE, UNRESOLVED, regime
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
        ("aperiodic", APERIODIC),
        ("unresolved", UNRESOLVED),
        ("", UNRESOLVED),
    ],
)
def test_impacts_of_all_gaps_count(label, kind):
    assert regime(read_label(label)) is kind
