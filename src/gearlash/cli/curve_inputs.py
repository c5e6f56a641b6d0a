"""What `gearlash curve` is asked: two parameters with limits, and the special points to begin at, of
the branch through a motion of the case, or of a branch or a curve that was kept."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from gearlash.case import Case, CaseError, Problem
from gearlash.system import Family, GearlashError

from .answers.curve_parts import Begun, CurveStart
from .answers.outcome import INCOMPLETE
from .branch_inputs import BranchInputs, as_kept, check_inside, check_same, near_value
from .inputs import TypedLimits, read_between, read_case, read_start

if TYPE_CHECKING:
    from gearlash.branches.continuation import Branch, ContinuationSettings, SpecialPoint
    from gearlash.branches.curves import CodimTwoPoint, Curve
    from gearlash.jobs import Execution
    from gearlash.orbits import Settings

    from .answers.branch_parts import LimitsUsed

SAME_END = 1e-7  # of the limits
KINDS = ("grazing", "fold", "doubling", "Neimark-Sacker")


@dataclass(frozen=True)
class Wanted:
    """A special point by number (from 1), or by kind and, if told, by the value that it is nearest to; all of
    them where nothing is told."""

    number: int | None = None
    kind: str = ""
    value: float | None = None


@dataclass(eq=False)
class CurveInputs:
    """``parameters``: all values, with those to begin at; ``state``: to look for the motion from; ``kept``:
    what --resume has read. Following fills in ``start``, what is begun with, and ``branch``."""

    case: Case
    family: Family
    axes: tuple[TypedLimits, TypedLimits]
    parameters: dict[str, float]
    wanted: tuple[Wanted, ...]
    choice: Mapping[str, Any]
    state: list[float] = field(default_factory=list[float])
    kept: Branch | Curve | None = None
    start: CurveStart | None = None
    branch: Branch | None = None

    @staticmethod
    def read(
        name: str,
        settings: list[str] | None,
        over: Sequence[str],
        begin: Sequence[str] | None,
        resume: Path | None,
        at: int | None,
        near: str | None,
        initial: list[str] | None,
        kind: str | None,
        touch: int,
        doubled: bool,
    ) -> CurveInputs:
        """Raises `CaseError` or another `GearlashError` for what cannot be used."""
        case = read_case(name, settings)
        family, _ = case.family()
        problems = _together(begin, resume, at, near, initial)
        axes = _axes(case, over, problems)
        choice = {"kind": _kind(kind, problems), "touch": touch - 1, "doubled": doubled}
        wanted = () if axes is None else _wanted(case, axes[0], begin, at, problems)
        if problems or axes is None:
            raise CaseError(name, problems)
        if resume is not None:
            return _resumed(case, family, axes, wanted, choice, resume)
        values = {} if near is None else near_value(case, axes[0], near)
        parameters = family.complete(values)
        check_inside(case, axes[0], parameters[axes[0].short])
        check_inside(case, axes[1], parameters[axes[1].short], " (--set gives another one)")
        state = list(read_start(family, parameters, initial).values())
        return CurveInputs(case, family, axes, parameters, wanted, choice, state)

    @property
    def names(self) -> tuple[str, str]:
        one, two = self.axes
        return one.short, two.short

    @property
    def limits(self) -> tuple[LimitsUsed, LimitsUsed]:
        """As the answer tells them."""
        from .answers.branch import limits_used

        one, two = (
            limits_used(self.case, each.short, each.named, each.unit, each.lower, each.upper)
            for each in self.axes
        )
        return one, two

    def followed(
        self, search: Settings, steps: ContinuationSettings, execution: Execution
    ) -> tuple[Begun, ...]:
        """Every curve that was asked for, until it is stopped."""
        from gearlash.branches.curves import Curve, CurveEndKind

        source = self.kept if self.kept is not None else self._first(search, steps, execution)
        if source is None:
            return ()
        found: list[Begun] = []
        for number in self._chosen(source):
            if found and found[-1].curve is not None:
                ends = found[-1].curve.ends
                if any(end.kind is CurveEndKind.CANCELLED for end in ends):
                    break
            special = source.special[number - 1]
            try:
                made = self._curve(source, special, steps, execution)
            except GearlashError as error:
                found.append(Begun(number, special, None, str(error)))
            else:
                same = next((i for i, each in enumerate(found) if is_same(made, each.curve)), None)
                if same is None:
                    found.append(Begun(number, special, made))
                else:
                    found.append(
                        Begun(number, special, None, f"it lies on the curve from {found[same].number}")
                    )
        if self.start is None:
            self.start = _told_of(source, isinstance(source, Curve))
        return tuple(found)

    def _first(self, search: Settings, steps: ContinuationSettings, execution: Execution) -> Branch | None:
        """The branch over the first parameter, through the motion of the case."""
        from gearlash.branches.continuation import EndKind
        from gearlash.studies import continue_branch

        axis = self.axes[0]
        inputs = BranchInputs(self.case, self.family, axis, self.parameters, self.state)
        begin = inputs.begin(search)
        told = begin.told
        if begin.start is None:
            self.start = CurveStart("motion", told.label, told.status, told.message, ())
            return None
        limits = {"lower": axis.lower, "upper": axis.upper, "values": begin.parameters}
        self.branch = continue_branch(
            self.family, axis.short, begin.start, **limits, steps=steps, execution=execution
        )
        self.start = _told_of(self.branch, curve=False, label=told.label)
        if any(end.kind is EndKind.CANCELLED for end in self.branch.ends):
            self.start = replace(self.start, status=INCOMPLETE, message="stopped on the way along the branch")
            return None
        return self.branch

    def _chosen(self, source: Branch | Curve) -> list[int]:
        """Numbers of the special points that are begun at. Raises `CaseError` for one that there is not."""
        found: list[int] = []
        for wanted in self.wanted:
            if wanted.number is not None:
                if wanted.number > len(source.special):
                    raise _no_such(source, str(wanted.number))
                found.append(wanted.number)
            elif not wanted.kind:
                found += range(1, len(source.special) + 1)
            else:
                found.append(self._nearest(source, wanted))
        return list(dict.fromkeys(found))

    def _nearest(self, source: Branch | Curve, wanted: Wanted) -> int:
        from gearlash.branches.continuation import Branch

        assert isinstance(source, Branch)
        here = self.parameters.get(source.name, 0.0) if wanted.value is None else wanted.value
        each = [
            (abs(s.value - here), i) for i, s in enumerate(source.special, 1) if str(s.kind) == wanted.kind
        ]
        if not each:
            raise _no_such(source, wanted.kind)
        return min(each)[1]

    def _curve(
        self,
        source: Branch | Curve,
        special: SpecialPoint | CodimTwoPoint,
        steps: ContinuationSettings,
        execution: Execution,
    ) -> Curve:
        from gearlash.branches.continuation import Branch
        from gearlash.studies import continue_curve

        one, two = self.axes
        if isinstance(source, Branch):
            own: dict[str, Any] = {"branch": source}
        else:
            own = {"values": {**source.values, **dict(zip(source.names, special.values, strict=True))}}
        limits = {"lower": (one.lower, two.lower), "upper": (one.upper, two.upper)}
        asked = {**limits, **own, **self.choice}
        return continue_curve(self.family, self.names, special, **asked, steps=steps, execution=execution)


def is_same(one: Curve, other: Curve | None) -> bool:
    """Whether two curves of one kind lie between the same ends."""
    if other is None or one.kind is not other.kind or "closed" in str(one.ends[0].kind):
        return False
    width = np.subtract(one.upper, one.lower)
    ends = [np.array([end.values for end in each.ends]) / width for each in (one, other)]
    return any(np.abs(ends[0] - turned).max() < SAME_END for turned in (ends[1], ends[1][::-1]))


def _told_of(source: Branch | Curve, curve: bool, label: str = "") -> CurveStart:
    kinds = tuple(str(special.kind) for special in source.special)
    if not label:
        first = min(source.points, key=lambda point: abs(point.arclength))
        label = str(first.signature)
    return CurveStart("curve" if curve else "branch", label, "ok", "", kinds)


def _no_such(source: Branch | Curve, wanted: str) -> CaseError:
    from gearlash.branches.curves import Curve

    kinds = [f"{i} {special.kind}" for i, special in enumerate(source.special, 1)]
    what = "curve" if isinstance(source, Curve) else "branch"
    left = f" and {len(kinds) - 12} more" if len(kinds) > 12 else ""
    has = f"which has {', '.join(kinds[:12])}{left}" if kinds else "which has none"
    return CaseError("--from", [Problem("--from", wanted, f"a special point of a {what} {has}")])


def _together(
    begin: Sequence[str] | None,
    resume: Path | None,
    at: int | None,
    near: str | None,
    initial: Iterable[str] | None,
) -> list[Problem]:
    """What does not go together, or is missing."""
    found = []
    if not begin and at is None:
        example = "a special point to begin at, such as fold; or --resume FILE --at NUMBER"
        found.append(Problem("--from", None, example))
    if begin and at is not None:
        found.append(Problem("--at", repr(at), "only one of it and --from"))
    if at is not None and resume is None:
        found.append(Problem("--at", repr(at), "--resume FILE with it, whose special point that is"))
    for option, given in (("--near", near), ("--initial", initial)):
        if given and resume is not None:
            found.append(
                Problem(option, repr(given), "only one of it and --resume: the file says where to begin")
            )
    return found


def _axes(case: Case, over: Sequence[str], problems: list[Problem]) -> tuple[TypedLimits, TypedLimits] | None:
    """Two different ones; what is wrong joins the other problems."""
    found = []
    for text in over:
        try:
            found.append(read_between(case, text))
        except CaseError as error:
            problems += error.problems
    if len(over) != 2:
        problems.append(Problem("--over", f"given {len(over)} times", "two parameters, each with its limits"))
    elif len(found) == 2 and found[0].short == found[1].short:
        problems.append(Problem("--over", repr(over[1]), f"another parameter than {found[0].short}"))
    elif len(found) == 2:
        return found[0], found[1]
    return None


def _kind(text: str | None, problems: list[Problem]) -> str | None:
    if text is None:
        return None
    for kind in KINDS:
        if text.casefold() == kind.casefold():
            return kind
    problems.append(Problem("--kind", repr(text), ", ".join(KINDS)))
    return None


def _wanted(
    case: Case, axis: TypedLimits, begin: Sequence[str] | None, at: int | None, problems: list[Problem]
) -> tuple[Wanted, ...]:
    if at is not None:
        return (Wanted(at),)
    found = []
    for text in begin or ():
        name, equals, value = (part.strip() for part in text.partition("="))
        kind = next((each for each in KINDS if each.casefold() == name.casefold()), "")
        if text.casefold() == "all":
            found.append(Wanted())
        elif text.isascii() and text.isdigit() and 1 <= len(text) < 6 and int(text):
            found.append(Wanted(int(text)))
        elif kind and not equals:
            found.append(Wanted(kind=kind))
        elif kind and value:
            found.append(Wanted(kind=kind, value=near_value(case, axis, value)[axis.short]))
        else:
            expected = f"the number of a special point, {', '.join(KINDS)}, one of these with a value, or all"
            problems.append(Problem("--from", repr(text), expected))
    return tuple(found)


def _resumed(
    case: Case,
    family: Family,
    axes: tuple[TypedLimits, TypedLimits],
    wanted: tuple[Wanted, ...],
    choice: Mapping[str, Any],
    path: Path,
) -> CurveInputs:
    """At points of a branch or a curve that was kept."""
    kept = _kept(path)
    case, family = as_kept(case, kept.values)
    if set(kept.values) != set(family.defaults):
        raise CaseError(
            "--resume", [Problem("--resume", repr(str(path)), "a branch or a curve of this case")]
        )
    from gearlash.branches.continuation import Branch

    varied = (kept.name,) if isinstance(kept, Branch) else kept.names
    if not isinstance(kept, Branch) and any(each.kind for each in wanted):
        expected = "--at NUMBER or --from NUMBER: the points of a curve have kinds of their own"
        raise CaseError("--from", [Problem("--from", next(each.kind for each in wanted), expected)])
    free = {*varied, *(axis.short for axis in axes)}
    check_same(case, family.complete(), kept.values, free)
    for axis in axes:
        if axis.short not in varied:
            check_inside(case, axis, kept.values[axis.short], ", that of the file")
    return CurveInputs(case, family, axes, dict(kept.values), wanted, choice, kept=kept)


def _kept(path: Path) -> Branch | Curve:
    from gearlash.results.branch_file import load_branch
    from gearlash.results.curve_file import load_curve

    try:
        return load_branch(path)
    except GearlashError as error:
        if "not a file of a branch" not in str(error):
            raise
    try:
        return load_curve(path)
    except GearlashError as error:
        if "not a file of a curve" not in str(error):
            raise
        raise CaseError(
            "--resume", [Problem("--resume", repr(str(path)), "a file of a branch or of a curve")]
        ) from None
