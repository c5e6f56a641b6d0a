"""What the article's study came to: plain data, ready to be shown. All numbers are dimensionless."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from gearlash.case import Case
from gearlash.studies.motion import Motion
from gearlash.system import Record

if TYPE_CHECKING:
    import xarray

NAN = float("nan")


@dataclass(frozen=True)
class Mark:
    """A located change of the motion in a diagram. ``direction``: the sweeps it was found in, joined by
    commas."""

    value: float
    kind: str
    boundary: int
    before: str
    after: str
    direction: str
    article: bool


@dataclass(frozen=True, eq=False, repr=False)
class Diagram(Record):
    """One swept parameter: the data of all directions, and what was located along them."""

    parameter: str
    fixed: Mapping[str, float]
    dataset: xarray.Dataset
    marks: tuple[Mark, ...]


@dataclass(frozen=True, eq=False, repr=False)
class Event(Record):
    """One of the article's events, computed beside reported. Where it was not found, ``value`` is NaN, the
    motions are those at and beside the reported value, and ``note`` says what is there instead."""

    name: str
    title: str
    claim: str
    parameter: str
    fixed: Mapping[str, float]
    reported: float
    digits: str
    reported_before: str
    reported_after: str
    found: bool
    value: float
    deviation: float
    label_below: str
    label_above: str
    kind: str
    boundary: int
    a0: float
    phase: float
    type: str
    leading_below: complex
    leading_above: complex
    exponent: float
    distance_to_fold: float
    distance_to_doubling: float
    conditions: tuple[tuple[str, float, bool], ...]
    residual: float
    method: str
    branch: str
    verdict: str
    note: str
    motions: tuple[Motion, ...]


@dataclass(frozen=True)
class Coexisting:
    """Another attractor within a zone."""

    label: str
    interval: tuple[float, float]
    start: str
    largest_exponent: float
    note: str = ""


@dataclass(frozen=True)
class End:
    """One end of a zone: how it was found, and the label beyond it."""

    value: float
    how: str
    next_label: str
    uncertainty: float


@dataclass(frozen=True)
class Zone:
    """A stable zone, computed beside reported (None where the article has none)."""

    name: str
    parameter: str
    fixed: Mapping[str, float]
    kind: str
    reported: tuple[float, float] | None
    lower: End
    upper: End
    labels: tuple[str, ...]
    margin: float
    coexisting: tuple[Coexisting, ...]
    verdict: str
    note: str


@dataclass(frozen=True)
class Table2Row:
    """A row of the article's Table 2 as the program fills it."""

    type: str
    condition: str
    reported_effect_p: str
    reported_effect_qr: str
    reported_region: str
    events: tuple[str, ...]
    exponent: tuple[float, ...]
    periods: tuple[str, ...]
    patterns: tuple[str, ...]
    verdict: str
    note: str


@dataclass(frozen=True)
class ClaimRow:
    """A row of the table of claims."""

    id: str
    sentence: str
    quantity: str
    where: str
    printed: str
    computed: str
    value: float
    computed_value: float
    unit: str
    reported_labels: str
    computed_labels: str
    deviation: float
    verdict: str
    branch: str
    note: str
    rests_on: tuple[str, ...]


@dataclass(frozen=True)
class Check:
    """A measured bound: what was measured in this run, and whether it holds."""

    what: str
    value: str
    bound: str
    holds: bool | None


@dataclass(frozen=True)
class Touch:
    """A grazing that was solved for: value of the parameter with its error, labels below and above, kind,
    what is touched ("gap": X = ±D, "force": Φ = 0), largest exponent of the touching orbit."""

    value: float
    error: float
    label_below: str
    label_above: str
    kind: str
    surface: str
    exponent: float


@dataclass(frozen=True)
class RuleLabel:
    """The motion at one value: label, whether the back side is hit in it, certificate."""

    parameter: str
    value: float
    label: str
    back_hit: bool
    certificate: str


@dataclass(frozen=True)
class RuleEffect:
    """The small study under one contact rule; ``stated``: it is the case's own. ``lower`` and ``upper`` are
    the ends in ω of the motion without impacts (None: not found), ``speeds`` the cold starts at the multibody
    speeds, ``backlash`` the points of a sweep over D, followed down, ``back_side`` the back-side grazings
    along it."""

    rule: str
    stated: bool
    lower: Touch | None
    upper: Touch | None
    speeds: tuple[RuleLabel, ...]
    backlash: tuple[RuleLabel, ...]
    back_side: tuple[Touch, ...]


@dataclass(frozen=True)
class Run:
    """How the run went."""

    seconds: Mapping[str, float]
    workers: int
    cores: int
    versions: Mapping[str, str]
    statuses: Mapping[str, int]
    complete: bool
    certificates: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True, eq=False, repr=False)
class Reproduction(Record):
    """The article's whole study."""

    case: Case
    frequency: Diagram
    backlash: Diagram
    events: tuple[Event, ...]
    zones: tuple[Zone, ...]
    window: tuple[Motion, ...]
    table2: tuple[Table2Row, ...]
    claims: tuple[ClaimRow, ...]
    checks: tuple[Check, ...]
    run: Run
    rules: tuple[RuleEffect, ...] = ()
