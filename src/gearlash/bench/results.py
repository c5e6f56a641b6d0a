"""What a run of the benchmark found: rows, bars, curves, machine. Plain data."""

from __future__ import annotations

from dataclasses import dataclass

OWN = "gearlash"


@dataclass(frozen=True)
class Row:
    """One solver at one piece of work. ``seconds`` (median) and ``best`` are per ``unit``; ``ratio`` is how
    many times longer than gearlash; errors are the largest seen against the reference: of the state after
    one period (dimensionless), of crossing times (τ), or of the number asked for. What was not measured is
    None, and ``note`` says why."""

    task: str
    work: str
    solver: str
    unit: str
    seconds: float | None = None
    best: float | None = None
    ratio: float | None = None
    error: float | None = None
    time_error: float | None = None
    note: str = ""


@dataclass(frozen=True)
class Bar:
    """What was aimed at, and what came out. ``met`` is None where it could not be measured."""

    sentence: str
    aim: float
    measured: float | None
    at_least: bool  # the aim is a least value, else a greatest

    @property
    def met(self) -> bool | None:
        if self.measured is None:
            return None
        return self.measured >= self.aim if self.at_least else self.measured <= self.aim


@dataclass(frozen=True)
class Curve:
    """Cost against one size: at each value of ``axis``, seconds per period and to build the propagators,
    cells and crossings per period."""

    axis: str
    sizes: tuple[float, ...]
    seconds: tuple[float, ...]
    building: tuple[float, ...]
    cells: tuple[int, ...]
    crossings: tuple[float, ...]
    note: str = ""


@dataclass(frozen=True)
class Limit:
    """Least arithmetic and bytes of one period of one work, beside what it took. ``peak`` in fused
    multiply-adds per second and ``bandwidth`` in bytes per second are those of this core, measured."""

    work: str
    states: int
    cells: int
    crossings: float
    multiply_adds: float
    crossing_multiply_adds: float
    table_bytes: int
    peak: float
    bandwidth: float
    seconds: float

    @property
    def least(self) -> float:
        """Seconds that no implementation of this method can undercut on this core: the slower of the two."""
        arithmetic = (self.multiply_adds + self.crossing_multiply_adds) / self.peak
        return max(arithmetic, self.table_bytes / self.bandwidth)

    @property
    def share(self) -> float:
        """Of the core's peak that the necessary arithmetic reaches."""
        return (self.multiply_adds + self.crossing_multiply_adds) / self.peak / self.seconds


@dataclass(frozen=True)
class Machine:
    """Where it ran, and with what."""

    processor: str
    cores: int
    system: str
    python: str
    versions: dict[str, str]  # "not installed" where a peer is missing


@dataclass(frozen=True)
class Benchmark:
    """The whole run."""

    quick: bool
    repeats: int
    machine: Machine
    rows: tuple[Row, ...]
    bars: tuple[Bar, ...]
    curves: tuple[Curve, ...]
    limits: tuple[Limit, ...]
    pixels: tuple[tuple[str, float], ...]  # facts about the map: name, value
    seconds: float
