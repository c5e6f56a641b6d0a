"""The one arithmetic primitive of the engine: out ← Σ_k x[k] · column k, eight rows at a time.

Tables lie in one flat array, columns padded to whole blocks of eight rows, so that a product is a loop over
columns with one, two or three vector accumulators. It is written in the compiler's own vector instructions:
its bytes then depend neither on addresses nor on what a vectoriser makes of a loop."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gearlash._kernel import inner

LANES = 8


def padded(n: int) -> int:
    """n rounded up to whole blocks."""
    return -(-n // LANES) * LANES


if TYPE_CHECKING:
    from typing import Any

    def linear(
        table: Any, at: int, stride: int, rows: int, count: int, x: Any, first: int, out: Any, to: int
    ) -> None: ...
    def peak(values: Any, at: int, count: int) -> float: ...
    def weigh(weights: Any, at: int, count: int, x: Any, first: int) -> float: ...

else:
    import numba
    from numba import types

    if numba.config.DISABLE_JIT:

        def linear(table, at, stride, rows, count, x, first, out, to):
            factors = [float(x[first + k]) for k in range(count)]
            for i in range(rows):
                value = 0.0
                for k in range(count):
                    value += table[at + k * stride + i] * factors[k]
                out[to + i] = value

        def peak(values, at, count):
            return float(max(abs(values[at + i]) for i in range(count)))

        def weigh(weights, at, count, x, first):
            return float(sum(weights[at + i] * abs(x[first + i]) for i in range(count)))

    else:
        from llvmlite import ir
        from numba.extending import intrinsic

        _DOUBLE, _INDEX = ir.DoubleType(), ir.IntType(64)
        _VECTOR = ir.VectorType(_DOUBLE, LANES)

        def _pointer(context, builder, array_type, value):
            return context.make_array(array_type)(context, builder, value).data

        def _lanes(builder, pointer, index):
            return builder.bitcast(builder.gep(pointer, [index]), _VECTOR.as_pointer())

        def _load(builder, pointer, index):
            return builder.load(_lanes(builder, pointer, index), align=8)

        def _splat(builder, scalar):
            blank = ir.Constant(_VECTOR, ir.Undefined)
            one = builder.insert_element(blank, scalar, ir.IntType(32)(0))
            return builder.shuffle_vector(
                one, blank, ir.Constant(ir.VectorType(ir.IntType(32), LANES), [0] * LANES)
            )

        def _call(builder, name, arguments):
            kind = ir.FunctionType(_VECTOR, [_VECTOR] * len(arguments))
            return builder.call(builder.module.declare_intrinsic(name, (), kind), arguments)

        def _product(blocks):
            """A product of 8·blocks rows out of a table whose columns are ``stride`` long."""

            @intrinsic
            def product(typing, table, at, stride, count, x, first, out, to):
                whole = types.int64
                signature = types.void(table, whole, whole, whole, x, whole, out, whole)

                def generate(context, builder, signature, arguments):
                    table, at, stride, count, x, first, out, to = arguments
                    table = _pointer(context, builder, signature.args[0], table)
                    x = _pointer(context, builder, signature.args[4], x)
                    out = _pointer(context, builder, signature.args[6], out)
                    places = [_INDEX(LANES * b) for b in range(blocks)]
                    start = [ir.Constant(_VECTOR, [0.0] * LANES)] * blocks
                    before = builder.block
                    loop, end = (builder.append_basic_block(name) for name in ("columns", "stored"))
                    builder.cbranch(builder.icmp_signed(">", count, _INDEX(0)), loop, end)
                    builder.position_at_end(loop)
                    k, here = builder.phi(_INDEX), builder.phi(_INDEX)
                    sums = [builder.phi(_VECTOR) for _ in places]
                    factor = _splat(builder, builder.load(builder.gep(x, [builder.add(first, k)])))
                    new = [
                        _call(
                            builder,
                            "llvm.fma.v8f64",
                            [_load(builder, table, builder.add(here, place)), factor, total],
                        )
                        for place, total in zip(places, sums, strict=True)
                    ]
                    after, there = builder.add(k, _INDEX(1)), builder.add(here, stride)
                    for phi, first_value, next_value in [
                        (k, _INDEX(0), after),
                        (here, at, there),
                        *zip(sums, start, new, strict=True),
                    ]:
                        phi.add_incoming(first_value, before)
                        phi.add_incoming(next_value, loop)
                    builder.cbranch(builder.icmp_signed("<", after, count), loop, end)
                    builder.position_at_end(end)
                    results = [builder.phi(_VECTOR) for _ in places]
                    for result, none, some in zip(results, start, new, strict=True):
                        result.add_incoming(none, before)
                        result.add_incoming(some, loop)
                    for result, place in zip(results, places, strict=True):
                        builder.store(result, _lanes(builder, out, builder.add(to, place)), align=8)
                    return context.get_dummy_value()

                return signature, generate

            return product

        def _reduction(name, join, weighted):
            """max |x| or Σ w |x| over whole blocks, lane by lane, the lanes joined in order at the end."""

            def generate(context, builder, signature, arguments):
                if weighted:
                    weights, at, count, x, first = arguments
                    weights = _pointer(context, builder, signature.args[0], weights)
                    x = _pointer(context, builder, signature.args[3], x)
                else:
                    x, first, count = arguments
                    x = _pointer(context, builder, signature.args[0], x)
                before = builder.block
                loop, end = (builder.append_basic_block(text) for text in (name, "joined"))
                zero = ir.Constant(_VECTOR, [0.0] * LANES)
                builder.cbranch(builder.icmp_signed(">", count, _INDEX(0)), loop, end)
                builder.position_at_end(loop)
                k, total = builder.phi(_INDEX), builder.phi(_VECTOR)
                size = _call(builder, "llvm.fabs.v8f64", [_load(builder, x, builder.add(first, k))])
                if weighted:
                    weight = _load(builder, weights, builder.add(at, k))
                    new = _call(builder, "llvm.fma.v8f64", [weight, size, total])
                else:
                    new = _call(builder, "llvm.maximum.v8f64", [size, total])  # NaN stays
                after = builder.add(k, _INDEX(LANES))
                for phi, first_value, next_value in ((k, _INDEX(0), after), (total, zero, new)):
                    phi.add_incoming(first_value, before)
                    phi.add_incoming(next_value, loop)
                builder.cbranch(builder.icmp_signed("<", after, count), loop, end)
                builder.position_at_end(end)
                last = builder.phi(_VECTOR)
                last.add_incoming(zero, before)
                last.add_incoming(new, loop)
                parts = [builder.extract_element(last, ir.IntType(32)(i)) for i in range(LANES)]
                while len(parts) > 1:
                    parts = [join(builder, a, b) for a, b in zip(parts[::2], parts[1::2], strict=True)]
                return parts[0]

            return generate

        def _larger(builder, a, b):
            kind = ir.FunctionType(_DOUBLE, [_DOUBLE, _DOUBLE])
            return builder.call(builder.module.declare_intrinsic("llvm.maximum.f64", (), kind), [a, b])

        @intrinsic
        def peak(typing, values, at, count):
            """Largest |values[at + i]|, i < count (a multiple of eight)."""
            signature = types.float64(values, types.int64, types.int64)
            return signature, _reduction("largest", _larger, weighted=False)

        @intrinsic
        def weigh(typing, weights, at, count, x, first):
            """Σ weights[at + i] |x[first + i]|, i < count (a multiple of eight)."""
            signature = types.float64(weights, types.int64, types.int64, x, types.int64)
            return signature, _reduction("weighed", lambda builder, a, b: builder.fadd(a, b), weighted=True)

        _linear1, _linear2, _linear3 = (_product(blocks) for blocks in (1, 2, 3))

        @inner
        def linear(table, at, stride, rows, count, x, first, out, to):
            """out[to:to+rows] ← Σ_k x[first+k] · table[at + k·stride:][:rows], rows a multiple of eight."""
            done = 0
            while rows - done >= 24:
                _linear3(table, at + done, stride, count, x, first, out, to + done)
                done += 24
            if rows - done >= 16:
                _linear2(table, at + done, stride, count, x, first, out, to + done)
            elif rows - done >= 8:
                _linear1(table, at + done, stride, count, x, first, out, to + done)
