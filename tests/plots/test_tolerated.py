"""The figure of tolerances."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.patches import StepPatch
from scipy.stats import beta

from gearlash import plots
from gearlash.results.tolerance import Profile
from plots.made import tolerated


def test_where_all_samples_agree_what_they_bound_is_grey():
    """Eight of eight do not make 100 %: the limit is that of Clopper and Pearson, one-sided at 95 %."""
    low, high = tolerated().axis.values[[0, -1]].tolist()
    edges = tuple(np.linspace(low, high, 4).tolist())
    found = replace(
        tolerated(), samples=2, replicates=4, profile=Profile(edges, (1.0, 0.5, 0.0), (0.0, 0.1, 0.0))
    )
    panel = plots.tolerance_bands(found).axes[0]
    grey = next(patch for patch in panel.patches if isinstance(patch, StepPatch) and patch.get_fill())
    bound = float(beta.ppf(0.05, 8, 1))
    upper, _, lower = grey.get_data()
    assert upper == pytest.approx([1.0, 0.7, 1.0 - bound])
    assert lower == pytest.approx([bound, 0.3, 0.0])


def test_of_stopped_work_only_whole_sets_that_were_done_bound():
    found = replace(tolerated(), complete=False, samples=16, replicates=4, corners=20, tried=20 + 1 + 40)
    assert found.drawn == 32
