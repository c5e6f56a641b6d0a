"""The page of the documentation about a run, Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from gearlash.flow import ROUGH, TERMS

from .explained import sizes_explained
from .pixels import REPEATS as MAP_REPEATS
from .results import OWN, Benchmark, Limit, Row
from .words import NOTHING, aim, error, measured, ratio, time, verdict
from .works import MANY_PERIODS, SPREAD, TOGETHER

FIGURE = "images/benchmark-cost.png"
HEAD = """\
# Benchmarks

Written by `make bench`; do not edit. gearlash and other solvers do the same work in one
run on one machine, one core unless it says otherwise.
"""
PROTOCOL = """\
## How it is measured

All take turns, A B A B, {repeats} times after one call to warm up (branches and the map {mapped} times,
start-up five, a first run and `reproduce` once). A time is the median of the repeats; a ratio is the median
of the ratios within each repeat, so that a slow spell of the machine meets both sides, and the least of them
stands beside a bar. From run to run ratios differ by some 10 to 20 % on a shared machine: a bar met or
missed by less is neither for sure. The limit and the curves of cost take the least time of the repeats.

Building a model, compiling and settling on the attractor are not timed, but in the map, where gearlash
builds its propagators anew for every pixel, where a grazing is located, at every speed that it tries, and
along a branch. A
first run compiles on two cores and `reproduce` works on all; all else has one. A first run compiles what
`run` needs, which the kernel of `march_many` is not; that is compiled when first called.

One trajectory runs on the attractor, thousands of periods in one call (ten for those that call Python at
every evaluation). Many are {together} motions from states scattered by {spread:g} about the attractor
(without impacts: by so little that none occur), over {periods} periods: on a stable orbit they would soon
be one and the same motion, and lanes that all turn the same way measure nothing. All march all of them.
Contact of teeth in space is the kernel of the multibody model: forces on both bodies from one pose.
Errors are largest ones over one period, of one trajectory from up to 100 states of the attractor (a
period-one orbit has one), against heyoka's Taylor method in 80-bit arithmetic with tolerance 1e-20, an
integrator that shares nothing with gearlash; for heyoka's own rows it is the same code with more digits.
Errors of some 1e-16 are rounding and rank nobody.

gearlash's certificate is on: every cell without a crossing is proved to have none. heyoka's callbacks at
crossings are Python, as its users write them.
"""
MISSED = """\
Two more compiled solvers were tried and are not in the table: numbalsoda has no wheel for Python 3.11 or
newer, and numbakit-ode fails to start with current versions of scipy.
"""
LIMIT = """\
## The limit

