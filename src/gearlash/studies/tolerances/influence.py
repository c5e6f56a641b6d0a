"""Which input the margin depends on: Sobol indices, from independent sets of samples.

Estimators of M. J. W. Jansen, Comput. Phys. Commun. 117 (1999) 35, doi:10.1016/S0010-4655(98)00154-4, of
several sets together, with errors from leaving each of them out (jackknife). Those of
`scipy.stats.sobol_indices` divide by the variance of the samples, which is far off where these are few.
Harmonics of one curve are one input here: nobody knows one of them without the others.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from gearlash.results.tolerance import Influence, ToleranceInput

Points = NDArray[np.float64]


def groups(inputs: Sequence[ToleranceInput]) -> Mapping[str, tuple[int, ...]]:
    """Which inputs (columns) share an influence, by the path that it is told under."""
    found: dict[str, tuple[int, ...]] = {}
    for i, one in enumerate(inputs):
        name = one.curve or one.path
        found[name] = (*found.get(name, ()), i)
    return found


def combinations(both: Points, columns: Collection[Sequence[int]]) -> Points:
    """Of two sets of points A, B (2, n, d): both, and A with each of g groups of columns from B:
    (2 + g, n, d)."""
    one, other = both
    mixed = [one.copy() for _ in columns]
    for points, group in zip(mixed, columns, strict=True):
        points[:, group] = other[:, group]
    return np.array([one, other, *mixed])


def why_none(found: Sequence[Points]) -> str:
    """What margins (2 + g, n) of each set have no indices for; empty where they have some."""
    values = np.array(found)
    count = int(np.isneginf(values).sum())
    if count:
        return f"{_samples(count, values.size)} that motion is unstable, and has no margin"
    count = int(np.isnan(values).sum())
    if count:
        return f"{_samples(count, values.size)} that motion was not solved for"
    return "" if np.ptp(values[:, :2]) > 0.0 else "the margin is the same in all samples"


def _samples(count: int, of: int) -> str:
    return f"in {count} of {of} samples"


def influences(names: Iterable[str], found: Sequence[Points]) -> tuple[Influence, ...]:
    """Of groups of inputs, from margins (2 + g, n) of each set that `why_none` has nothing against."""
    values = np.array(found)
    whole = indices(values)
    left_out = np.array([indices(np.delete(values, at, axis=0)) for at in range(len(values))])
    spread = np.sqrt((len(values) - 1) * left_out.var(axis=0))
    total = np.clip(whole[1], 0.0, 1.0)  # few samples may tell more, or less than nothing
    first = np.clip(whole[0], 0.0, total)
    rows = [
        Influence(name, *(float(x) for x in (first[i], spread[0, i], total[i], spread[1, i])))
        for i, name in enumerate(names)
    ]
    return tuple(sorted(rows, key=lambda row: -row.total))


def indices(values: Points) -> Points:
    """First and total indices (2, g) of all sets together, values (sets, 2 + g, n). The variance comes from
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
