"""The one decorator for compiled kernels, and their cache.

A kernel is a plain function of arrays, NamedTuples of arrays and scalars. It is compiled by numba without
the GIL and without fastmath. Not even contraction to fused multiply-add is left to the compiler: it keeps a
vector and a scalar version of many loops, chooses by the addresses of arrays, and contracts the two
differently, so that the last bit would depend on where memory happened to lie. Fused operations are written
out (`fma`), and every version of a loop then gives the same bytes. The cache key is a hash of *all* kernel
sources: numba alone looks at the file of the function only and would keep a caller whose callee has
changed. Every version has a folder of its own; those unused for a month go when a new one is made. Where a
cached kernel is missing or damaged, it is compiled again; where no cache folder is writable, in memory.
`GEARLASH_CACHE_DIR` names another folder.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import os
import pickle
import re
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

F = TypeVar("F", bound=Callable[..., Any])

UNUSED_DAYS = 30.0
"""After so many days without use the cache folder of another version may go."""

if TYPE_CHECKING:

    def kernel(signature: Any, allocates: bool = False) -> Callable[[F], F]: ...
    def inner(function: F) -> F: ...
    def inlined(function: F) -> F: ...
    def allocating(function: F) -> F: ...
    def fma(a: float, b: float, c: float) -> float: ...

else:
    import numba
    from numba.core import caching
    from numba.extending import intrinsic
    from numba.np import arrayobj

    def kernel(signature, allocates=False):
        """An entry point: compiled for one explicit signature when its module is imported, or read from the
        cache. Unless it ``allocates`` arrays it is compiled without reference counts, which cost more than
        the arithmetic of a small product."""

        def wrap(function):
            if numba.config.DISABLE_JIT:
                return function
            dispatcher = numba.jit(nogil=True, error_model="numpy", _nrt=allocates)(function)
            _enable_cache(dispatcher)
            with _plain_indices():
                dispatcher.compile(signature)
            dispatcher.disable_compile()
            return dispatcher

        return wrap

    def inner(function):
        """A helper that only kernels call: compiled into its callers and cached with them. It allocates
        nothing."""
        return numba.jit(nogil=True, error_model="numpy", _nrt=False)(function)

    def inlined(function):
        """A helper on the hot path, with one place that calls it: no call is left of it. (A call passes every
        array as seven numbers, which can cost more than its work.)"""
        return numba.jit(nogil=True, error_model="numpy", _nrt=False, forceinline=True)(function)

    def allocating(function):
        """A helper that makes arrays."""
        return numba.jit(nogil=True, error_model="numpy")(function)

    @contextlib.contextmanager
    def _plain_indices():
        """Indices as they are, while kernels are compiled: none of theirs counts from the end, and a test for
        that at every access keeps loops from becoming vector instructions (and doubles the compiling time). A
        numba without this function compiles as usual."""
        before = getattr(arrayobj, "fix_integer_index", None)
        if before is not None:
            arrayobj.fix_integer_index = _plain_index
        try:
            yield
        finally:
            if before is not None:
                arrayobj.fix_integer_index = before

    def _plain_index(context, builder, kind, index, size):
        return context.cast(builder, index, kind, numba.types.intp if kind.signed else numba.types.uintp)

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

    class _Locator:
        """Puts compiled kernels of this version of all kernel sources into one folder of their own."""

        def __init__(self, folder: Path):
            self._folder = folder

        def ensure_cache_path(self):
            if not self._folder.is_dir():
                self._folder.mkdir(parents=True, exist_ok=True)
                prune(self._folder)

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

    class _Files(caching.IndexDataCacheFile):
        """Files that end with a digest of what stands before it; a damaged one counts as missing. (Reading it
        could raise anything, and machine code with one wrong bit would run.)"""

        def _load_index(self):
            try:
                stamp, overloads = pickle.loads(_unsealed(self._index_path))
            except OSError:
                return {}
            return overloads if stamp == self._source_stamp else {}

        def _save_index(self, overloads):
            self._write(self._index_path, (self._source_stamp, overloads))

        def _load_data(self, name):
            return pickle.loads(_unsealed(self._data_path(name)))

        def _save_data(self, name, data):
            self._write(self._data_path(name), data)

        def _write(self, path, content):
            data = self._dump(content)
            with self._open_for_write(path) as stream:
                stream.write(data + hashlib.sha256(data).digest())

    class _Cache(caching.Cache):
        _impl_class = _CacheImpl

        def __init__(self, function):
            super().__init__(function)
            self._cache_file = _Files(
                self._cache_path, self._impl.filename_base, self._impl.locator.get_source_stamp()
            )

        def save_overload(self, signature, data):
            """Keeps a kernel, where that is possible: a full disk or a folder that cannot be written is no
            reason to stop."""
            with contextlib.suppress(OSError):
                super().save_overload(signature, data)

    def _enable_cache(dispatcher):
        _mark_used(cache_folder() / sources_hash()[:16])
        dispatcher._cache = _Cache(dispatcher.py_func)


def _unsealed(path: str) -> bytes:
    """What a cache file holds. Raises `OSError` where it is missing or not as it was written."""
    data = Path(path).read_bytes()
    content, digest = data[:-32], data[-32:]
    if hashlib.sha256(content).digest() != digest:
        raise OSError(f"{path} is damaged")
    return content


@functools.cache
def _mark_used(folder: Path) -> None:
    """The time of a folder says when its kernels were last asked for."""
    with contextlib.suppress(OSError):
        os.utime(folder)


def prune(folder: Path) -> None:
    """Removes the kernels of other versions beside this folder that nothing has used for `UNUSED_DAYS`."""
    oldest = time.time() - 86400.0 * UNUSED_DAYS
    with contextlib.suppress(OSError):
        for other in folder.parent.iterdir():
            named = re.fullmatch(r"[0-9a-f]{16}", other.name)
            if named and other != folder and other.is_dir() and other.stat().st_mtime < oldest:
                for file in (*other.glob("*.nbi"), *other.glob("*.nbc")):
                    file.unlink(missing_ok=True)
                other.rmdir()


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
    base = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA")
    if not base:
        try:
            base = Path.home() / ".cache"
        except RuntimeError:  # a user without a home
            base = os.devnull
    return Path(base) / "gearlash"


@functools.cache
def _writable(folder: Path) -> bool:
    """Whether files can be made there. A folder that cannot be written means: compile in memory."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe = folder / f".probe-{os.getpid()}"
        probe.touch()
        probe.unlink()
    except OSError:
        return False
    return True
