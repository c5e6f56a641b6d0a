"""Compiled kernels: how they are declared, compiled, kept and called.

A kernel is a plain function of arrays, NamedTuples of whole numbers and scalars. numba compiles it once a
machine; what is kept is machine code with an entry of its own, so that whoever finds it on disk loads and
calls it without numba, whose import takes longer than most answers.

`declare` (the decorators) → `compiling` (numba, in processes of their own: `workshop`) → `entry` (how Python
calls machine code) → `cache` (files) → `machine` (loads them)."""

from .announce import keep_silent
from .declare import Kernel, allocating, fma, inlined, inner, kernel, primitive
from .prepare import compile_all, load_all
from .signature import ArrayOf, Record, Several, boolean, float64, int64, void

__all__ = [
    "ArrayOf",
    "Kernel",
    "Record",
    "Several",
    "allocating",
    "boolean",
    "compile_all",
    "float64",
    "fma",
    "inlined",
    "inner",
    "int64",
    "keep_silent",
    "kernel",
    "load_all",
    "primitive",
    "void",
]
