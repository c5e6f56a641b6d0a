"""Sizes of the blocks in which kernels compute."""

LANES = 8  # numbers of a vector
MASKED = 24  # values of which one mask or extreme is made: the coefficients of a polynomial
ROWS = 4  # of eight motions side by side: products come in whole blocks of so many rows


def padded(n: int) -> int:
    """n rounded up to whole blocks."""
    return -(-n // LANES) * LANES
