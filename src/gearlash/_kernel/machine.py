"""Machine code into this process, and callable: with LLVM's own loader, without numba."""

from __future__ import annotations

import ctypes
import functools
import importlib
from collections.abc import Callable
from typing import Any

import numpy as np

from .cache import Code
from .signature import Record, Signature

HEAD = object.__basicsize__
ARRAY_PLACES = {
    "data": HEAD,
    "ndim": HEAD + 8,
    "shape": HEAD + 16,
    "strides": HEAD + 24,
    "dtype": HEAD + 40,
    "flags": HEAD + 48,
}
"""Bytes from the start of an array object: fields that NumPy's C interface lays open."""
DTYPE_PLACES = {"char": HEAD + 9, "byteorder": HEAD + 10}
KNOWN = (np.ndarray, TypeError, MemoryError, None)
"""What every entry is given of Python."""
CARRAY, WRITABLE = 0x101, 0x400  # flags of an array: C-contiguous and aligned; writable

_METH_FASTCALL = 0x80
_KEPT: list[Any] = []  # what C code refers to


class _Method(ctypes.Structure):
    """PyMethodDef."""

    _fields_ = (
        ("name", ctypes.c_char_p),
        ("address", ctypes.c_void_p),
        ("flags", ctypes.c_int),
        ("doc", ctypes.c_char_p),
    )


def can_load(code: Code) -> bool:
    """Whether this process has all that the machine code needs, if need be after importing numba, which
    brings vectorised functions where they are installed. (LLVM would end the process where something is
    missing.)"""
    _engine()  # with it LLVM looks for names in the whole process
    if _missing(code):
        importlib.import_module("numba")
    return not _missing(code)


def _missing(code: Code) -> list[str]:
    from llvmlite import binding

    return [name for name in code.needs if binding.address_of_symbol(name) is None]


def load(code: Code, signature: Signature) -> Callable[..., Any]:
    """A Python function from the machine code of a kernel, which `can_load` found loadable."""
    from llvmlite import binding

    engine = _engine()
    engine.add_object_file(binding.ObjectFileRef.from_data(code.object_file))
    engine.finalize_object()
    return callable_at(engine.get_function_address(code.entry), code.entry.rpartition(".")[2], signature)


def callable_at(address: int, name: str, signature: Signature) -> Callable[..., Any]:
    """A Python function from the address of an entry (see `entry`)."""
    _check_layout()
    method = _Method(name.encode(), address, _METH_FASTCALL, None)
    types = (*KNOWN, *(kind.of for kind in signature.arguments if isinstance(kind, Record)))
    make = ctypes.pythonapi.PyCFunction_NewEx
    make.argtypes, make.restype = (
        (ctypes.POINTER(_Method), ctypes.py_object, ctypes.c_void_p),
        ctypes.py_object,
    )
    _KEPT.append(method)
    return make(ctypes.byref(method), types, None)


@functools.cache
def _engine() -> Any:
    from llvmlite import binding

    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    triple = binding.get_process_triple()
    nothing = binding.parse_assembly(f'target triple = "{triple}"')
    return binding.create_mcjit_compiler(nothing, binding.Target.from_triple(triple).create_target_machine())


@functools.cache
def _check_layout() -> None:
    """Raises `ImportError` unless an array object is laid out as entries of kernels read it."""
    array = np.zeros((2, 3))
    read = {
        "data": _at(array, ARRAY_PLACES["data"], ctypes.c_size_t) == array.__array_interface__["data"][0],
        "ndim": _at(array, ARRAY_PLACES["ndim"], ctypes.c_int) == 2,
        "dtype": _at(array, ARRAY_PLACES["dtype"], ctypes.c_size_t) == id(array.dtype),
        "flags": _at(array, ARRAY_PLACES["flags"], ctypes.c_int) & 0x501 == CARRAY | WRITABLE,
        "char": _at(array.dtype, DTYPE_PLACES["char"], ctypes.c_char) == b"d",
        "byteorder": _at(array.dtype, DTYPE_PLACES["byteorder"], ctypes.c_char) == b"=",
    }
    for name, expected in (("shape", array.shape), ("strides", array.strides)):
        first = _at(array, ARRAY_PLACES[name], ctypes.c_size_t)
        read[name] = tuple((ctypes.c_ssize_t * 2).from_address(first)) == expected
    if not all(read.values()):
        wrong = ", ".join(name for name, right in read.items() if not right)
        raise ImportError(
            f"NumPy {np.__version__} lays out arrays in a way that gearlash does not know: {wrong}"
        )


def _at(thing: object, place: int, kind: Any) -> Any:
    return kind.from_address(id(thing) + place).value
