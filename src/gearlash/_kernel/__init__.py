"""Compiled kernels: how they are declared, compiled, kept and loaded, all of it by numba.

`jit` (the decorators; `options` are numba's) → `declare` (what was declared) → `prepare` (ready, when first
called) → `compiling` (numba) → `cache` (files, trusted by the rules of `trust`). `workshop` compiles in two
processes beside each other, `waiting` lets one of several first runs do it."""

from .announce import keep_silent
from .collecting import not_collecting
from .declare import Kernel
from .prepare import compile_all, load_all

__all__ = ["Kernel", "compile_all", "keep_silent", "load_all", "not_collecting"]
