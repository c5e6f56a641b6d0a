"""The whole study, its diagrams, and how the run went."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from gearlash.case import Case
from gearlash.studies.motion import Motion
from gearlash.system import Label, Record, Status

from .branches import Scan
from .centre import Centre
from .claims import ClaimRow, Table2Row
from .events import Coincidence, Event
from .rules import BearingMode, RuleEffect
from .zones import ReportedZone

if TYPE_CHECKING:
    import xarray

    from gearlash import PlaneZone


@dataclass(frozen=True)
class DiagramMark:
    """A located change of the motion along a sweep.

    Attributes
    ----------
    value : float
        Of the parameter.
    kind : str
        ``grazing``, ``doubling``, ``fold``, or another change.
    boundary : int
        That is touched: +1 (Σ1), -1 (Σ2); 0 where none is.
    before, after : label or None
        For a rising parameter.
    direction : str
        The sweeps it was found in, joined by commas; ``all`` where it was found in all.
    article : bool
        Whether it is one of the article's events.
    """

    value: float
    kind: str
    boundary: int
    before: Label | None
    after: Label | None
    direction: str
    article: bool


@dataclass(frozen=True, eq=False, repr=False)
class Diagram(Record):
    """One swept parameter.

    Attributes
    ----------
    parameter : str
    fixed : mapping of str to float
        Values of the other parameters.
    dataset : xarray.Dataset
        The sweeps of all directions, as of `gearlash.sweep_dataset`.
    marks : tuple of DiagramMark
        What was located along them.
    """

    parameter: str
    fixed: Mapping[str, float]
    dataset: xarray.Dataset
    marks: tuple[DiagramMark, ...]


@dataclass(frozen=True)
class Check:
    """A bound that this run can measure on itself.

    Attributes
    ----------
    what, value, bound : str
    holds : bool or None
        None where it is reported only.
    """

    what: str
    value: str
    bound: str
    holds: bool | None


@dataclass(frozen=True)
class Run:
    """How the run went.

    Attributes
    ----------
    seconds : mapping of str to float
        By stage, and ``total``.
    workers, cores : int
    versions : mapping of str to str
    statuses : mapping of str to int
        Points of the sweeps by status.
    complete : bool
    certificates : mapping of str to int
        Points of the sweeps by certificate.
    """

    seconds: Mapping[str, float]
    workers: int
    cores: int
    versions: Mapping[str, str]
    statuses: Mapping[Status, int]
    complete: bool
    certificates: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True, eq=False, repr=False)
class Reproduction(Record):
    """The article's whole study, as `reproduce` returns it.

    Attributes
    ----------
    case : Case
    frequency, backlash : Diagram
        The sweeps over ω and over D.
    events : tuple of Event
    zones : tuple of ReportedZone
    window : tuple of Motion
        Every motion found at one ω of the zone without impacts.
    table2 : tuple of Table2Row
    claims : tuple of ClaimRow
        Every claim with its verdict.
    checks : tuple of Check
    run : Run
    rules : tuple of RuleEffect
        The small study under every contact rule, that of the case first.
    bearings : tuple of BearingMode
    coincidences : tuple of Coincidence
        Of every doubling that has a grazing within 2 % of the parameter.
    scans : tuple of Scan
        The two sweeps as branches of periodic orbits: over ω, over D.
    centres : tuple of Centre
        Of every claim of a coincidence: the point of two parameters beside it.
    window_plane : PlaneZone or None
        The zone without impacts around the case's own speed and load; None where it has impacts there.
    """

    case: Case
    frequency: Diagram
    backlash: Diagram
    events: tuple[Event, ...]
    zones: tuple[ReportedZone, ...]
    window: tuple[Motion, ...]
    table2: tuple[Table2Row, ...]
    claims: tuple[ClaimRow, ...]
    checks: tuple[Check, ...]
    run: Run
    rules: tuple[RuleEffect, ...] = ()
    bearings: tuple[BearingMode, ...] = ()
    coincidences: tuple[Coincidence, ...] = ()
    scans: tuple[Scan, ...] = ()
    centres: tuple[Centre, ...] = ()
    window_plane: PlaneZone | None = None
