"""Labels of random pixels against brute force, which knows nothing of Newton, exponents or certificates.

`python -m benchmarks.labels PIXELS PAGE` (`make bench-labels`) marches every pixel of a fixed random set
from the same cold start as the map does, for a long time, and reads the label off the last strobes. Every
disagreement is put into a class by a computation of its own."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.jobs import open_executor
from gearlash.orbits import Neutral, Orbit, Unresolved, attractor

from .peers.plain import Array
from .pixels import pixel_values
from .works import family

PERIODS, MOST = 20_000, 320_000  # base periods of brute force, and as long as it still comes closer
LONGEST = 64  # period looked for
WINDOW = 4 * LONGEST
CLOSED, CLOSING = 1e-9, 1e-3  # return, of max(1, |z|): it repeats; it may yet
SHIFTS = (1e-13, -1e-13, 3e-13, -3e-13, 1e-12, -1e-12, 3e-12)  # of the start: rounding, and little more
APERIODIC = "aperiodic"
CHANCE, LATE, ABOVE, UNDECIDED, OPEN = (
    "decided by rounding", "longer transient", "period above 64", "unresolved, and said so", "not explained",
)  # fmt: skip
LATER = (
    400_000  # base periods after which starts beside it, and what both call aperiodic, are looked at again
)
EXPLAINED = {
    CHANCE: "starts shifted by 1e-13 to 3e-12 end, "
    f"after {LATER:,} periods, some on one motion, some on the other",
    LATE: "the search stops in an irregular transient that ends later, or brute force closes only later",
    ABOVE: "brute force finds no period up to 64, the search names a longer one",
    UNDECIDED: "the search gives no label, and its reason",
    OPEN: "none of these",
}


@dataclass(frozen=True)
class Compared:
    """One pixel: both labels, base periods and seconds of the search, and of a disagreement its class;
    ``later``: the label after `LATER` periods of what both call aperiodic."""

    omega: float
    D: float
    label: str
    brute: str
    kind: str
    periods: int
    seconds: float
    why: str = ""
    figures: str = ""
    later: str = ""


def brute_force(props: Propagators, start: Array, periods: int = PERIODS) -> tuple[str, int]:
    """Label after ``periods``, or more of them while the motion still closes in; and how many there were."""
    z, used = np.array(start, dtype=np.float64), 0
    while True:
        z = flow.march(props, z, 1, periods - used).states[-1]
        used = periods
        run = flow.march(props, z, WINDOW)
        label, least = read(run.states, run.contacts)
        if label != APERIODIC or not CLOSED < least < CLOSING or 2 * periods > MOST:
            return label, used
        periods *= 2


def read(states: Array, contacts: NDArray[np.int64]) -> tuple[str, float]:
    """The label of strobes (periods+1, n) with their contacts, and the least return of them all."""
    scale = max(1.0, float(np.abs(states).max()))
    returns = [float(np.abs(states[p:] - states[:-p]).max()) / scale for p in range(1, LONGEST + 1)]
    for period, size in enumerate(returns, start=1):
        if size <= CLOSED:
            drive, back = contacts[-period:, :2].sum(axis=0)
            return f"{period}-{drive}-{back}", size
    return APERIODIC, min(returns)


def compare(values: dict[str, float]) -> Compared:
    """The search and brute force at one pixel."""
    pairs = family("article")
    start, began = pairs.start(values), perf_counter()
    found = attractor(flow.propagators(pairs.system(values)), start)
    seconds, props = perf_counter() - began, found.propagators
    kind = (
        "periodic"
        if isinstance(found, Orbit)
        else "unresolved"
        if isinstance(found, Unresolved | Neutral)
        else APERIODIC
    )
    label = str(found.label) if kind == "periodic" else kind
    brute, used = brute_force(props, start)
    why, figures = ("", "") if label == brute else explain(props, start, label, brute, used, found.message)
    later = brute_force(props, start, LATER)[0] if label == brute == APERIODIC else ""
    return Compared(
        values["omega"], values["D"], label, brute, kind, found.periods_used, seconds, why, figures, later
    )


def explain(
    props: Propagators, start: Array, label: str, brute: str, used: int, message: str
) -> tuple[str, str]:
    """The class of a disagreement, and its figures."""
    if label == "unresolved":
        return (ABOVE if "more than the" in message else UNDECIDED), message.partition(": ")[0]
    longest = max(used, LATER)
    others = Counter(brute_force(props, start * (1.0 + shift) + shift, longest)[0] for shift in SHIFTS)
    if label in others and others[label] < len(SHIFTS):
        return CHANCE, ", ".join(f"{name} {count}×" for name, count in others.most_common())
    if label == APERIODIC and APERIODIC not in others:
        return LATE, f"settled at {_settled(props, start, used):,} base periods; so do all starts beside it"
    later, more = brute_force(props, start, 10 * used)
    if later == label:
        return LATE, f"brute force gives it after {more:,} base periods"
    return OPEN, f"brute force after {more:,}: {later}; shifted starts: {dict(others)}"


def _settled(props: Propagators, start: Array, used: int) -> int:
    """When brute force had come to its orbit, to a hundred base periods."""
    run = flow.march(props, start, used // 100, 100)
    end = flow.march(props, run.states[-1], LONGEST).states
    away = np.abs(run.states[:, None] - end[None]).max(axis=2).min(axis=1)
    far = np.flatnonzero(away > CLOSING * max(1.0, float(np.abs(end).max())))
    return 100 * (int(far[-1]) + 1) if len(far) else 0


def page(found: Sequence[Compared]) -> str:
    """Markdown."""
    lines = [
        "# Labels against brute force",
        "",
        "Written by `make bench-labels`; do not edit. Random pixels of the article's (ω, D) plane, from the",
        f"cold start. Brute force marches {PERIODS:,} base periods (up to {MOST:,} while it closes in)",
        f"and reads the least period up to {LONGEST} after which strobes return within {CLOSED:.0e}; what",
        "does not is called aperiodic. A slow spiral may so be read as the number of periods in its turn.",
        "Both march with this package's own flow, which the benchmark's errors hold against heyoka: compared",
        "is the search, not the engine.",
        "",
        f"**{sum(not f.why for f in found):,} of {len(found):,} labels are equal.**",
        "",
        "| motion | pixels | base periods of the search: mean | median | ms a pixel |",
        "|---|---|---|---|---|",
        *_statistics(found),
        "",
        *_transients(found),
        "",
        "| why they differ | pixels | what that is |",
        "|---|---|---|",
        *(f"| {why} | {sum(f.why == why for f in found)} | {text} |" for why, text in EXPLAINED.items()),
        "",
        "| ω | D | search | brute force | why | figures |",
        "|---|---|---|---|---|---|",
        *(
            f"| {f.omega:.6f} | {f.D:.6f} | {f.label} | {f.brute} | {f.why} | {f.figures} |"
            for f in found
            if f.why
        ),
    ]
    return "\n".join(lines) + "\n"


def _statistics(found: Sequence[Compared]) -> Iterable[str]:
    kinds = ["all", *dict.fromkeys(f.kind for f in found)]
    for kind in kinds:
        some = [f for f in found if kind in ("all", f.kind)]
        periods = [f.periods for f in some]
        spent = 1e3 * float(np.mean([f.seconds for f in some]))
        yield f"| {kind} | {len(some)} | {np.mean(periods):,.0f} | {np.median(periods):,.0f} | {spent:.2f} |"


def _transients(found: Sequence[Compared]) -> Iterable[str]:
    both = [f for f in found if f.label == f.brute == APERIODIC]
    ended = [f for f in both if f.later != APERIODIC]
    yield f"{len(both)} pixels are aperiodic to both; {len(ended)} of them closed within {LATER:,} base"
    yield "periods: chaos that is a transient, however long. Neither `aperiodic` nor its certificate rules"
    yield "that out: it says that no contact was missed in the motion looked at."
    if ended:
        yield ""
        yield "| ω | D | ends in |"
        yield "|---|---|---|"
        yield from (f"| {f.omega:.6f} | {f.D:.6f} | {f.later} |" for f in ended)


def main(count: int, target: Path) -> None:
    """Compares so many pixels on all cores and writes the page."""
    points, found = pixel_values(count), []
    compare(points[0])  # kernels are compiled before there are workers
    with open_executor() as executor:
        for one in executor.map(compare, points):
            found.append(one)
            if len(found) % 50 == 0:
                different = sum(bool(f.why) for f in found)
                print(f"{len(found)} of {count} pixels, {different} labels differ", file=sys.stderr)
    target.write_text(page(found), encoding="utf-8")


if __name__ == "__main__":
    main(int(sys.argv[1]), Path(sys.argv[2]))
