"""The vector primitives as LLVM's own vector instructions. Imported for compiling only."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._blocks import LANES, MASKED

if not TYPE_CHECKING:
    from llvmlite import ir
    from numba import types
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

    def _linear_function(module):
        """The machine function behind `linear`, once in a module: pointers and counts in registers.
        (Written out at every call, it would make the kernels slow to compile.)"""
        name = "gearlash_linear"
        if name in module.globals:
            return module.globals[name]
        pointer = _DOUBLE.as_pointer()
        kind = ir.FunctionType(ir.VoidType(), [pointer, _INDEX, _INDEX, _INDEX, pointer, pointer])
        function = ir.Function(module, kind, name)
        function.linkage = "linkonce_odr"
        function.attributes.add("noinline")
        function.attributes.add("nounwind")
        function.attributes.add("optsize")  # no copies for every set of constant arguments: slow to compile
        table, stride, rows, count, x, out = function.args

        def blocks_at(row, blocks):
            _product(builder, blocks, builder.gep(table, [row]), stride, count, x, builder.gep(out, [row]))

        builder = ir.IRBuilder(function.append_basic_block("entry"))
        entry, head, four, rest, end = (
            builder.block, *map(function.append_basic_block, ("head", "four", "rest", "end"))
        )  # fmt: skip
        builder.branch(head)
        builder.position_at_end(head)
        row = builder.phi(_INDEX)
        left = builder.sub(rows, row)
        builder.cbranch(builder.icmp_signed(">=", left, _INDEX(4 * LANES)), four, rest)
        builder.position_at_end(four)
        blocks_at(row, 4)
        following = builder.add(row, _INDEX(4 * LANES))
        row.add_incoming(_INDEX(0), entry)
        row.add_incoming(following, builder.block)
        builder.branch(head)
        builder.position_at_end(rest)
        switch = builder.switch(left, end)
        for blocks in (3, 2, 1):
            case = function.append_basic_block(f"rest{blocks}")
            switch.add_case(_INDEX(LANES * blocks), case)
            builder.position_at_end(case)
            blocks_at(row, blocks)
            builder.branch(end)
        builder.position_at_end(end)
        builder.ret_void()
        return function

    def _product(builder, blocks, table, stride, count, x, out, in_lanes=False):
        """out ← Σ_k x[k] · (table + k·stride), 8·blocks rows; or, with eight motions in lanes
        (``in_lanes``), so many rows of each. Even and odd columns go into sums of their own: half the wait
        of one chain."""
        zero = ir.Constant(_VECTOR, [0.0] * LANES)
        places = [_INDEX(LANES * b) for b in range(blocks)]

        def column(k, here, sums):
            if in_lanes:
                vectors = [_load(builder, x, builder.mul(k, _INDEX(LANES)))] * blocks
                entries = [builder.add(here, _INDEX(b)) for b in range(blocks)]
                factors = [_splat(builder, builder.load(builder.gep(table, [at]))) for at in entries]
            else:
                vectors = [_load(builder, table, builder.add(here, place)) for place in places]
                factors = [_splat(builder, builder.load(builder.gep(x, [k])))] * blocks
            terms = zip(vectors, factors, sums, strict=True)
            return [_call(builder, "llvm.fma.v8f64", [*term]) for term in terms]

        before = builder.block
        names = ("pairs", "paired", "single", "stored")
        loop, paired, single, end = (builder.append_basic_block(name) for name in names)
        pairs = builder.and_(count, _INDEX(-2))
        builder.cbranch(builder.icmp_signed(">", pairs, _INDEX(0)), loop, paired)
        builder.position_at_end(loop)
        k, here = builder.phi(_INDEX), builder.phi(_INDEX)
        sums = [builder.phi(_VECTOR) for _ in range(2 * blocks)]
        even = column(k, here, sums[:blocks])
        beside = builder.add(here, stride)
        odd = column(builder.add(k, _INDEX(1)), beside, sums[blocks:])
        after, there = builder.add(k, _INDEX(2)), builder.add(beside, stride)
        _incoming(
            [
                (k, _INDEX(0), after),
                (here, _INDEX(0), there),
                *zip(sums, [zero] * (2 * blocks), even + odd, strict=True),
            ],
            before,
            loop,
        )
        builder.cbranch(builder.icmp_signed("<", after, pairs), loop, paired)
        builder.position_at_end(paired)
        place_here = builder.phi(_INDEX)
        joined = [builder.phi(_VECTOR) for _ in range(2 * blocks)]
        _incoming(
            [
                (place_here, _INDEX(0), there),
                *zip(joined, [zero] * (2 * blocks), even + odd, strict=True),
            ],
            before,
            loop,
        )
        totals = [builder.fadd(a, b) for a, b in zip(joined[:blocks], joined[blocks:], strict=True)]
        builder.cbranch(builder.icmp_signed("<", pairs, count), single, end)
        builder.position_at_end(single)
        last = column(pairs, place_here, totals)
        builder.branch(end)
        builder.position_at_end(end)
        results = [builder.phi(_VECTOR) for _ in places]
        _incoming(list(zip(results, totals, last, strict=True)), paired, single)
        for result, place in zip(results, places, strict=True):
            builder.store(result, _lanes(builder, out, place), align=8)

    def _incoming(phis, first, second):
        for phi, one, other in phis:
            phi.add_incoming(one, first)
            phi.add_incoming(other, second)

    @intrinsic
    def linear(typing, table, at, stride, rows, count, x, first, out, to):
        whole = types.int64
        signature = types.void(table, whole, whole, whole, whole, x, whole, out, whole)

        def generate(context, builder, signature, arguments):
            table, at, stride, rows, count, x, first, out, to = arguments
            kinds = signature.args
            table = builder.gep(_pointer(context, builder, kinds[0], table), [at])
            x = builder.gep(_pointer(context, builder, kinds[5], x), [first])
            out = builder.gep(_pointer(context, builder, kinds[7], out), [to])
            builder.call(_linear_function(builder.module), [table, stride, rows, count, x, out])
            return context.get_dummy_value()

        return signature, generate

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
            return _joined(builder, last, join)

        return generate

    def _halves(builder, value, width):
        """The two halves of a vector."""
        kind = ir.VectorType(ir.IntType(32), width // 2)
        return [
            builder.shuffle_vector(value, value, ir.Constant(kind, list(range(start, start + width // 2))))
            for start in (0, width // 2)
        ]

    def _joined(builder, value, join):
        """All lanes joined to one number, half with half."""
        width = LANES
        while width > 1:
            value, width = join(builder, *_halves(builder, value, width)), width // 2
        return builder.extract_element(value, ir.IntType(32)(0))

    def _larger(builder, a, b):
        kind = ir.FunctionType(a.type, [a.type, a.type])
        name = f"llvm.maximum.v{a.type.count}f64"
        return builder.call(builder.module.declare_intrinsic(name, (), kind), [a, b])

    def _extreme(test):
        """The extreme of `MASKED` values; NaN may get lost."""

        def generate(context, builder, signature, arguments):
            pointer = _pointer(context, builder, signature.args[0], arguments[0])
            value = _load(builder, pointer, arguments[1])
            for first in range(LANES, MASKED, LANES):
                other = _load(builder, pointer, builder.add(arguments[1], _INDEX(first)))
                value = choose(builder, value, other)
            return _joined(builder, value, choose)

        def choose(builder, a, b):
            return builder.select(builder.fcmp_ordered(test, a, b), a, b)

        return generate

    def _blockwise(combine, factor):
        """target ← combine(builder, factor, source, target), block by block; count is a multiple of
        eight."""

        def generate(context, builder, signature, arguments):
            scalar = _splat(builder, arguments[0]) if factor else None
            source, at, target, to, count = arguments[-5:]
            source = _pointer(context, builder, signature.args[-5], source)
            target = _pointer(context, builder, signature.args[-3], target)
            before = builder.block
            loop, end = (builder.append_basic_block(name) for name in ("blocks", "done"))
            builder.cbranch(builder.icmp_signed(">", count, _INDEX(0)), loop, end)
            builder.position_at_end(loop)
            k = builder.phi(_INDEX)
            place = _lanes(builder, target, builder.add(to, k))
            value = _load(builder, source, builder.add(at, k))
            builder.store(combine(builder, scalar, value, place), place, align=8)
            after = builder.add(k, _INDEX(LANES))
            k.add_incoming(_INDEX(0), before)
            k.add_incoming(after, loop)
            builder.cbranch(builder.icmp_signed("<", after, count), loop, end)
            builder.position_at_end(end)
            return context.get_dummy_value()

        return generate

    def _places(source, target):
        return (source, types.int64, target, types.int64, types.int64)

    @intrinsic
    def move(typing, source, at, target, to, count):
        signature = types.void(*_places(source, target))
        return signature, _blockwise(lambda builder, factor, value, place: value, False)

    @intrinsic
    def times(typing, factors, at, values, to, count):
        def combine(builder, factor, value, place):
            return builder.fmul(builder.load(place, align=8), value)

        return types.void(*_places(factors, values)), _blockwise(combine, False)

    @intrinsic
    def multiple(typing, factor, source, at, target, to, count):
        def combine(builder, factor, value, place):
            return builder.fmul(factor, value)

        return types.void(types.float64, *_places(source, target)), _blockwise(combine, True)

    @intrinsic
    def add(typing, factor, source, at, target, to, count):
        def combine(builder, factor, value, place):
            return _call(builder, "llvm.fma.v8f64", [factor, value, builder.load(place, align=8)])

        return types.void(types.float64, *_places(source, target)), _blockwise(combine, True)

    @intrinsic
    def least(typing, values, at):
        return types.float64(values, types.int64), _extreme("<")

    @intrinsic
    def greatest(typing, values, at):
        return types.float64(values, types.int64), _extreme(">")

    @intrinsic
    def peak(typing, values, at, count):
        signature = types.float64(values, types.int64, types.int64)
        return signature, _reduction("largest", _larger, weighted=False)

    @intrinsic
    def weigh(typing, weights, at, count, x, first):
        signature = types.float64(weights, types.int64, types.int64, x, types.int64)
        return signature, _reduction("weighed", lambda builder, a, b: builder.fadd(a, b), weighted=True)

    def _powers(builder, power):
        """1, s, s², … block by block."""
        block = None
        for bit in range(3):  # s, s², s⁴ where that bit of the lane's number is set
            chosen = [ir.IntType(1)(lane >> bit & 1) for lane in range(LANES)]
            mask = ir.Constant(ir.VectorType(ir.IntType(1), LANES), chosen)
            factor = builder.select(mask, _splat(builder, power), ir.Constant(_VECTOR, [1.0] * LANES))
            block = factor if block is None else builder.fmul(block, factor)
            power = builder.fmul(power, power)
        for first in range(0, MASKED, LANES):
            yield first, block
            block = builder.fmul(block, _splat(builder, power))  # by s⁸

    @intrinsic
    def powers(typing, s, out, to):
        def generate(context, builder, signature, arguments):
            pointer = _pointer(context, builder, signature.args[1], arguments[1])
            for first, block in _powers(builder, arguments[0]):
                place = _lanes(builder, pointer, builder.add(arguments[2], _INDEX(first)))
                builder.store(block, place, align=8)
            return context.get_dummy_value()

        return types.void(types.float64, out, types.int64), generate

    @intrinsic
    def powered(typing, s, values, at, less, out, powers_to, to):
        whole = types.int64
        signature = types.void(types.float64, values, whole, types.float64, out, whole, whole)

        def generate(context, builder, signature, arguments):
            s, values, at, less, out, powers_to, to = arguments
            values = _pointer(context, builder, signature.args[1], values)
            out = _pointer(context, builder, signature.args[4], out)
            for first, block in _powers(builder, s):
                value = _load(builder, values, builder.add(at, _INDEX(first)))
                if first == 0:
                    zero = ir.Constant(_VECTOR, [0.0] * LANES)
                    value = builder.fsub(value, builder.insert_element(zero, less, ir.IntType(32)(0)))
                for place, result in ((powers_to, block), (to, builder.fmul(block, value))):
                    there = _lanes(builder, out, builder.add(place, _INDEX(first)))
                    builder.store(result, there, align=8)
            return context.get_dummy_value()

        return signature, generate

    @intrinsic
    def lead_back(typing, factor, scale, change, centres, before, after, u, count):
        whole, number = types.int64, types.float64
        signature = types.void(number, number, change, centres, whole, whole, u, whole)

        def generate(context, builder, signature, arguments):
            factor, scale, change, centres, before, after, u, count = arguments
            factor, scale = _splat(builder, factor), _splat(builder, scale)
            change = _pointer(context, builder, signature.args[2], change)
            centres = _pointer(context, builder, signature.args[3], centres)
            u = _pointer(context, builder, signature.args[6], u)
            start, loop, end = builder.block, *map(builder.append_basic_block, ("lead", "led"))
            builder.cbranch(builder.icmp_signed(">", count, _INDEX(0)), loop, end)
            builder.position_at_end(loop)
            k = builder.phi(_INDEX)
            place = _lanes(builder, u, k)
            moved = builder.fmul(scale, _load(builder, change, k))
            moved = _call(builder, "llvm.fma.v8f64", [factor, moved, builder.load(place, align=8)])
            moved = builder.fadd(moved, _load(builder, centres, builder.add(before, k)))
            moved = builder.fsub(moved, _load(builder, centres, builder.add(after, k)))
            builder.store(moved, place, align=8)
            following = builder.add(k, _INDEX(LANES))
            k.add_incoming(_INDEX(0), start)
            k.add_incoming(following, loop)
            builder.cbranch(builder.icmp_signed("<", following, count), loop, end)
            builder.position_at_end(end)
            return context.get_dummy_value()

        return signature, generate

    def _mask(test):
        """Bit i: whether ``test`` holds between value i and the limit; NaN never does."""

        def generate(context, builder, signature, arguments):
            pointer = _pointer(context, builder, signature.args[0], arguments[0])
            limit, mask = _splat(builder, arguments[2]), _INDEX(0)
            for first in range(0, MASKED, LANES):
                value = _load(builder, pointer, builder.add(arguments[1], _INDEX(first)))
                bits = builder.bitcast(builder.fcmp_ordered(test, value, limit), ir.IntType(LANES))
                mask = builder.or_(mask, builder.shl(builder.zext(bits, _INDEX), _INDEX(first)))
            return mask

        return generate

    @intrinsic
    def over(typing, values, at, limit):
        return types.int64(values, types.int64, types.float64), _mask(">")

    @intrinsic
    def under(typing, values, at, limit):
        return types.int64(values, types.int64, types.float64), _mask("<")

    def _every(test):
        """Whether ``test`` holds between all values of a block and the limit."""

        def generate(context, builder, signature, arguments):
            pointer = _pointer(context, builder, signature.args[0], arguments[0])
            value, limit = _load(builder, pointer, arguments[1]), _splat(builder, arguments[2])
            bits = builder.bitcast(builder.fcmp_ordered(test, value, limit), ir.IntType(LANES))
            return builder.icmp_unsigned("==", bits, ir.IntType(LANES)(2**LANES - 1))

        return generate

    @intrinsic
    def all_over(typing, values, at, limit):
        return types.boolean(values, types.int64, types.float64), _every(">")

    @intrinsic
    def all_under(typing, values, at, limit):
        return types.boolean(values, types.int64, types.float64), _every("<")

    @intrinsic
    def ones_in(typing, mask):
        def generate(context, builder, signature, arguments):
            kind = ir.FunctionType(_INDEX, [_INDEX])
            return builder.call(builder.module.declare_intrinsic("llvm.ctpop.i64", (), kind), arguments)

        return types.int64(types.int64), generate
