"""The probability between the solved ends of the bands of all samples, where it does not change."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gearlash.results.tolerance import Band, Profile

from .influence import mean_and_error

MOST = 2_000  # pieces that are told; of more ends some are passed over
Numbers = NDArray[np.float64]


def profile(bands: Sequence[Sequence[Band]], count: int, lower: float, upper: float) -> Profile | None:
    """Of independent sets of ``count`` samples each, one after the other; None with fewer than two sets."""
    sets = len(bands) // count
    if sets < 2:
        return None
    whole = bands[: sets * count]
    ends = [end for some in whole for band in some for end in band]
    edges = np.unique(np.clip([lower, upper, *ends], lower, upper))
    if len(edges) > MOST + 1:
        edges = edges[np.linspace(0, len(edges) - 1, MOST + 1).round().astype(int)]
    middle = 0.5 * (edges[1:] + edges[:-1])
    shares = np.array([_share(whole[i : i + count], middle) for i in range(0, len(whole), count)])
    mean, error = mean_and_error(shares)
    return Profile(*(tuple(each.tolist()) for each in (edges, mean, error)))


def _share(bands: Sequence[Sequence[Band]], at: Numbers) -> Numbers:
    """Of a set of samples, at values in ascending order."""
    change = np.zeros(len(at) + 1)
    for some in bands:
        for low, high in some:
            change[np.searchsorted(at, low)] += 1.0
            change[np.searchsorted(at, high, side="right")] -= 1.0
    return np.cumsum(change[:-1]) / len(bands)
