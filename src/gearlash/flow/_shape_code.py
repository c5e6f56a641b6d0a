"""`shape_of` in machine code."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._shape import Shape

if not TYPE_CHECKING:
    from llvmlite import ir
    from numba import types
    from numba.extending import intrinsic

    @intrinsic
    def shape_of(typing, sizes):
        shape = types.NamedUniTuple(types.int64, len(Shape._fields), Shape)

        def generate(context, builder, signature, arguments):
            data = context.make_array(signature.args[0])(context, builder, arguments[0]).data
            places = [builder.gep(data, [ir.IntType(64)(i)]) for i in range(len(Shape._fields))]
            return context.make_tuple(builder, shape, [builder.load(place) for place in places])

        return shape(sizes), generate
