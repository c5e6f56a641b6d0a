"""What the contact kernel reads: plain arrays, and the places in them.

A place of contact is a slice of the face on a pair of teeth. Pairs are counted from the one on the pinion
tooth on the line of centres, back by one at every mesh cycle: so within a cycle the places stay where they
are in the tables, and one cycle ends as the next one begins."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearlash._kernel.jit import array_of, float64, int64, record_of

Reals = NDArray[np.float64]
Integers = NDArray[np.int64]

CORNER_REACH = 80e-6
"""Up to this normal approach, m, tip corners are followed where no other one is given."""

# scalars
BASE_1, BASE_2, CENTRES, ANGLE, TWIST, OBLIQUE, PITCH, ORIGIN_1, ORIGIN_2, REST = range(10)
TIP_1, TIP_2, FAR_1, FAR_2, CORNER_1, CORNER_2, CURVED_1, CURVED_2, PATH_START, PATH_END = range(10, 20)
LENGTH, HERTZ, HERTZ_DEPTH, LEAST_LOAD, MOST_LOAD, DAMPING_TIME, RELIEF_START, RELIEF_STEP = range(20, 28)
TANGENT, LOG_LEAST, REACH = range(28, 31)
SCALARS = 31

# counts
TEETH, PAIRS, FIRST_PAIR, PHASES, MODES = range(5)
COUNTS = 5


class ContactTables(NamedTuple):
    """Of one pair: what `contact_forces` reads.

    Parameters
    ----------
    scalars : ndarray, shape (SCALARS,)
    counts : ndarray of int, shape (COUNTS,)
    slices : ndarray, shape (S,)
        z of the middles of the slices, m.
    compliance : ndarray, shape (P S, P S, N + 3)
        Of both gears together, m/N, normal to the flanks: at a place for a force at a place, over the mesh
        phase from −1/N to 1 + 1/N; place = pair S + slice. The flattening of the contact itself is not in it.
    error : ndarray, shape (2, H, 2)
        Of both sides, amplitudes of cos and sin of nθ, m.
    relief : ndarray, shape (2, S, R)
        Of both sides over the roll length of the pinion, m.
    mode_order, mode_body : ndarray of int, shape (M,)
        Waves around the circumference; 0 pinion, 1 gear.
    mode_shape : ndarray, shape (2, M, S, 2)
        Outward displacement normal to the flank of each side, of cos nψ and sin nψ.
    """

    scalars: Reals
    counts: Integers
    slices: Reals
    compliance: Reals
    error: Reals
    relief: Reals
    mode_order: Integers
    mode_body: Integers
    mode_shape: Reals


READ_1 = array_of(float64, 1, writable=False)
ONE, THREE, WHOLE = array_of(float64, 1), array_of(float64, 3), array_of(int64, 1)
TABLES = record_of(ContactTables, ONE, WHOLE, ONE, THREE, THREE, THREE, WHOLE, WHOLE, array_of(float64, 4))
