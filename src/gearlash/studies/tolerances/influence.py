"""Which input the margin depends on: Sobol indices, from independent sets of samples.

Estimators of M. J. W. Jansen, Comput. Phys. Commun. 117 (1999) 35, doi:10.1016/S0010-4655(98)00154-4, of
several sets together, with errors from leaving each of them out (jackknife). Those of
`scipy.stats.sobol_indices` divide by the variance of the samples, which is far off where these are few.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gearlash.results.tolerance import Influence, ToleranceInput

Points = NDArray[np.float64]


def combinations(both: Points) -> Points:
    """Of two sets of points (2, n, d): both, and A with each of its columns from B: (2 + d, n, d)."""
    one, other = both
    mixed = np.repeat(one[None], one.shape[1], axis=0)
    for i in range(one.shape[1]):
        mixed[i, :, i] = other[:, i]
    return np.concatenate([both, mixed])


def influences(inputs: Sequence[ToleranceInput], found: Sequence[Points]) -> tuple[Influence, ...]:
    """From margins (2 + d, n) of each set; none where they do not vary or one was not solved for."""
    values = np.array(found)
    if not np.isfinite(values).all() or not np.ptp(values[:, :2]) > 0.0:
        return ()
    whole = indices(values)
    left_out = np.array([indices(np.delete(values, at, axis=0)) for at in range(len(values))])
    spread = np.sqrt((len(values) - 1) * left_out.var(axis=0))
    total = np.clip(whole[1], 0.0, 1.0)  # few samples may tell more, or less than nothing
    first = np.clip(whole[0], 0.0, total)
    rows = [
        Influence(one.path, *(float(x) for x in (first[i], spread[0, i], total[i], spread[1, i])))
        for i, one in enumerate(inputs)
    ]
    return tuple(sorted(rows, key=lambda row: -row.total))


def indices(values: Points) -> Points:
    """First and total indices (2, d) of all sets together, values (sets, 2 + d, n). The variance comes from
    the same differences as they do: where one input makes all of it, its indices are 1 with any samples."""
    one, other, mixed = values[:, 0], values[:, 1], values[:, 2:]
    variance = np.square(one - other).mean()
    first = 1.0 - np.square(other[:, None] - mixed).mean(axis=(0, 2)) / variance
    total = np.square(one[:, None] - mixed).mean(axis=(0, 2)) / variance
    return np.array([first, total])


def share_and_error(held: Points) -> tuple[Points, Points]:
    """Share of samples (sets, samples, ...) that are 1, and its standard error. A set tells a share no closer
    than to one of its samples, so that sets which agree do not make it exact."""
    sets, count = held.shape[:2]
    share, error = mean_and_error(held.mean(axis=1))
    least = np.where((share > 0.0) & (share < 1.0), 1.0 / (count * np.sqrt(12.0 * sets)), 0.0)
    return share, np.maximum(error, least)


def mean_and_error(sets: Points) -> tuple[Points, Points]:
    """Over the first axis: the mean, and the standard error of the mean of independent sets."""
    return sets.mean(axis=0), sets.std(axis=0, ddof=1) / np.sqrt(len(sets))
