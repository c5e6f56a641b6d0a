"""`gearlash bench`: gearlash and other solvers on the same work."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from gearlash.bench import Benchmark


@dataclass(frozen=True)
class BenchAnswer:
    """Times, ratios and errors of gearlash and other solvers (gearlash bench)."""

    sentence: str
    benchmark: Benchmark
    result: Literal["bench"] = "bench"


def bench_answer(found: Benchmark) -> BenchAnswer:
    """The record of a run."""
    judged = [bar for bar in found.bars if bar.met is not None]
    met = sum(bool(bar.met) for bar in judged)
    sentence = f"{met} of {len(judged)} bars met"
    if len(judged) < len(found.bars):
        sentence += f", {len(found.bars) - len(judged)} not measured"
    return BenchAnswer(sentence + (" (quick: the times mean little)" if found.quick else ""), found)
