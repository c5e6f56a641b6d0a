"""Oracles that are compiled once a session."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from oracles.pairs import KINDS, random_system


@pytest.fixture(scope="session")
def oracle():
    """``oracle(pair, variational=False)`` is heyoka for every random member of that pair, or a skip."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles.heyoka_oracle import Oracle

    @cache
    def compiled(pair: str, variational: bool = False) -> Oracle:
        rng = np.random.default_rng(0)
        return Oracle([random_system(rng, pair, kind)[0] for kind in KINDS], variational=variational)

    return compiled
