"""Tolerances at once: speeds, or values of another parameter, at which impact-free motion exists in all, some
or none of the combinations of values that lie between their limits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import inf, isnan, nan

import numpy as np

from gearlash.case import Case
from gearlash.jobs import INTERRUPTED, Chain, Execution, run
from gearlash.results import Axis
from gearlash.results.tolerance import Influence, Tolerance, ToleranceInput, ToleranceMember
from gearlash.studies.arguments import checked_execution
from gearlash.studies.model import Source
from gearlash.system import GearlashError, given

from .bands import contains, outside, shared
from .designs import corners, samples
from .influence import combinations, groups, influences, share_and_error, why_none
from .inputs import Limits, check_possible, inputs_beside
from .members import Task, present_on, work
from .profile import profile
from .worst import Row, worst_from

OF_A_TASK = 4  # combinations with their bands
OF_A_SHORT_TASK = 32  # at one value of the axis


def tolerance(
    case: Case,
    axis: Axis,
    limits: Limits | None = None,
    *,
    samples: int = 32,
    replicates: int = 8,
    execution: Execution | None = None,
) -> Tolerance:
    """Where impact-free motion exists in spite of tolerances.

    Every input lies between two limits, each value as likely as any other and inputs independent of each
    other. For each combination the motion of teeth that never part is solved for along the axis, and the ends
    of the bands in which it exists and is stable to rounding.

    Parameters
    ----------
    case : Case
        A gear pair with load.
    axis : Axis
        The parameter, mostly a speed, and the values between which bands are looked for, in any unit:
        ``Axis.even("pinion_speed", "3000 rpm", "5000 rpm", 61)``. What is narrower than a step may be missed
        where it lies beside no least or largest margin.
    limits : mapping of str to (float or str, float or str) or str, optional
        Both limits of every input, by any name of the case: ``{"backlash": ("60 um", "120 um")}``, or as one
        text: ``{"backlash": "60:120um"}``. Without, the limits that the case states and the ranges of
        all that it estimates.
    samples : int
        Points of one set of samples, a power of 2 from 2 on.
    replicates : int
        Independent sets, from 2 on: errors come from their spread.
    execution : Execution, optional
        Who does the work, who is told and who may stop it: results are the same bytes.

    Returns
    -------
    Tolerance

    Raises
    ------
    CaseError
        For names and limits that do not fit.
    GearlashError
        For a case that is no gear pair with load, and for counts that do not fit.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> speeds = gl.Axis.even("omega", 0.5, 0.9, 5)
    >>> found = gl.tolerance(case, speeds, {"load": (0.1, 0.3)}, samples=4, replicates=2)
    >>> found.inputs[0].path, len(found.probability)
    ('dimensionless.load', 5)
    """
    given.instance("case", case, Case, "a case, as from gearlash.load_case")
    given.instance("axis", axis, Axis, 'an Axis, such as Axis.even("omega", 0.5, 1.4, 91)')
    _check(case)
    count = given.whole("samples", samples, 2, 65_536)
    if count & (count - 1):
        raise GearlashError(
            f"samples = {count}: expected a power of 2, such as {1 << (count - 1).bit_length()}"
        )
    sets = given.whole("replicates", replicates, 2, 1_000)
    if len(axis) < 2:
        raise GearlashError("axis: expected at least two values, between which bands are looked for")
    value = axis.values[0].item()
    inputs = inputs_beside(case, limits, axis.name, f"{value!r} {axis.unit}" if axis.unit else value)
    check_possible(case, inputs)
    source = Source.of(case)
    looker = _Looker(source, inputs, axis, present_on(case, axis), checked_execution(source, execution))
    return looker.look(count, sets)


def _check(case: Case) -> None:
    defaults = case.family()[0].complete({})
    if not case.between_teeth or len(case.family()[0].system(defaults).clearances) != 1:
        raise GearlashError(f"{case.name} is no gear pair with one clearance between its teeth")
    if defaults.get("load", 0.0) == 0.0:
        raise GearlashError("load = 0: no side carries, so there is no motion of teeth that never part")


@dataclass
class _Looker:
    """Combinations looked at, one kind after the other; what is done is kept when it is stopped."""

    source: Source
    inputs: tuple[ToleranceInput, ...]
    axis: Axis
    present: float
    execution: Execution
    stopped: str = ""

    def look(self, count: int, sets: int) -> Tolerance:
        sampled = samples(self.inputs, count, sets)
        cornered = [tuple(row) for row in corners(self.inputs).tolist()]
        rows = [tuple(row) for each in sampled for row in each[0].tolist()]
        found = self.members([(), *cornered, *rows])
        if not found:
            if self.stopped == INTERRUPTED:
                raise KeyboardInterrupt
            raise GearlashError(f"nothing was computed ({self.stopped})")
        nominal = replace(found[0], inputs=tuple(one.nominal for one in self.inputs))
        members = [nominal, *found[1:]] if self.has_nominal or len(found) == 1 else found[1:]
        searched = [] if self.stopped else self.search(members)
        tried = [*members, *searched]
        drawn = found[1 + len(cornered) :]
        share, error = self.probability(drawn, count)
        here = self.at_present(drawn, count)
        ends = float(self.axis.values[0]), float(self.axis.values[-1])
        shares, no_shares = self.influences(count, sets)
        return Tolerance(
            axis=self.axis,
            inputs=self.inputs,
            nominal=nominal,
            always=shared(member.bands for member in tried),
            never=outside((member.bands for member in tried), *ends),
            probability=share,
            probability_error=error,
            here=here[0],
            here_error=here[1],
            present=self.present,
            worst=min(searched or tried, key=_badness),  # the search begins from the worst of the others
            samples=count,
            replicates=sets,
            corners=len(cornered),
            tried=len(tried),
            influences=shares,
            unsolved=sum(member.unsolved for member in tried),
            profile=profile([member.bands for member in drawn], count, *ends),
            complete=not self.stopped,
            message=self.stopped,
            no_influences=no_shares,
        )

    @property
    def has_nominal(self) -> bool:
        """Whether the case as it is lies within the limits."""
        return all(one.lower <= one.nominal <= one.upper for one in self.inputs)

    def members(self, rows: Sequence[tuple[float, ...]], bands: bool = True) -> list[ToleranceMember]:
        """Combinations in order, as far as the work came."""
        size = OF_A_TASK if bands else OF_A_SHORT_TASK
        parts = [tuple(rows[at : at + size]) for at in range(0, len(rows), size)]
        chains = [Chain(at, (self.task(part, bands),), (len(part),)) for at, part in enumerate(parts)]
        outcome = run(work, chains, self.execution)
        self.stopped = self.stopped or outcome.reason
        found: list[ToleranceMember] = []
        for at, part in enumerate(parts):
            done = outcome.results.get(at, ())
            found += done
            if len(done) < len(part):
                break
        return found

    def task(self, part: tuple[tuple[float, ...], ...], bands: bool) -> Task:
        """Some combinations."""
        return Task(self.source, self.inputs, self.axis, self.present, part, bands)

    def search(self, members: Sequence[ToleranceMember]) -> list[ToleranceMember]:
        """From the worst combination on, towards worse ones between the limits."""

        def tried(rows: Sequence[Row]) -> list[float]:
            found = [_badness(member) for member in self.members(rows, bands=False)]
            return found if len(found) == len(rows) else []

        begin = min(members, key=_badness)
        worst = worst_from(begin.inputs, _badness(begin), self.inputs, tried)
        return self.members([worst]) if worst != begin.inputs and not self.stopped else []

    def probability(
        self, drawn: Sequence[ToleranceMember], count: int
    ) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """At each value of the axis, from whole sets of samples."""
        free = np.array(
            [[contains(member.bands, at) for at in self.axis.values.tolist()] for member in drawn], float
        )
        sets = len(drawn) // count
        if sets < 2:
            empty = (nan,) * len(self.axis)
            return empty, empty
        share, error = share_and_error(free[: sets * count].reshape(sets, count, -1))
        return tuple(share.tolist()), tuple(error.tolist())

    def at_present(self, drawn: Sequence[ToleranceMember], count: int) -> tuple[float, float]:
        """The same at the present value."""
        inside = self.axis.values[0] <= self.present <= self.axis.values[-1]
        sets = len(drawn) // count
        if not inside or sets < 2:
            return nan, nan
        free = np.array([member.margin > 0.0 for member in drawn[: sets * count]], float)
        share, error = share_and_error(free.reshape(sets, count))
        return float(share), float(error)

    def influences(self, count: int, sets: int) -> tuple[tuple[Influence, ...], str]:
        """Sobol indices of the margin at the present value, or why there are none."""
        together = groups(self.inputs)
        if len(together) < 2:
            return (), "all of it is of one input"
        if self.stopped:
            return (), self.stopped
        drawn = samples(self.inputs, count, sets, 2)
        sets_of_points = [combinations(both, together.values()) for both in drawn]
        rows = [tuple(row) for one in sets_of_points for row in one.reshape(-1, len(self.inputs)).tolist()]
        members = self.members(rows, bands=False)
        if len(members) < len(rows):
            return (), self.stopped
        margins = np.array([member.share for member in members])
        found = list(margins.reshape(len(sets_of_points), *sets_of_points[0].shape[:2]))
        none = why_none(found)
        return ((), none) if none else (influences(together, found), "")


def _badness(member: ToleranceMember) -> float:
    """The margin over the static compression; what was not solved for is no worst case."""
    return inf if isnan(member.share) else member.share
