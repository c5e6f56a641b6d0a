"""Kernels compiled in this process beside those from the cache."""

from __future__ import annotations

from typing import cast

import numpy as np
import pytest

from gearlash._kernel import Kernel
from gearlash._kernel.compiling import compile_kernel
from gearlash._kernel.machine import callable_at
from gearlash.flow._cells import spectral_radius


def test_the_same_bytes_wherever_a_kernel_was_compiled():
    kernel = cast(Kernel, spectral_radius)
    code, address = compile_kernel(kernel)
    assert code.entry == kernel.name
    here = callable_at(address, "here", kernel.signature)
    random = np.random.default_rng(5)
    for n in (1, 2, 7, 8, 9, 23):
        matrix = random.normal(size=(n, n))
        found = here(matrix, 8)
        assert found == kernel(matrix, 8)
        assert found == pytest.approx(max(abs(np.linalg.eigvals(matrix))), rel=0.1)


def test_machine_code_needs_nothing_of_numba():
    code, _ = compile_kernel(cast(Kernel, spectral_radius))  # it allocates
    assert "malloc" in code.needs
    assert not [name for name in code.needs if "numba" in name.lower() or name.startswith("NRT_")]
