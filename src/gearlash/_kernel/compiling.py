"""From the source of a kernel to machine code, by numba. Imported only where a kernel is not in the cache.

Without fastmath. Not even contraction to fused multiply-add is left to the compiler: it keeps a vector and a
scalar version of many loops, chooses by the addresses of arrays, and contracts the two differently, so that
the last bit would depend on where memory happened to lie. Fused operations are written out (`fma`), and every
version of a loop then gives the same bytes."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from importlib import import_module
from types import FunctionType
from typing import Any

import numba
from numba.core import compiler, types
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler_lock import global_compiler_lock
from numba.core.dispatcher import _FunctionCompiler  # pyright: ignore[reportAttributeAccessIssue]
from numba.np import arrayobj

from .cache import Code
from .declare import HELPERS, PRIMITIVES, Kernel
from .entry import write_entry
from .memory import write_memory
from .signature import ArrayOf, Record, Several

OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy"}
_KEPT: list[Any] = []  # libraries of numba whose code is in use


def compile_kernel(kernel: Kernel) -> tuple[Code, int]:
    """The machine code of a kernel, to be kept, and the address of its entry in this process."""
    with global_compiler_lock, _plain_indices():
        made = _jit(_resolved(kernel.function, {}), {"_nrt": kernel.allocates})
        compiled = _Compiler.like(made).compile(*_numba_signature(kernel))
        library = compiled.library
        module = library.create_ir_module("entry")
        write_entry(module, compiled.target_context, compiled.fndesc, kernel)
        if kernel.allocates:
            write_memory(module)
        library.add_ir_module(module)
        library.whole = True
        library.finalize()
    _KEPT.append(library)
    final = library._final_module
    outside = [*final.functions, *final.global_variables]
    needs = sorted(one.name for one in outside if one.is_declaration and not one.name.startswith("llvm."))
    code = Code(library._get_compiled_object(), kernel.name, tuple(needs))
    return code, library.get_pointer_to_function(kernel.name)


class _Compiler(_FunctionCompiler):
    """Of a kernel: stops before machine code is made, so that the entry can be added."""

    @classmethod
    def like(cls, made: Any) -> _Compiler:
        """In place of the compiler of a function of numba."""
        return cls(made.py_func, made.targetdescr, made.targetoptions, {}, _Pipeline)

    def _customize_flags(self, flags: Any) -> Any:
        flags.no_cpython_wrapper = flags.no_cfunc_wrapper = flags.no_compile = True
        return flags


class _HelperCompiler(_Compiler):
    """Of a helper, which nobody calls from Python."""

    def _compile_core(self, args: Any, return_type: Any) -> Any:
        found = super()._compile_core(args, return_type)
        name: Any = [].append  # numba tells overloads apart by a built-in function of each: any one will do
        found.target_context.insert_user_function(name, found.fndesc, [found.library])
        return found._replace(entry_point=name)


class _Library(JITCodeLibrary):
    """What numba collects machine code in. That of a helper is not optimised and not translated: both happen
    once, to the whole kernel that it has become part of."""

    whole = False

    def _optimize_final_module(self) -> None:
        if self.whole:
            super()._optimize_final_module()

    def _finalize_final_module(self) -> None:
        if self.whole:
            super()._finalize_final_module()
        self._finalized = True


class _Pipeline(compiler.Compiler):
    """A third of the time: numba itself would make every helper callable from Python, with machine code for
    it and for all that it calls."""

    def __init__(self, typing: Any, target: Any, library: Any, *others: Any):
        super().__init__(typing, target, library or _Library(target.codegen(), "part"), *others)
        self.state.library.enable_object_caching()


def _resolved(function: FunctionType, known: dict[FunctionType, Any]) -> FunctionType:
    """The function with what numba takes in place of the helpers and primitives that it names."""
    names = dict(function.__globals__)
    made = FunctionType(function.__code__, names, function.__name__, function.__defaults__)
    made.__module__, made.__qualname__, made.__doc__ = (
        function.__module__,
        function.__qualname__,
        function.__doc__,
    )
    for name in function.__code__.co_names:
        named = names.get(name)
        if isinstance(named, FunctionType):
            if named in PRIMITIVES:
                names[name] = getattr(import_module(PRIMITIVES[named]), named.__name__)
            elif named in HELPERS:
                names[name] = known[named] = known.get(named) or _helper(named, known)
    return made


def _helper(function: FunctionType, known: dict[FunctionType, Any]) -> Any:
    made = _jit(_resolved(function, known), HELPERS[function])
    made._compiler = _HelperCompiler.like(made)
    return made


def _jit(function: FunctionType, options: dict[str, Any]) -> Any:
    return numba.jit(**OPTIONS, **options)(function)


def _numba_signature(kernel: Kernel) -> tuple[tuple[Any, ...], Any]:
    return tuple(map(_numba_type, kernel.signature.arguments)), _numba_type(kernel.signature.result)


def _numba_type(kind: Any) -> Any:
    if isinstance(kind, ArrayOf):
        return types.Array(_numba_type(kind.kind), kind.dimensions, "C", readonly=not kind.writable)
    if isinstance(kind, Record):
        return types.NamedUniTuple(types.int64, kind.size, kind.of)
    if isinstance(kind, Several):
        return types.UniTuple(_numba_type(kind.kind), kind.count)
    return getattr(types, kind.name)


@contextlib.contextmanager
def _plain_indices() -> Iterator[None]:
    """Indices as they are, while kernels are compiled: none of theirs counts from the end, and a test for
    that at every access keeps loops from becoming vector instructions (and doubles the compiling time). A
    numba without this function compiles as usual."""
    before = getattr(arrayobj, "fix_integer_index", None)
    if before is not None:
        arrayobj.fix_integer_index = _plain_index  # pyright: ignore[reportAttributeAccessIssue]
    try:
        yield
    finally:
        if before is not None:
            arrayobj.fix_integer_index = before


def _plain_index(context: Any, builder: Any, kind: Any, index: Any, size: Any) -> Any:
    return context.cast(builder, index, kind, types.intp if kind.signed else types.uintp)
