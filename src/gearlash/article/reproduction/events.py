"""The article's events, and doublings with a grazing beside them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gearlash.studies.motion import Motion
from gearlash.system import Label, Record

if TYPE_CHECKING:
    from gearlash import GrazingLaw, SpecialPoint


@dataclass(frozen=True)
class Opening:
    """A doubled orbit beside the doubling at which it is born.

    Attributes
    ----------
    amplitude : float
        Half of how far it lies, at phase zero, from itself half of its period later: at most.
    distance : float
        Of the parameter from the doubling.
    clearance : float
        Of the extremum that will touch, from the boundary.
    """

    amplitude: float
    distance: float
    clearance: float


@dataclass(frozen=True, eq=False, repr=False)
class Coincidence(Record):
    """A period doubling, and the first grazing of the orbit that is born there.

    Attributes
    ----------
    doubling : SpecialPoint
    grazing : SpecialPoint
    single, doubled, beyond : label
        Of the motions on the far side of the doubling, between the two, and beyond the grazing.
    apart : float
        Distance of the two in the parameter.
    clearance : float
        Of the touching extremum at the doubling itself: 0 in a true co-dimension-2 point.
    predicted : float
        ``apart`` as foreseen from small amplitudes and the square root alone: c (h/b)².
    power : float
        Of the opening as measured at the smallest amplitudes: amplitude ∼ distance^power, 1/2 in theory.
    opening : tuple of Opening
    opens : float
        c: distance of the parameter over the square of the amplitude.
    approaches : float
        b: by how much the extremum comes nearer to the boundary, over the amplitude.
    corrected : float
        ``apart`` as foreseen with the next terms of both as well, from amplitudes up to half of that which
        touches.
    amplitude : float
        Of the orbit that touches.
    """

    doubling: SpecialPoint
    grazing: SpecialPoint
    single: Label
    doubled: Label
    beyond: Label
    apart: float
    clearance: float
    predicted: float
    power: float
    opening: tuple[Opening, ...]
    opens: float = float("nan")
    approaches: float = float("nan")
    corrected: float = float("nan")
    amplitude: float = float("nan")

    @property
    def labels(self) -> tuple[Label, Label]:
        """Below both and above both, for a rising parameter."""
        if self.grazing.value < self.doubling.value:
            return self.beyond, self.single
        return self.single, self.beyond


@dataclass(frozen=True, eq=False, repr=False)
class Event(Record):
    """One of the article's events, computed beside reported.

    Where it was not found, ``value`` is NaN, the motions are those at and beside the reported value, and
    ``note`` says what is there instead.

    Attributes
    ----------
    name, title : str
    claim : str
        Id of the claim it belongs to.
    parameter : str
    fixed : mapping of str to float
    reported, digits : float, str
        The article's value, and as printed.
    reported_before, reported_after : str
        The article's labels.
    found : bool
    value, deviation : float
        As computed, and relative to the reported value; at a coincidence, of the doubling.
    label_below, label_above : label
    kind : str
        Loss of contact or engagement, drive or back side.
    boundary : int
        That is touched: +1 (Σ1), -1 (Σ2).
    a0, phase : float
        X″ at the touch, and its phase in mesh cycles.
    type : str
        As in Table 2.
    leading_below, leading_above : complex
        Multipliers of largest modulus of the motions shown before and after.
    exponent : float
        Largest exponent of the touching orbit, per unit of τ; at a coincidence, of the doubling.
    distance_to_fold, distance_to_doubling : float
        Least |λ - 1| and |λ + 1|.
    conditions : tuple of (str, float, bool)
        Of grazing: in words, the value, and whether it holds.
    residual : float
    method, branch : str
        How it was computed, and along which sweeps.
    verdict, note : str
    motions : tuple of Motion
        Before, at and after.
    coincidence : Coincidence or None
        Of a co-dimension-2 event.
    everywhere : bool
        Whether it was met in all three directions.
    law : GrazingLaw or None
        What the touch does to the multipliers of its branch; None where no branch has it, or where there is
        no such law (a touch from the gap under ``no-tension``).
    """

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
    law: GrazingLaw | None = None
