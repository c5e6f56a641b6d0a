"""Which input the margin depends on: Sobol indices, from independent sets of samples.

Estimators of A. Saltelli et al., Comput. Phys. Commun. 181 (2010) 259, doi:10.1016/j.cpc.2009.09.018, by
`scipy.stats.sobol_indices`; errors from the spread of the sets.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.stats import sobol_indices

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
    indices = []
    for each in found:
        if not np.isfinite(each).all() or not np.ptp(each[:2]) > 0.0:
            return ()
        result = sobol_indices(
            func={"f_A": each[None, 0], "f_B": each[None, 1], "f_AB": each[2:, None]}, n=each.shape[1]
        )
        indices.append([np.ravel(result.first_order), np.ravel(result.total_order)])
    means, errors = mean_and_error(np.array(indices))
    rows = [
        Influence(one.path, *(float(x) for x in (means[0, i], errors[0, i], means[1, i], errors[1, i])))
        for i, one in enumerate(inputs)
    ]
    return tuple(sorted(rows, key=lambda row: -row.total))


def mean_and_error(sets: Points) -> tuple[Points, Points]:
    """Over the first axis: the mean, and the standard error of the mean of independent sets."""
    return sets.mean(axis=0), sets.std(axis=0, ddof=1) / np.sqrt(len(sets))
