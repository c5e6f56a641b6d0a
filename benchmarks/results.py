"""What a run of the benchmark found: rows, bars, curves, machine. Plain data, and the schema of its JSON."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

OWN = "gearlash"


@dataclass(frozen=True)
class Row:
    """One solver at one piece of work. What was not measured is null, and the note says why."""

    task: str
    work: str
    solver: str
    unit: Annotated[str, "what the times are per"]
    seconds: Annotated[float | None, "median of the repeats"] = None
    best: Annotated[float | None, "least of the repeats, seconds"] = None
    ratio: Annotated[float | None, "how many times longer than gearlash, median over the repeats"] = None
    least_ratio: Annotated[float | None, "the least of those ratios"] = None
    error: Annotated[
        float | None,
        "largest error against the reference: of a component of the state after one period "
        "(dimensionless), of a multiplier, of the value located",
    ] = None
    time_error: Annotated[float | None, "largest error of a crossing time, in τ"] = None
    how: Annotated[str, "how the solver was used"] = ""
    note: str = ""


@dataclass(frozen=True)
class Bar:
    """What was aimed at, and what came out."""

    sentence: str
    aim: float
    measured: float | None
    at_least: Annotated[bool, "the aim is the least value wanted, else the greatest"]
    met: Annotated[bool | None, "null where it could not be measured"]
    where: Annotated[str, "the work of the worst value, where there are several, or why there is none"] = ""
    least: Annotated[float | None, "of the ratios within each repeat, whose median it is"] = None

    @staticmethod
    def judged(
        sentence: str,
        aim: float,
        measured: float | None,
        at_least: bool = True,
        where: str = "",
        least: float | None = None,
    ) -> Bar:
        """The bar, held against what was measured."""
        met = None if measured is None else measured >= aim if at_least else measured <= aim
        return Bar(sentence, aim, measured, at_least, met, where, least)


@dataclass(frozen=True)
class Curve:
    """Cost against one size; the lists go together."""

    axis: str
    sizes: tuple[float, ...]
    seconds: Annotated[tuple[float, ...], "per period, least of the repeats"]
    building: Annotated[tuple[float, ...], "seconds to build the propagators"]
    cells: Annotated[tuple[int, ...], "of a period"]
    crossings: Annotated[tuple[float, ...], "of boundaries, per period"]
    note: Annotated[str, "where the curve ends, and why"] = ""


@dataclass(frozen=True)
class Limit:
    """Least arithmetic and bytes of one period, beside what it took."""

    work: str
    states: int
    cells: int
    crossings: float
    multiply_adds: Annotated[float, "fused, of the cells' maps"]
    crossing_multiply_adds: Annotated[float, "fused, of the crossings"]
    table_bytes: Annotated[int, "numbers of the maps"]
    peak: Annotated[float, "fused multiply-adds per second of this core, measured"]
    bandwidth: Annotated[float, "bytes per second that this core reads from such a table, measured"]
    seconds: Annotated[float, "what a period took, least of the repeats"]
    seconds_together: Annotated[float, "the same of many trajectories, for each"]
    least: Annotated[
        float, "seconds that the arithmetic or the reading needs at the peak, the longer of the two"
    ]
    share: Annotated[float, "of the core's peak that the necessary arithmetic reaches"]
    share_together: Annotated[float, "the same of many trajectories"]


@dataclass(frozen=True)
class Machine:
    """Where it ran, and with what."""

    processor: str
    cores: int
    system: str
    python: str
    versions: Annotated[dict[str, str], "by package; 'not installed' where a peer is missing"]


@dataclass(frozen=True)
class Benchmark:
    """A run of the benchmark."""

    quick: Annotated[bool, "small work, few repeats: the times mean little"]
    repeats: int
    machine: Machine
    rows: tuple[Row, ...]
    bars: tuple[Bar, ...]
    curves: tuple[Curve, ...]
    limits: tuple[Limit, ...]
    pixels: Annotated[dict[str, float], "facts about the map"]
    branch: Annotated[dict[str, float], "what one orbit of a branch takes, by its parts"]
    threads: Annotated[dict[str, float], "what two threads do in the time that one takes"]
    seconds: Annotated[float, "of the whole run"]
