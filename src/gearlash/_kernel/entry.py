"""The entry of a kernel: a function of Python's C interface that takes arguments apart, refuses what the
kernel was not compiled for, and calls it without the interpreter's lock. Imported for compiling only.

Of arrays it reads what NumPy's C interface lays open to every extension: data, shape, strides, flags and type
at fixed places (`machine` checks that they are there). A call so costs a fraction of a microsecond."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from llvmlite import ir
from numba.core import cgutils, types
from numba.np import arrayobj

from .declare import Kernel
from .machine import ARRAY_PLACES, CARRAY, DTYPE_PLACES, KNOWN, WRITABLE
from .signature import ArrayOf, Record, Scalar, Several, int64, void

WORD, INT, BYTE, TRUTH, REAL = ir.IntType(64), ir.IntType(32), ir.IntType(8), ir.IntType(1), ir.DoubleType()
OBJECT, NOTHING = BYTE.as_pointer(), ir.VoidType()
NULL = ir.Constant(OBJECT, None)
CODES = {
    "float64": "d",
    "int64": "".join(code for code in "lq" if np.dtype(code).itemsize == 8),
}  # of NumPy, for types of this size; both for int64 on most systems


def write_entry(module: ir.Module, context: Any, descriptor: Any, kernel: Kernel) -> None:
    """Adds to a module a function (self, arguments, their number) with the name of the kernel that calls what
    ``descriptor`` of numba describes; ``self`` holds what is `KNOWN`, and the types of the records."""
    signature, name = kernel.signature, kernel.function.__name__
    names = kernel.function.__code__.co_varnames[: len(signature.arguments)]
    function = ir.Function(module, ir.FunctionType(OBJECT, [OBJECT, OBJECT.as_pointer(), WORD]), kernel.name)
    builder = ir.IRBuilder(function.append_basic_block("entry"))
    classes, arguments, count = function.args
    entry = _Entry(context, builder, name, classes)
    expected = len(signature.arguments)
    with entry.refused_unless(builder.icmp_signed("==", count, WORD(expected))):
        entry.raises(TypeError, f"{name} takes {expected} positional arguments")
    values, records = [], len(KNOWN)
    for i, (kind, called) in enumerate(zip(signature.arguments, names, strict=True)):
        given = builder.load(builder.gep(arguments, [WORD(i)]))
        if isinstance(kind, Record):
            values.append(entry.record(kind, given, entry.item(classes, records), called))
            records += 1
        elif isinstance(kind, ArrayOf):
            native = descriptor.argtypes[i]
            values.append(
                entry.array(kind, native, given, entry.item(classes, KNOWN.index(np.ndarray)), called)
            )
        else:
            values.append(entry.scalar(kind, given, called))
    builder.ret(entry.result(signature.result, entry.called(descriptor, values)))


class _Entry:
    """Writes the parts of one entry."""

    def __init__(self, context: Any, builder: ir.IRBuilder, name: str, classes: Any):
        self.context, self.builder, self.name, self.classes = context, builder, name, classes

    def python(self, name: str, result: ir.Type, *arguments: Any) -> Any:
        """Calls a function of Python's C interface."""
        kind = ir.FunctionType(result, [argument.type for argument in arguments])
        function = cgutils.get_or_insert_function(self.builder.module, kind, name)
        return self.builder.call(function, arguments)

    def refused_unless(self, fits: Any) -> Any:
        """A block for what happens where something does not fit."""
        return self.builder.if_then(self.builder.not_(fits), likely=False)

    def raises(self, error: type, message: str) -> None:
        """Sets an exception of Python and returns. (Its class comes with the classes: libraries that other
        packages load may bring variables of the same name as Python's.)"""
        kind = self.item(self.classes, KNOWN.index(error))
        text = self.context.insert_const_string(self.builder.module, message)
        self.python("PyErr_SetString", NOTHING, kind, self.builder.bitcast(text, OBJECT))
        self.builder.ret(NULL)

    def item(self, several: Any, index: int) -> Any:
        """Of a tuple."""
        return self.python("PyTuple_GetItem", OBJECT, several, WORD(index))

    def is_a(self, given: Any, kind: Any) -> Any:
        return self.builder.icmp_signed("==", self.python("PyObject_IsInstance", INT, given, kind), INT(1))

    def read(self, start: Any, place: int, kind: ir.Type) -> Any:
        """A field of a structure."""
        address = self.builder.gep(start, [WORD(place)])
        return self.builder.load(self.builder.bitcast(address, kind.as_pointer()))

    def scalar(self, kind: Scalar, given: Any, called: str) -> Any:
        """A number. What cannot be had without loss is refused by Python itself: a fraction as a whole
        number."""
        builder, expected = self.builder, f"{self.name}: {called} is not a number ({kind.name})"
        if kind.name == "boolean":
            truth = self.python("PyObject_IsTrue", INT, given)
            with self.refused_unless(builder.icmp_signed(">=", truth, INT(0))):
                self.raises(TypeError, expected)
            return builder.icmp_signed("==", truth, INT(1))
        if kind.name == "float64":
            value = self.python("PyFloat_AsDouble", REAL, given)
            odd = builder.fcmp_ordered("==", value, REAL(-1.0))
        else:
            value = self.python("PyLong_AsLongLong", WORD, given)
            odd = builder.icmp_signed("==", value, WORD(-1))
        with builder.if_then(odd, likely=False):
            failed = builder.icmp_unsigned("!=", self.python("PyErr_Occurred", OBJECT), NULL)
            with builder.if_then(failed):
                self.raises(TypeError, expected)
        return value

    def record(self, kind: Record, given: Any, expected: Any, called: str) -> Any:
        """A NamedTuple of whole numbers."""
        with self.refused_unless(self.is_a(given, expected)):
            self.raises(TypeError, f"{self.name}: {called} is not a {kind.of.__name__}")
        fields = self.builder.alloca(ir.ArrayType(WORD, kind.size))
        for i, field in enumerate(kind.of._fields):
            value = self.scalar(int64, self.item(given, i), f"{called}.{field}")
            self.builder.store(value, self.builder.gep(fields, [WORD(0), WORD(i)]))
        return self.builder.load(fields)

    def array(self, kind: ArrayOf, native: Any, given: Any, expected: Any, called: str) -> Any:
        """An array as numba hands it to machine code, without an owner."""
        message = f"{self.name}: {called} is not a {kind}"
        with self.refused_unless(self.is_a(given, expected)):
            self.raises(TypeError, message)
        with self.refused_unless(self._fits(kind, given)):
            self.raises(TypeError, message)
        builder, made = self.builder, self.context.make_array(native)(self.context, self.builder)
        lists = [self.read(given, ARRAY_PLACES[name], WORD.as_pointer()) for name in ("shape", "strides")]
        shape, strides = (
            [builder.load(builder.gep(each, [WORD(i)])) for i in range(kind.dimensions)] for each in lists
        )
        data = self.read(given, ARRAY_PLACES["data"], OBJECT)
        arrayobj.populate_array(
            made,
            data=builder.bitcast(data, self.context.get_value_type(native.dtype).as_pointer()),
            shape=shape,
            strides=strides,
            itemsize=self.context.get_constant(types.intp, 8),
            meminfo=None,
        )
        return made._getvalue()

    def _fits(self, kind: ArrayOf, given: Any) -> Any:
        builder = self.builder
        dtype = self.read(given, ARRAY_PLACES["dtype"], OBJECT)
        code, order = (self.read(dtype, DTYPE_PLACES[name], BYTE) for name in ("char", "byteorder"))
        flags = self.read(given, ARRAY_PLACES["flags"], INT)
        needed = INT(CARRAY | WRITABLE if kind.writable else CARRAY)
        fits = builder.icmp_signed("==", builder.and_(flags, needed), needed)
        dimensions = self.read(given, ARRAY_PLACES["ndim"], INT)
        fits = builder.and_(fits, builder.icmp_signed("==", dimensions, INT(kind.dimensions)))
        fits = builder.and_(fits, builder.icmp_signed("==", order, BYTE(ord("="))))
        same = TRUTH(0)
        for possible in CODES[kind.kind.name]:
            same = builder.or_(same, builder.icmp_signed("==", code, BYTE(ord(possible))))
        return builder.and_(fits, same)

    def called(self, descriptor: Any, values: Sequence[Any]) -> Any:
        """What the kernel returns; it raises nothing itself, so that only memory can have lacked."""
        module, context = self.builder.module, self.context
        kind = context.call_conv.get_function_type(descriptor.restype, descriptor.argtypes)
        kernel = ir.Function(module, kind, descriptor.llvm_func_name)
        released = self.python("PyEval_SaveThread", OBJECT)
        status, result = context.call_conv.call_function(
            self.builder, kernel, descriptor.restype, descriptor.argtypes, values, attrs=("noinline",)
        )
        self.python("PyEval_RestoreThread", NOTHING, released)
        with self.builder.if_then(status.is_error, likely=False):
            self.raises(MemoryError, f"{self.name}: its work space cannot be had")
        return result

    def result(self, kind: Scalar | Several, value: Any) -> Any:
        """A result as an object."""
        if isinstance(kind, Several):
            made = self.python("PyTuple_New", OBJECT, WORD(kind.count))
            for i in range(kind.count):
                part = self.result(kind.kind, self.builder.extract_value(value, i))
                self.python("PyTuple_SetItem", INT, made, WORD(i), part)
            return made
        if kind == void:
            nothing = self.item(self.classes, KNOWN.index(None))
            self.python("Py_IncRef", NOTHING, nothing)
            return nothing
        if kind.name == "float64":
            return self.python("PyFloat_FromDouble", OBJECT, value)
        return self.python("PyLong_FromLongLong", OBJECT, value)
