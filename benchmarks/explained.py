"""What the curves of cost against size show, in words with this run's numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from .results import Curve


def sizes_explained(curves: Sequence[Curve]) -> Iterator[str]:
    """A paragraph for each curve; nothing is said of one with fewer than two points but where it ends."""
    for curve in curves:
        parts = [WORDS[curve.axis](curve)] if len(curve.sizes) > 1 else []
        if curve.note:
            parts.append(f"The curve ends: {curve.note}.")
        if parts:
            yield f"**{curve.axis[0].upper()}{curve.axis[1:]}.** {' '.join(parts)}"


def _harmonics(curve: Curve) -> str:
    return (
        "`article-first-harmonic` at 1-1; amplitudes fall as 1/k². The cells follow the highest harmonic "
        f"({curve.cells[0]} to {curve.cells[-1]}), so that each is resolved to rounding: "
        f"{_micro(curve.seconds[0])} to {_micro(curve.seconds[-1])} µs, and each further cell adds "
        f"{1e9 * _slope(curve.cells, curve.seconds):.0f} ns; the rest are the crossings. "
        "The series themselves are summed while building only, and inside a cell with a crossing."
    )


def _states(curve: Curve) -> str:
    first, last = _micro(curve.seconds[0]), _micro(curve.seconds[-1])
    power = _slope(np.log(curve.sizes), np.log(curve.seconds))
    upper = len(curve.sizes) // 2
    late = _slope(np.log(curve.sizes[upper:]), np.log(curve.seconds[upper:])) if upper > 1 else power
    return (
        "A pair at 1-1-1 with more and more bearings. A map has n² numbers. "
        f"From {curve.sizes[0]:.0f} to {curve.sizes[-1]:.0f} states a period goes from "
        f"{first} to {last} µs, as n to the power {power:.2f}, and {late:.2f} over the larger half: among "
        "small systems what does not depend on n weighs most."
    )


def _clearances(curve: Curve) -> str:
    pairs = zip(curve.sizes, curve.seconds, curve.crossings, strict=True)
    listed = ", ".join(f"{size:.0f}: {_micro(s)} µs with {c:.1f} crossings" for size, s, c in pairs)
    each = [1e6 * s / c for s, c in zip(curve.seconds, curve.crossings, strict=True) if c]
    shared = f" That is {min(each):.2g} to {max(each):.2g} µs a crossing:" if each else ""
    return (
        "Three masses in a row, shaken one after the other, of which so many have play (the others are glued "
        f"to their stops). {listed}.{shared} with several gaps every one is watched in every cell; where "
        "several are crossed in one cell, each crossing is located to see which comes first, and behind it "
        "the others are looked at again."
    )


def _impacts(curve: Curve) -> str:
    hit = [k for k, size in enumerate(curve.sizes) if size > 0.0]
    each = 1e6 * _slope([curve.sizes[k] for k in hit], [curve.seconds[k] for k in hit]) if hit[1:] else None
    slope = "" if each is None else (
        f" From then on each impact with its release adds {each:.2f} µs: two crossings located, the state "
        "moved to another region at each."
    )  # fmt: skip
    return (
        f"One degree of freedom in {curve.cells[0]} cells, and less and less load. A period with "
        f"{curve.sizes[0]:.3g} impacts takes {_micro(curve.seconds[0])} µs, as one map of all of it; the "
        f"first impacts make it go from cell to cell.{slope}"
    )


def _speeds(curve: Curve) -> str:
    quiet = [
        f"{s:g}: {_micro(t)} µs, {cells} cells"
        for s, t, cells, c in zip(curve.sizes, curve.seconds, curve.cells, curve.crossings, strict=True)
        if c == 0.0
    ]
    return (
        "The article's pair. A slow period is long and has many cells, which is what building it costs; a "
        "fast one has few, and then the harmonics of the forcing decide their number and no longer the "
        "natural frequencies. A period that touches nothing is one map of the state, whatever its cells: "
        f"{'; '.join(quiet) or 'none of these'}. Where teeth hit (filled points), it goes from cell to cell."
    )


WORDS: dict[str, Callable[[Curve], str]] = {
    "stiffness harmonics": _harmonics,
    "states": _states,
    "clearances": _clearances,
    "impacts per period": _impacts,
    "speed ω": _speeds,
}


def _slope(x, y) -> float:
    """Least squares."""
    return float(np.polyfit(np.asarray(x, dtype=float), np.asarray(y, dtype=float), 1)[0])


def _micro(seconds: float) -> str:
    return f"{1e6 * seconds:.3g}"
