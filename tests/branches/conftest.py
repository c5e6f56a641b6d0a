"""The independent integrator, as for the orbits."""

from orbits.conftest import truth

__all__ = ["truth"]
