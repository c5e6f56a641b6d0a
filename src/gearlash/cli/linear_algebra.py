"""numba imports scipy.linalg while it is set up, a sixth of a short command's time, for functions that no
kernel uses."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

ASKED = "scipy.linalg.cython_blas"
"""What numba asks for. Where scipy is not installed, which numba allows, it multiplies by loops of its own in
`numpy.convolve` and `numpy.correlate`, and asks anew where it compiles another product."""


@contextmanager
def not_importing_linear_algebra() -> Iterator[None]:
    """In this block numba is set up as where scipy is not installed. No other thread may want scipy.linalg
    meanwhile: it would not find it."""
    if ASKED in sys.modules:
        yield
        return
    sys.modules[ASKED] = None  # pyright: ignore[reportArgumentType]  (how Python marks what is not there)
    try:
        yield
    finally:
        del sys.modules[ASKED]