By this method, in these cells, a period is at the least one affine map a cell, to the state behind it and
to the {rough} coefficients that prove it clear: (n + {rough})(n + 1) multiply-adds, and as many numbers to
read; where nothing is ever touched, one map of the state for all of it. A crossing is, in its cell, {terms}
coefficients before it and behind it, the gap as a series, its moments, and what they do to the state:
{terms} (3(n + 1) + {terms} + n). Another method may need less: this is no bound on those. Everything beyond
it is reading the proof, finding roots, and overhead. The peak is that of this core, measured by a loop of
nothing but multiply-adds ({peak:.1f} billion a second); reading is measured on a table of the size of each
({slowest:.0f} to {fastest:.0f} GB/s). *Least* is the longer of arithmetic at the peak and reading at that
speed; *share* is necessary arithmetic over peak. Times are the least
of the repeats; of many, crossings are counted as on the attractor.
"""
BRANCH = """\
A point of gearlash's branch has its certificate, its label, every extremum followed from orbit to orbit, and
the special points between are solved for, whose orbits count as time and not as points; the loop on heyoka
has orbits, multipliers and extrema. Its code is compiled once for all values of the parameter, where
gearlash builds the propagators of every new speed; what they cost, and the rest, is in the table, each part
timed alone. Where load, error or gap is the parameter only sums are renewed.
"""
MAP = """\
Every pixel starts cold. gearlash's row gives label and largest exponent, from the equations on; heyoka's
gives the label after 500 periods and no exponent, and a motion that has not settled by then gets a wrong
one. What the time goes to is at the end of the table: every pixel is another system, whose propagators are
used for some hundred periods only, and whether an exponent is above zero takes a thousand periods to say.
The first two parts were timed alone, as they are today and not as they might be; all else is Newton's
method, the proofs of stability and period, and the search's decisions, which are Python. No motion is called
aperiodic before a thousand periods: compare what these cost with what thirty times heyoka would leave for
everything.
"""


def page(found: Benchmark) -> str:
    """The whole page."""
    parts = [
        HEAD,
        "\n".join(_machine(found)),
        "\n".join(_bars(found)),
        PROTOCOL.format(
            repeats=found.repeats,
            mapped=MAP_REPEATS,
            together=TOGETHER,
            spread=SPREAD,
            periods=MANY_PERIODS,
        ),
    ]
    parts += ["\n".join(_solvers(found.rows)), MISSED]
    for task in dict.fromkeys(row.task for row in found.rows if row.task != "start-up"):
        parts.append("\n".join(_task(task, [row for row in found.rows if row.task == task])))
    parts += [BRANCH, _facts("of one point of a branch, P = 1", found.branch)]
    parts += [MAP, _facts("of the map", found.pixels), _facts("two threads over one", found.threads)]
    parts += ["\n".join(_starts(found.rows)), f"## Cost against size\n\n![cost of a period]({FIGURE})"]
    parts += list(sizes_explained(found.curves))
    parts.append("\n".join(_limit(found.limits)))
    return "\n\n".join(part.strip() for part in parts) + "\n"


def _machine(found: Benchmark) -> Iterator[str]:
    if found.quick:
        yield "**A quick run: small work, few repeats. The times mean little.**\n"
    machine = found.machine
    yield f"{machine.processor}, {machine.cores} cores, {machine.system}, Python {machine.python}."
    yield ", ".join(f"{name} {version}" for name, version in machine.versions.items()) + "."
    yield f"The run took {found.seconds:.0f} s."


def _bars(found: Benchmark) -> Iterator[str]:
    yield "## Bars\n"
    yield from _table(
        ("bar", "aim", "here", "", "worst at, or why not"),
        [(b.sentence, aim(b), measured(b), verdict(b), b.where) for b in found.bars],
    )


def _solvers(rows: Iterable[Row]) -> Iterator[str]:
    """How each was used, once a task."""
    yield "| solver | task | used with |"
    yield "|---|---|---|"
    for solver, task, how in dict.fromkeys((r.solver, r.task, r.how) for r in rows if r.how):
        yield f"| {solver} | {task} | {how} |"


def _task(task: str, rows: Sequence[Row]) -> Iterator[str]:
    yield f"## {task[0].upper()}{task[1:]}\n"
    head = (
        "work",
        "solver",
        f"time per {rows[0].unit}",
        "× gearlash",
        "error",
        "error of crossing times",
        "",
    )
    cells, before = [], ""
    for r in rows:
        work, before = "" if r.work == before else r.work, r.work
        solver = f"**{OWN}**" if r.solver == OWN else r.solver
        cells.append(
            (work, solver, time(r.seconds), ratio(r.ratio), error(r.error), error(r.time_error), r.note)
        )
    used = [k for k in range(len(head)) if any(row[k] not in ("", NOTHING) for row in cells)]
    yield from _table([head[k] for k in used], [[row[k] for k in used] for row in cells])


def _starts(rows: Iterable[Row]) -> Iterator[str]:
    yield "## Start-up\n"
    yield "New processes, kernels compiled before where nothing else is said.\n"
    yield from _table(("process", "time"), [(r.work, time(r.seconds)) for r in rows if r.task == "start-up"])


def _facts(title: str, facts: dict[str, float]) -> str:
    return "\n".join(_table((title, ""), [(name, f"{value:.4g}") for name, value in facts.items()]))


def _limit(limits: Sequence[Limit]) -> Iterator[str]:
    yield LIMIT.format(
        rough=ROUGH,
        terms=TERMS,
        peak=limits[0].peak / 1e9,
        slowest=min(x.bandwidth for x in limits) / 1e9,
        fastest=max(x.bandwidth for x in limits) / 1e9,
    )
    head = (
        "work", "states", "cells", "crossings", "multiply-adds: maps", "crossings", "table", "least", "took",
        "times least", "share of peak", "one of many took", "share of peak",
    )  # fmt: skip
    yield from _table(
        head,
        [
            (
                x.work, str(x.states), str(x.cells), f"{x.crossings:.2f}", f"{x.multiply_adds:,.0f}",
                f"{x.crossing_multiply_adds:,.0f}", f"{x.table_bytes / 1024:.0f} KiB", time(x.least),
                time(x.seconds), f"{x.seconds / x.least:.1f}", f"{100 * x.share:.1f} %",
                time(x.seconds_together), f"{100 * x.share_together:.1f} %",
            )
            for x in limits
        ],
    )  # fmt: skip


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    yield f"| {' | '.join(head)} |"
    yield "|" + "---|" * len(head)
    for row in rows:
        yield f"| {' | '.join(row)} |"
