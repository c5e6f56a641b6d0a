"""Places in the work space of a march: one flat array, written before it is read."""

from __future__ import annotations

from ._tables import TERMS

DEPTH = 44  # subdivisions: an interval of 2^-44 of a piece is below the rounding of its ends

SCALED = 0  # a polynomial with its variable scaled
LOCAL = TERMS  # a polynomial in the local time of its piece, with a block of zeros behind it
SURFACE = 3 * TERMS  # distance to a surface
PUSH = 4 * TERMS  # force that sets in or ceases
MOMENTS = 5 * TERMS
OTHER = 6 * TERMS
ONES = 7 * TERMS
POWERS = 8 * TERMS
BUFFER = 9 * TERMS  # (2, TERMS)
STACK = 11 * TERMS  # (DEPTH+2, TERMS): Bernstein coefficients of subintervals
LIMITS = STACK + (DEPTH + 2) * TERMS  # (DEPTH+2, 2): their ends
GAPS = LIMITS + 4 * TERMS  # (clearances, TERMS): X over the cell; behind them (p) one more change
