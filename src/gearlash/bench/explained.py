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
        "The article's pair at 1-1; amplitudes fall as 1/k². The cells follow the highest harmonic "
        f"({curve.cells[0]} to {curve.cells[-1]}), so that each is resolved to rounding, and every cell "
        f"costs the same: {_micro(curve.seconds[0])} to {_micro(curve.seconds[-1])} µs, "
        f"{1e9 * _slope(curve.cells, curve.seconds):.0f} ns a cell. "
        "The series themselves are summed while building only, and inside a cell with a crossing."
    )


def _states(curve: Curve) -> str:
    first, last = _micro(curve.seconds[0]), _micro(curve.seconds[-1])
    power = _slope(np.log(curve.sizes), np.log(curve.seconds))
    upper = len(curve.sizes) // 2
    late = _slope(np.log(curve.sizes[upper:]), np.log(curve.seconds[upper:])) if upper > 1 else power
    return (
        f"A map has n² numbers. From {curve.sizes[0]:.0f} to {curve.sizes[-1]:.0f} states a period goes from "
        f"{first} to {last} µs, as n to the power {power:.2f}, and {late:.2f} over the larger half: among "
        "small systems what does not depend on n weighs most."
    )


def _clearances(curve: Curve) -> str:
    pairs = zip(curve.sizes, curve.seconds, curve.crossings, strict=True)
    listed = ", ".join(f"{size:.0f}: {_micro(s)} µs with {c:.1f} crossings" for size, s, c in pairs)
    return (
        f"Three masses in a row, of which so many have play (the others are glued to their stops). {listed}."
    )


def _impacts(curve: Curve) -> str:
    first, each = _micro(curve.seconds[0]), 1e6 * _slope(curve.sizes, curve.seconds)
    return (
        f"One degree of freedom in {curve.cells[0]} cells, and less and less load: a period with "
        f"{curve.sizes[0]:.3g} impacts takes {first} µs, and each impact with its release adds {each:.2f} "
        "µs: two crossings located, the state moved to another region at each."
    )


def _speeds(curve: Curve) -> str:
    quiet = [
        f"{s:g}: {_micro(t)} µs, {cells} cells"
        for s, t, cells, c in zip(curve.sizes, curve.seconds, curve.cells, curve.crossings, strict=True)
        if c == 0.0
    ]
    return (
        "The article's pair. A slow period is long and has many cells; a fast one has few, and then the "
        "harmonics of the forcing decide their number and no longer the natural frequencies. Without "
        f"crossings: {'; '.join(quiet) or 'none of these'}. Where teeth hit, crossings outweigh cells, and "
        "the curve jumps."
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
