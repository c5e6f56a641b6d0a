"""The one decorator for compiled kernels, and their cache.

A kernel is a plain function of arrays, NamedTuples of arrays and scalars. It is compiled by numba without
the GIL and without fastmath. Not even contraction to fused multiply-add is left to the compiler: it keeps a
vector and a scalar version of many loops, chooses by the addresses of arrays, and contracts the two
differently, so that the last bit would depend on where memory happened to lie. Fused operations are written
out (`fma`), and every version of a loop then gives the same bytes. The cache key is a hash of *all* kernel
sources: numba alone looks at the file of the function only and would keep a caller whose callee has
changed. Where no cache folder is writable, kernels are compiled in memory; `GEARLASH_CACHE_DIR` names
another folder.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

F = TypeVar("F", bound=Callable[..., Any])

if TYPE_CHECKING:

    def kernel(signature: Any) -> Callable[[F], F]: ...
    def inner(function: F) -> F: ...
    def allocating(function: F) -> F: ...
    def fma(a: float, b: float, c: float) -> float: ...

else:
    import numba
    from numba.core import caching
    from numba.extending import intrinsic

    def kernel(signature, allocates=False):
        """An entry point: compiled for one explicit signature when its module is imported, or read from the
        cache. Unless it ``allocates`` arrays it is compiled without reference counts, which cost more than the
        arithmetic of a small product."""

        def wrap(function):
            if numba.config.DISABLE_JIT:
                return function
            dispatcher = numba.jit(nogil=True, error_model="numpy", _nrt=allocates)(function)
            _enable_cache(dispatcher)
            with _slp_vectoriser():
                dispatcher.compile(signature)
            dispatcher.disable_compile()
            return dispatcher

        return wrap

    def inner(function):
        """A helper that only kernels call: compiled into its callers and cached with them; allocates nothing."""
        return numba.jit(nogil=True, error_model="numpy", _nrt=False)(function)

    def allocating(function):
        """A helper that makes arrays."""
        return numba.jit(nogil=True, error_model="numpy")(function)

    if numba.config.DISABLE_JIT:

        def fma(a, b, c):
            """a·b + c; with compiled kernels rounded once."""
            return a * b + c

    else:

        @intrinsic
        def fma(typing_context, a, b, c):
            """a·b + c, rounded once, wherever it is written and nowhere else."""
            signature = numba.float64(numba.float64, numba.float64, numba.float64)

            def generate(context, builder, signature, arguments):
                return builder.fma(*arguments)

            return signature, generate

    @contextlib.contextmanager
    def _slp_vectoriser():
        """Lets the compiler join neighbouring scalar operations into vector ones (numba leaves that off): the
        blocks of eight rows in `flow._blocks` are written for it."""
        before = numba.config.SLP_VECTORIZE
        numba.config.SLP_VECTORIZE = 1
        try:
            yield
        finally:
            numba.config.SLP_VECTORIZE = before

    class _Locator:
        """Puts compiled kernels of this version of all kernel sources into one folder of their own."""

        def __init__(self, folder: Path):
            self._folder = folder

        def ensure_cache_path(self):
            self._folder.mkdir(parents=True, exist_ok=True)

        def get_cache_path(self):
            return str(self._folder)

        def get_source_stamp(self):
            return sources_hash()

        def get_disambiguator(self):
            return None

    class _CacheImpl(caching.CompileResultCacheImpl):
        def __init__(self, function):
            self._lineno = function.__code__.co_firstlineno
            self._locator = _Locator(cache_folder() / sources_hash()[:16])
            name = f"{function.__module__}.{function.__qualname__}"
            abi = f"{sys.implementation.cache_tag}-{numba.__version__}"
            self._filename_base = self.get_filename_base(name, abi)

        def get_filename_base(self, fullname, abiflags):
            return f"{fullname}-{abiflags}"

    class _Cache(caching.Cache):
        _impl_class = _CacheImpl

    def _enable_cache(dispatcher):
        if _writable(cache_folder()):
            dispatcher._cache = _Cache(dispatcher.py_func)


@functools.cache
def sources_hash() -> str:
    """SHA-256 of every file of the package that holds kernels (their names start with an underscore), in
    order."""
    root = Path(__file__).parent
    digest = hashlib.sha256()
    for path in sorted(root.rglob("_*.py")):
        if path.name != "__init__.py":
            digest.update(path.relative_to(root).as_posix().encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()


def cache_folder() -> Path:
    """Where compiled kernels are kept: `GEARLASH_CACHE_DIR`, else the user's cache folder."""
    named = os.environ.get("GEARLASH_CACHE_DIR")
    if named:
        return Path(named)
    base = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA") or str(Path.home() / ".cache")
    return Path(base) / "gearlash"


@functools.cache
def _writable(folder: Path) -> bool:
    """Whether files can be made there. A folder that cannot be written means: compile in memory, say
    nothing."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe = folder / f".probe-{os.getpid()}"
        probe.touch()
        probe.unlink()
    except OSError:
        return False
    return True
