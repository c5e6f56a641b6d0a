"""Memory for the arrays that kernels make: numba's run-time library in as far as they use it, from C's
malloc, so that machine code needs nothing of numba. Imported for compiling only."""

from __future__ import annotations

from llvmlite import ir

WORD, INT, POINTER = ir.IntType(64), ir.IntType(32), ir.IntType(8).as_pointer()
HEAD = 48  # bytes of numba's MemInfo: references, destructor, its argument, data, size, allocator
DATA = 3  # word of it


def write_memory(module: ir.Module) -> None:
    """Adds what numba's machine code calls: one block for head and data, freed with its last reference."""
    malloc = ir.Function(module, ir.FunctionType(POINTER, [WORD]), "malloc")
    free = ir.Function(module, ir.FunctionType(ir.VoidType(), [POINTER]), "free")
    builder, (size, alignment) = _function(module, "NRT_MemInfo_alloc_aligned", POINTER, [WORD, INT])
    alignment = builder.zext(alignment, WORD)
    block = builder.call(malloc, [builder.add(builder.add(size, alignment), WORD(HEAD))])
    with builder.if_then(builder.icmp_unsigned("==", block, ir.Constant(POINTER, None)), likely=False):
        builder.ret(block)
    behind = builder.add(builder.ptrtoint(block, WORD), builder.add(alignment, WORD(HEAD - 1)))
    data = builder.and_(behind, builder.not_(builder.sub(alignment, WORD(1))))
    words = builder.bitcast(block, WORD.as_pointer())
    for place, value in enumerate([WORD(1), WORD(0), WORD(0), data, size, WORD(0)]):
        builder.store(value, builder.gep(words, [WORD(place)]))
    builder.ret(block)
    for name in ("NRT_MemInfo_call_dtor", "NRT_Free"):
        builder, (block,) = _function(module, name, ir.VoidType(), [POINTER])
        builder.call(free, [block])
        builder.ret_void()


def _function(
    module: ir.Module, name: str, result: ir.Type, arguments: list[ir.Type]
) -> tuple[ir.IRBuilder, tuple[ir.Argument, ...]]:
    function = ir.Function(module, ir.FunctionType(result, arguments), name)
    function.linkage = "weak_odr"  # once in a process, and kept before anything refers to it
    return ir.IRBuilder(function.append_basic_block("entry")), function.args
