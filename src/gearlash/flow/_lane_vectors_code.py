"""The primitives of `_lane_vectors` as LLVM's own vector instructions. Imported for compiling only."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._blocks import LANES, MASKED, ROWS

if not TYPE_CHECKING:
    from llvmlite import ir
    from numba import types
    from numba.extending import intrinsic

    from ._vector_code import _INDEX, _VECTOR, _call, _lanes, _load, _pointer, _product, _splat

    _BITS = ir.IntType(LANES)
    _ZERO = ir.Constant(_VECTOR, [0.0] * LANES)

    def _pointers(context, builder, signature, arguments, *places):
        return [_pointer(context, builder, signature.args[i], arguments[i]) for i in places]

    def _fma(builder, a, b, c):
        return _call(builder, "llvm.fma.v8f64", [a, b, c])

    def _row(builder, pointer, i):
        return _load(builder, pointer, _INDEX(LANES * i))

    def _from_row(builder, pointer, row):
        return builder.gep(pointer, [builder.mul(row, _INDEX(LANES))])

    def _keep(builder, value, pointer, i):
        builder.store(value, _lanes(builder, pointer, _INDEX(LANES * i)), align=8)

    def _loop(builder, count, body, first=()):
        """values = body(k, values) for k below ``count``, which is above zero, from the ``first`` ones on."""
        before, inside = builder.block, builder.append_basic_block("rows")
        behind = builder.append_basic_block("behind")
        builder.branch(inside)
        builder.position_at_end(inside)
        k, values = builder.phi(_INDEX), [builder.phi(value.type) for value in first]
        found = body(k, values) or ()
        after = builder.add(k, _INDEX(1))
        starts, ends = [_INDEX(0), *first], [after, *found]
        for phi, start, end in zip([k, *values], starts, ends, strict=True):
            phi.add_incoming(start, before)
            phi.add_incoming(end, builder.block)
        builder.cbranch(builder.icmp_signed("<", after, count), inside, behind)
        builder.position_at_end(behind)
        return found

    def _function(module, name, kinds, write):
        """A machine function, once in a module."""
        if name in module.globals:
            return module.globals[name]
        function = ir.Function(module, ir.FunctionType(ir.VoidType(), kinds), name)
        function.linkage = "linkonce_odr"
        for attribute in ("noinline", "nounwind", "optsize"):
            function.attributes.add(attribute)
        builder = ir.IRBuilder(function.append_basic_block("entry"))
        write(builder, *function.args)
        builder.ret_void()
        return function

    def _write_linear(builder, table, stride, rows, count, x, out):
        def block(number, _):
            row = builder.mul(number, _INDEX(ROWS))
            into = builder.gep(out, [builder.mul(row, _INDEX(LANES))])
            _product(builder, ROWS, builder.gep(table, [row]), stride, count, x, into, in_lanes=True)

        _loop(builder, builder.sdiv(rows, _INDEX(ROWS)), block)

    @intrinsic
    def linear_lanes(typing, table, at, stride, rows, count, x, first, out, to):
        whole = types.int64
        signature = types.void(table, whole, whole, whole, whole, x, whole, out, whole)

        def generate(context, builder, signature, arguments):
            _, at, stride, rows, count, _, first, _, to = arguments
            table, x, out = _pointers(context, builder, signature, arguments, 0, 5, 7)
            x, out = _from_row(builder, x, first), _from_row(builder, out, to)
            pointer = _VECTOR.element.as_pointer()
            kinds = [pointer, _INDEX, _INDEX, _INDEX, pointer, pointer]
            function = _function(builder.module, "gearlash_linear_lanes", kinds, _write_linear)
            builder.call(function, [builder.gep(table, [at]), stride, rows, count, x, out])
            return context.get_dummy_value()

        return signature, generate

    def _write_weigh(builder, weights, count, x, out):
        def block(number, terms):
            first = builder.mul(number, _INDEX(LANES))
            rows = builder.gep(x, [builder.mul(first, _INDEX(LANES))])
            found = []
            for i, term in enumerate(terms):
                weight = builder.load(builder.gep(weights, [builder.add(first, _INDEX(i))]))
                size = _call(builder, "llvm.fabs.v8f64", [_row(builder, rows, i)])
                found.append(_fma(builder, _splat(builder, weight), size, term))
            return found

        terms = _loop(builder, builder.sdiv(count, _INDEX(LANES)), block, [_ZERO] * LANES)
        while len(terms) > 1:  # half with half, as in `_vector.weigh`
            half = len(terms) // 2
            terms = [builder.fadd(a, b) for a, b in zip(terms[:half], terms[half:], strict=True)]
        _keep(builder, terms[0], out, 0)

    @intrinsic
    def weigh_lanes(typing, weights, at, count, x, first, out):
        def generate(context, builder, signature, arguments):
            weights, x, out = _pointers(context, builder, signature, arguments, 0, 3, 5)
            x = _from_row(builder, x, arguments[4])
            pointer = _VECTOR.element.as_pointer()
            kinds = [pointer, _INDEX, pointer, pointer]
            function = _function(builder.module, "gearlash_weigh_lanes", kinds, _write_weigh)
            builder.call(function, [builder.gep(weights, [arguments[1]]), arguments[2], x, out])
            return context.get_dummy_value()

        return types.void(weights, types.int64, types.int64, x, types.int64, out), generate

    @intrinsic
    def bounds_lanes(typing, place, sign, near, more, out):
        def generate(context, builder, signature, arguments):
            near, out = _pointers(context, builder, signature, arguments, 2, 4)
            place, sign, _, more, _ = arguments
            size = builder.fadd(_row(builder, near, 0), _splat(builder, more))
            size = builder.fmul(_splat(builder, sign), size)
            _keep(builder, builder.fadd(_splat(builder, place), size), out, 0)
            return context.get_dummy_value()

        number = types.float64
        return types.void(number, number, near, number, out), generate

    @intrinsic
    def difference_lanes(typing, table, at, x, first, out, rows):
        def generate(context, builder, signature, arguments):
            table, x, out = _pointers(context, builder, signature, arguments, 0, 2, 4)
            _, at, _, first, _, rows = arguments
            table, x = builder.gep(table, [at]), _from_row(builder, x, first)

            def row(k, _):
                value = _splat(builder, builder.load(builder.gep(table, [k])))
                place = builder.mul(k, _INDEX(LANES))
                value = builder.fsub(_load(builder, x, place), value)
                builder.store(value, _lanes(builder, out, place), align=8)

            _loop(builder, rows, row)
            return context.get_dummy_value()

        whole = types.int64
        return types.void(table, whole, x, whole, out, whole), generate

    @intrinsic
    def lead_back_lanes(typing, factor, scale, change, centres, before, after, u, rows):
        def generate(context, builder, signature, arguments):
            scale, change, centres, u = _pointers(context, builder, signature, arguments, 1, 2, 3, 6)
            factor, _, _, _, before, after, _, rows = arguments
            factor, scale = _splat(builder, factor), _row(builder, scale, 0)
            before, after = builder.gep(centres, [before]), builder.gep(centres, [after])

            def row(k, _):
                there = builder.mul(k, _INDEX(LANES))
                place = _lanes(builder, change, there)
                moved = builder.fmul(scale, builder.load(place, align=8))
                moved = _fma(builder, factor, moved, _load(builder, u, there))
                moved = builder.fadd(moved, _splat(builder, builder.load(builder.gep(before, [k]))))
                moved = builder.fsub(moved, _splat(builder, builder.load(builder.gep(after, [k]))))
                builder.store(moved, place, align=8)

            _loop(builder, rows, row)
            return context.get_dummy_value()

        whole, number = types.int64, types.float64
        return types.void(number, scale, change, centres, whole, whole, u, whole), generate

    def _every(test):
        """Mask of the motions of which ``test`` holds between all values and the limit."""

        def generate(context, builder, signature, arguments):
            values, limits = _pointers(context, builder, signature, arguments, 0, 2)
            first = _from_row(builder, values, arguments[1])
            limit, masks = _row(builder, limits, 0), []
            for i in range(LANES):
                bits = builder.bitcast(builder.fcmp_ordered(test, _row(builder, first, i), limit), _BITS)
                masks.append(builder.zext(bits, _INDEX))
            while len(masks) > 1:  # pair by pair: none waits for all before it
                pairs = zip(masks[::2], masks[1::2], strict=False)
                masks = [builder.and_(a, b) for a, b in pairs] + masks[len(masks) & ~1 :]
            return masks[0]

        return generate

    @intrinsic
    def over_lanes(typing, values, at, limits):
        return types.int64(values, types.int64, limits), _every(">")

    @intrinsic
    def under_lanes(typing, values, at, limits):
        return types.int64(values, types.int64, limits), _every("<")

    @intrinsic
    def choose(typing, mask, source, target, to, rows):
        def generate(context, builder, signature, arguments):
            source, target = _pointers(context, builder, signature, arguments, 1, 2)
            target = _from_row(builder, target, arguments[3])
            bits = builder.bitcast(builder.trunc(arguments[0], _BITS), ir.VectorType(ir.IntType(1), LANES))

            def row(k, _):
                at = builder.mul(k, _INDEX(LANES))
                place = _lanes(builder, target, at)
                chosen = builder.select(bits, _load(builder, source, at), builder.load(place, align=8))
                builder.store(chosen, place, align=8)

            _loop(builder, arguments[4], row)
            return context.get_dummy_value()

        return types.void(types.int64, source, target, types.int64, types.int64), generate

    def _turned(builder, rows):
        """Eight vectors with lines and columns exchanged: in three steps, each exchanging blocks of half the
        size."""
        width = LANES // 2
        while width:
            turned = list(rows)
            for i in range(LANES):
                if i & width:
                    continue
                low = [j if not j & width else LANES + j - width for j in range(LANES)]
                high = [j + width if not j & width else LANES + j for j in range(LANES)]
                for place, order in ((i, low), (i + width, high)):
                    shuffle = ir.Constant(ir.VectorType(ir.IntType(32), LANES), order)
                    turned[place] = builder.shuffle_vector(rows[i], rows[i + width], shuffle)
            rows, width = turned, width // 2
        return rows

    def _write_apart(builder, values, rows, out):
        def block(number, _):
            first = builder.mul(number, _INDEX(LANES))
            source = builder.gep(values, [builder.mul(first, _INDEX(LANES))])
            for motion, value in enumerate(
                _turned(builder, [_row(builder, source, i) for i in range(LANES)])
            ):
                place = builder.add(builder.mul(rows, _INDEX(motion)), first)
                builder.store(value, _lanes(builder, out, place), align=8)

        _loop(builder, builder.sdiv(rows, _INDEX(LANES)), block)

    @intrinsic
    def apart(typing, values, at, rows, out):
        def generate(context, builder, signature, arguments):
            values, out = _pointers(context, builder, signature, arguments, 0, 3)
            values = _from_row(builder, values, arguments[1])
            pointer = _VECTOR.element.as_pointer()
            function = _function(builder.module, "gearlash_apart", [pointer, _INDEX, pointer], _write_apart)
            builder.call(function, [values, arguments[2], out])
            return context.get_dummy_value()

        return types.void(values, types.int64, types.int64, out), generate

    @intrinsic
    def powers_lanes(typing, s, out):
        def generate(context, builder, signature, arguments):
            s, out = _pointers(context, builder, signature, arguments, 0, 1)
            factors = [_row(builder, s, 0)]
            while len(factors) < 4:  # s, s², s⁴, s⁸
                factors.append(builder.fmul(factors[-1], factors[-1]))
            rows = []
            for i in range(MASKED):
                if i >= LANES:
                    rows.append(builder.fmul(rows[i - LANES], factors[3]))
                    continue
                chosen = [factor for bit, factor in enumerate(factors[:3]) if i >> bit & 1]
                row = ir.Constant(_VECTOR, [1.0] * LANES) if not chosen else chosen[0]
                for factor in chosen[1:]:
                    row = builder.fmul(row, factor)
                rows.append(row)
            for i, row in enumerate(rows):
                _keep(builder, row, out, i)
            return context.get_dummy_value()

        return types.void(s, out), generate

    def _write_values(builder, c, s, out):
        s, value = _row(builder, s, 0), _row(builder, c, MASKED - 1)
        for j in range(MASKED - 2, -1, -1):
            value = _fma(builder, value, s, _row(builder, c, j))
        _keep(builder, value, out, 0)

    def _polynomials(name, write):
        """A machine function of the polynomials, the places and the results."""

        def generate(context, builder, signature, arguments):
            pointers = _pointers(context, builder, signature, arguments, 0, 1, 2)
            kinds = [_VECTOR.element.as_pointer()] * 3
            builder.call(_function(builder.module, name, kinds, write), pointers)
            return context.get_dummy_value()

        return generate

    @intrinsic
    def values_lanes(typing, c, s, out):
        return types.void(c, s, out), _polynomials("gearlash_values_lanes", _write_values)

    def _write_jets(builder, c, s, out):
        """Step by step what `_series.jet` does."""
        s = _row(builder, s, 0)
        parts = [[_row(builder, c, 8 * block + 7), _ZERO, _ZERO] for block in range(3)]
        for j in range(6, -1, -1):
            for block, (value, slope, bend) in enumerate(parts):
                parts[block] = [
                    _fma(builder, value, s, _row(builder, c, 8 * block + j)),
                    _fma(builder, slope, s, value),
                    _fma(builder, bend, s, slope),
                ]
        s2 = builder.fmul(s, s)
        s6 = builder.fmul(builder.fmul(s2, s2), s2)
        eight, many = (ir.Constant(_VECTOR, [factor] * LANES) for factor in (8.0, 28.0))
        power = builder.fmul(s6, s2)
        rise, curl = builder.fmul(eight, builder.fmul(s6, s)), builder.fmul(many, s6)
        for block in (1, 0):
            value, slope, bend = parts[block]
            above, climb, turn = parts[block + 1]
            inner = _fma(builder, climb, rise, builder.fmul(above, curl))
            parts[block] = [
                _fma(builder, above, power, value),
                builder.fadd(slope, _fma(builder, climb, power, builder.fmul(above, rise))),
                builder.fadd(bend, _fma(builder, turn, power, inner)),
            ]
        for i, value in enumerate(parts[0]):
            _keep(builder, value, out, i)

    @intrinsic
    def jets_lanes(typing, c, s, out):
        return types.void(c, s, out), _polynomials("gearlash_jets_lanes", _write_jets)
