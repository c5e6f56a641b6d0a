"""The intrinsic behind `fma`. Imported for compiling only."""

from __future__ import annotations

from typing import TYPE_CHECKING

if not TYPE_CHECKING:
    from numba import float64
    from numba.extending import intrinsic

    @intrinsic
    def fma(typing, a, b, c):
        """a·b + c, rounded once."""

        def generate(context, builder, signature, arguments):
            return builder.fma(*arguments)

        return float64(float64, float64, float64), generate
