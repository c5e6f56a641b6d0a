"""How kernels are compiled: keywords of `numba.njit`.

Those that its public pages do not list stand here and nowhere else; `tests/kernel/test_options.py` looks at
the machine code for what each of them is for, and fails where a numba no longer does it.

Without fastmath. Not even contraction to fused multiply-add is left to the compiler: it keeps a vector and a
scalar version of many loops, chooses by the addresses of arrays, and contracts the two differently, so that
the last bit would depend on where memory happened to lie. Fused operations are written out (`fma`), and every
version of a loop then gives the same bytes."""

from __future__ import annotations

from typing import Any

ARITHMETIC: dict[str, Any] = {"error_model": "numpy"}
"""Division by zero gives an infinity."""

COUNTED: dict[str, Any] = {"_nrt": True}
"""Arrays are made, and freed with their last reference."""

NOT_COUNTED: dict[str, Any] = {"_nrt": False}
"""No reference counts: they cost more than the arithmetic of a small product. No array can be made."""

NEVER_CALLED: dict[str, Any] = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
"""From Python: nothing is compiled for that."""

ENTRY: dict[str, Any] = {**ARITHMETIC, "nogil": True, "no_cfunc_wrapper": True}
HELPER: dict[str, Any] = {**ARITHMETIC, **NEVER_CALLED, "forceinline": False}
"""What is not said is taken over from the caller that is compiled: so everything is said."""

INLINED: dict[str, Any] = {**HELPER, "forceinline": True}
