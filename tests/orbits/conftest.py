"""The independent integrator, compiled once a session."""

from __future__ import annotations

import pytest

from gearlash.system import System


@pytest.fixture(scope="session")
def truth():
    """``truth(system)`` is heyoka for every system of this size with one harmonic, or a skip."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles.heyoka_oracle import Oracle

    compiled = {}

    def of(system: System, variational: bool = True) -> Oracle:
        key = system.size, variational
        if key not in compiled:
            compiled[key] = Oracle([system], harmonics=1, variational=variational)
        return compiled[key]

    return of
