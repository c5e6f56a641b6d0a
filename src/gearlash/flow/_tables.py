"""The arrays that kernels read, and their compiled types.

Regions are numbered 0 (contact on side +), 1 (free), 2 (contact on side -). A period of the system is divided
into N cells of equal phase; inside a cell local time s runs from 0 to 1."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]  # of float64, where nothing else is said

PLUS, FREE, MINUS = 0, 1, 2
ORDER = 18  # degree of every Taylor polynomial
CHECK = 7  # degree of the Bernstein polynomials that prove "no event in this cell"


class Tables(NamedTuple):
    """One system as the kernels see it: its equations, and its cell maps. All arrays are read-only."""

    scalars: Array  # (3): ω, cell duration in τ, cell width in θ
    matrix: (
        Array  # (3, n, p): M + damping: [region, column, row]; rows padded to p = whole blocks (`_blocks`)
    )
    gain: Array  # (p): g
    reads: NDArray[np.int64]  # (m): where h is not zero
    read: Array  # (m): h there
    edge: Array  # (3): Φ = η (X - edge): +D⁺, 0, -D⁻
    gaps: Array  # (2): D⁺, D⁻
    stiffness: Array  # (3, 2K+1): η per region
    forcing: Array  # (rows, 2H+1): forced rows of b(θ)
    rows: NDArray[np.int64]  # (rows): which states they force
    offset: Array  # (2E+1): e(θ)
    to_bernstein: Array  # (2, ORDER+1, ORDER+1): Taylor to Bernstein, of degree ORDER and ORDER-1
    maps: Array  # (3, N, n, p): cell propagators: [region, cell, column, row]
    shift: Array  # (3, N, p): their forced part
    check: Array  # (3, N, n+1, CHECK+1): Bernstein coefficients of X as functions of (z, 1)
    slack: Array  # (3, N, n+1): bound on what `check` leaves out, per |z_j| and constant
    bend: Array  # (3, N, n+1): bound on max|X''|/8 in the cell, per |z_j| and constant
    tail: Array  # (3, n+1): bound on the Taylor remainder of X, per |z_j| and constant


INTEGER = ("reads", "rows")

if TYPE_CHECKING:
    TABLES: Any
    FLOATS: Any
    MATRIX: Any
    INTS: Any
else:
    import numba
    from numba import types

    _DIMENSIONS = (1, 3, 1, 1, 1, 1, 1, 2, 2, 1, 1, 3, 4, 3, 4, 3, 3, 2)

    def _sample() -> Tables:
        """Empty tables: numba matches a NamedTuple reliably only by the type of an instance."""
        arrays = []
        for name, dimensions in zip(Tables._fields, _DIMENSIONS, strict=True):
            array = np.zeros((1,) * dimensions, dtype=np.int64 if name in INTEGER else np.float64)
            array.setflags(write=False)
            arrays.append(array)
        return Tables(*arrays)

    TABLES = numba.typeof(_sample())
    FLOATS = types.float64[::1]
    MATRIX = types.float64[:, ::1]
    INTS = types.int64[::1]
