"""The kernels, before anything is computed.

They are compiled once a machine and version and then read from a cache; while they are being compiled, one
line on standard error says so, and one when that is done.
"""

from __future__ import annotations

import gc

from .linear_algebra import not_importing_linear_algebra
from .terminal import tell


def load_engine(data: bool = False) -> None:
    """Imports the engine and loads its kernels, or compiles them and says so. ``data``: also what writes
    datasets, as who has stopped a study waits for them to be written."""
    if data:
        import h5netcdf  # noqa: F401
        import xarray  # noqa: F401
    from gearlash._kernel import compile_all, load_all, not_collecting

    with not_importing_linear_algebra():
        with not_collecting():
            from gearlash.flow import sensitivity  # noqa: F401  (declares all kernels)

            missing = load_all()
        gc.freeze()  # what numba consists of stays as long as this process: no garbage is looked for in it
        compile_all(missing, tell)
