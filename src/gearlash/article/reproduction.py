"""What the article's study came to: plain data, ready to be shown. All numbers are dimensionless."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import isfinite
from typing import TYPE_CHECKING

from gearlash.case import Case
from gearlash.studies.motion import Motion
from gearlash.system import Label, Record

if TYPE_CHECKING:
    import xarray

    from gearlash.branches import BifurcationPoint, GrazingPoint

NAN = float("nan")


@dataclass(frozen=True)
class Mark:
    """A located change of the motion in a diagram. ``direction``: the sweeps it was found in, joined by
    commas."""

    value: float
    kind: str
    boundary: int
    before: Label | None
    after: Label | None
    direction: str
    article: bool


@dataclass(frozen=True, eq=False, repr=False)
class Diagram(Record):
    """One swept parameter: the data of all directions, and what was located along them."""

    parameter: str
    fixed: Mapping[str, float]
    dataset: xarray.Dataset
    marks: tuple[Mark, ...]


@dataclass(frozen=True)
class Opening:
    """A doubled orbit beside the doubling it is born at: its amplitude (how far its state at phase zero is
    from that of the single orbit, along the critical eigenvector), the distance of the parameter, and the
    clearance of the extremum that will touch."""

    amplitude: float
    distance: float
    clearance: float


@dataclass(frozen=True, eq=False, repr=False)
class Coincidence(Record):
    """A period doubling and the first grazing of the orbit that is born there. ``single``, ``doubled`` and
    ``beyond`` are the labels on the far side of the doubling, between the two, and beyond the grazing;
    ``apart`` their distance in the parameter. ``clearance`` is that of the touching extremum at the doubling
    itself: 0 in a true co-dimension-2 point. ``predicted`` is the distance foreseen from the square root
    alone, ``power`` that of the opening as measured (1/2)."""

    doubling: BifurcationPoint
    grazing: GrazingPoint
    single: Label
    doubled: Label
    beyond: Label
    apart: float
    clearance: float
    predicted: float
    power: float
    opening: tuple[Opening, ...]

    @property
    def labels(self) -> tuple[Label, Label]:
        """Below both and above both, for a rising parameter."""
        if self.grazing.value < self.doubling.value:
            return self.beyond, self.single
        return self.single, self.beyond


@dataclass(frozen=True, eq=False, repr=False)
class Event(Record):
    """One of the article's events, computed beside reported. Where it was not found, ``value`` is NaN, the
    motions are those at and beside the reported value, and ``note`` says what is there instead.
    ``coincidence`` is the doubling and the grazing of a co-dimension-2 event, whose value and exponent are
    those of the doubling; ``everywhere``: it was met in all three directions."""

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
    label_below: Label | None
    label_above: Label | None
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
    coincidence: Coincidence | None = None
    everywhere: bool = False


@dataclass(frozen=True)
class Coexisting:
    """Another attractor within a zone."""

    label: Label
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
class Reading:
    """A stable zone as one way of looking shows it (`cold`, `up`, `down`, a simple `start`), or as `some` or
    `every` attractor found by the first three does. ``deviations`` are those of its ends from the article's;
    ``margin`` is the least distance to the boundary in its middle. Ends are NaN where there is none."""

    way: str
    name: str
    lower: End
    upper: End
    labels: tuple[Label, ...]
    margin: float
    coexisting: tuple[Coexisting, ...]
    deviations: tuple[float, float]
    verdict: str

    @property
    def found(self) -> bool:
        return isfinite(self.lower.value) and isfinite(self.upper.value)

    @property
    def deviation(self) -> float:
        """The larger one."""
        return max(self.deviations, key=abs)


@dataclass(frozen=True)
class Zone:
    """A stable zone of the article and its readings. ``nearest`` is the way whose ends lie nearest to the
    article's (empty if no reading has a zone), ``verdict`` that of this reading."""

    name: str
    parameter: str
    fixed: Mapping[str, float]
    kind: str
    reported: tuple[float, float]
    readings: tuple[Reading, ...]
    nearest: str
    verdict: str
    note: str

    def reading(self, way: str) -> Reading:
        """That of one way."""
        return next(reading for reading in self.readings if reading.way == way)


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
class Part:
    """One of several things that a claim says, judged by itself."""

    what: str
    reported: str
    computed: str
    verdict: str
    note: str


@dataclass(frozen=True)
class ClaimRow:
    """A row of the table of claims. ``needs`` names the way of scanning without which it does not come out
    (empty: each does); ``fitted`` says that open values of the case were chosen to meet this number, which
    then tests nothing; ``parts`` are what it says, where it says several things."""

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
    needs: str = ""
    fitted: bool = False
    parts: tuple[Part, ...] = ()


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
    label_below: Label | None
    label_above: Label | None
    kind: str
    surface: str
    exponent: float


@dataclass(frozen=True)
class RuleLabel:
    """The motion at one value: label (the status where there is no motion), whether the back side is hit in
    it, certificate."""

    parameter: str
    value: float
    label: Label | str
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
class BearingMode:
    """A bearing direction whose own frequency lies in the window without impacts, and the motion there: that
    of the bearing, its force, and the mesh force (peak to peak and mean), lengths over D_c, forces over
    k_m D_c."""

    bearing: str
    frequency: float
    motion: float
    force: float
    mesh_force: float
    mesh_mean: float


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
    bearings: tuple[BearingMode, ...] = ()
    coincidences: tuple[Coincidence, ...] = ()
