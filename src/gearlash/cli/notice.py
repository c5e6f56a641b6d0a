"""The kernels, before anything is computed.

They are compiled once a machine and version and then read from a cache; while they are being compiled, one
line on standard error says so, and one when that is done.
"""

from __future__ import annotations

from .terminal import tell


def load_engine() -> None:
    """Imports the engine and loads its kernels, or compiles them and says so."""
    from gearlash import flow  # noqa: F401  (declares the kernels)
    from gearlash._kernel import compile_all, load_all

    compile_all(load_all(), tell)
