"""What `gearlash branch` is asked: the case, the parameter with its limits, and the motion to begin with,
found from a state or taken from a branch that was kept."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from gearlash.case import Case, CaseError, Problem
from gearlash.case.units import behind_number
from gearlash.system import Family, GearlashError, UnknownNameError

from .inputs import TypedLimits, read_between, read_case, read_start

if TYPE_CHECKING:
    from gearlash.branches.continuation import Branch, BranchPoint, ContinuationSettings
    from gearlash.orbits import Orbit, Settings
    from gearlash.results import Point

    from .answers.branch_parts import BranchStart, LimitsUsed

SAME_VALUE = 1e-9  # relative: a parameter of the file that differs by more is another one


@dataclass(frozen=True, eq=False)
class FirstMotion:
    """What is begun with: a periodic motion, or a branch as it was kept; or neither, where the motion is not
    periodic. ``told``: what is said of it; ``parameters``: all values there."""

    told: BranchStart
    parameters: dict[str, float]
    start: Orbit | Point | None = None
    branch: Branch | None = None


@dataclass(frozen=True, eq=False)
class BranchInputs:
    """``parameters``: all values, with that of the varied one to begin at; ``state``: to look for the motion
    from; ``kept``: the branch of --resume, and the orbit of it to begin at; without one it is taken as it
    is."""

    case: Case
    family: Family
    between: TypedLimits
    parameters: dict[str, float]
    state: list[float] = field(default_factory=list)
    kept: Branch | None = None
    point: BranchPoint | None = None

    @staticmethod
    def read(
        name: str,
        settings: list[str] | None,
        over: str | None,
        near: str | None,
        initial: list[str] | None,
        resume: Path | None,
        at: int | None,
    ) -> BranchInputs:
        """Raises `CaseError` or another `GearlashError` for what cannot be used."""
        case = read_case(name, settings, [] if over is None else [over])
        family, _ = case.family()
        problems = _together(over, near, initial, resume, at)
        between = None if over is None else _read(problems, case, over)
        if problems:
            raise CaseError(name, problems)
        if resume is not None:
            return _resumed(case, family, between, resume, at)
        assert between is not None
        values = {} if near is None else near_value(case, between, near)
        parameters = family.complete(values)
        check_inside(case, between, parameters[between.short])
        state = list(read_start(family, parameters, initial).values())
        return BranchInputs(case, family, between, parameters, state)

    @property
    def limits(self) -> LimitsUsed:
        """As the answer tells them."""
        from .answers.branch import limits_used

        each = self.between
        return limits_used(self.case, each.short, each.named, each.unit, each.lower, each.upper)

    def begin(self, search: Settings) -> FirstMotion:
        """Looks for the motion, or takes it from the branch that was kept."""
        from gearlash.studies import point

        from .answers.branch_parts import BranchStart

        if self.kept is not None:
            return self._from_kept(self.kept)
        short = self.between.short
        found = point(self.family, self.parameters, name=short, start=self.state, settings=search)
        label = "" if found.label is None else str(found.label)
        told = BranchStart(self.parameters[short], label, str(found.status), found.message)
        asked = found.periodic and self.family.system(self.parameters).excited
        return FirstMotion(told, self.parameters, found if asked else None)

    def _from_kept(self, kept: Branch) -> FirstMotion:
        from gearlash import flow
        from gearlash.orbits import orbit_at

        from .answers.branch_parts import BranchStart

        short, point = self.between.short, self.point
        if point is None:
            first = min(kept.points, key=lambda each: abs(each.arclength))
            told = BranchStart(first.value, str(first.label), "ok", "taken from the file")
            return FirstMotion(told, {**self.parameters, short: first.value}, branch=kept)
        props = flow.propagators(self.family.system(self.parameters))
        orbit = orbit_at(props, point.state, len(point.strobes))
        if orbit is None:
            raise GearlashError("--resume: the orbit of the file is none of this case")
        message = f"an orbit of the file, at {kept.name} = {point.value:.10g}"
        told = BranchStart(self.parameters[short], str(orbit.label), str(orbit.status), message)
        return FirstMotion(told, self.parameters, orbit)


def read_switches(texts: Sequence[str] | None) -> list[int] | None:
    """Numbers of special points, from 0; none without --switch; None: all of them."""
    found, problems = [], []
    for text in texts or ():
        digits = text.isascii() and text.isdigit() and len(text) < 6
        if text.casefold() == "all":
            return None
        if digits and int(text) >= 1:
            found.append(int(text) - 1)
        else:
            problems.append(Problem("--switch", repr(text), "the number of a special point, from 1, or all"))
    if problems:
        raise CaseError("--switch", problems)
    return list(dict.fromkeys(found))


def check_switches(branch: Branch, points: Sequence[int] | None) -> None:
    """Raises `CaseError` for numbers (from 0) of special points that a whole branch does not have."""
    from gearlash.branches.continuation import EndKind
    from gearlash.studies.switches import born_at

    count, cancelled = len(branch.special), any(end.kind is EndKind.CANCELLED for end in branch.ends)
    beyond = [i + 1 for i in points or () if i >= count]
    if not beyond or cancelled:
        return
    born = [str(i) for i, special in enumerate(branch.special, 1) if born_at(special)]
    many = f"{count} special point{'' if count == 1 else 's'}"
    where = f"other branches begin at {', '.join(born)}" if born else "no other branch begins at one of them"
    expected = (
        f"a special point of branch 1, which has {many}: {where}"
        if count
        else ("nothing: branch 1 has no special point")
    )
    raise CaseError("--switch", [Problem("--switch", str(i), expected) for i in beyond])


def read_zoom(case: Case, over: TypedLimits, zoom: str) -> tuple[float, float]:
    """The part of the interval that is drawn, dimensionless; without a unit it has that of --over."""
    expected = f"FROM:TO, a rising part of the interval of --over in the unit of {over.named}"
    wrong = CaseError("--zoom", [Problem("--zoom", repr(zoom), expected)])
    if zoom.count(":") != 1 or "=" in zoom:
        raise wrong
    unit = "" if behind_number(zoom.partition(":")[2].strip()) else over.unit
    try:
        found = read_between(case, f"{over.named}={zoom}{unit}")
    except CaseError as error:
        raise wrong from error
    if found.short != over.short or found.lower >= over.upper or found.upper <= over.lower:
        raise wrong
    return found.lower, found.upper


def steps_of(longest: float | None) -> ContinuationSettings:
    """The usual steps, or shorter or longer ones."""
    from gearlash.branches.continuation import ContinuationSettings

    usual = ContinuationSettings()
    return usual if longest is None else ContinuationSettings(min(usual.first, longest), longest=longest)


def _together(
    over: str | None,
    near: str | None,
    initial: Iterable[str] | None,
    resume: Path | None,
    at: int | None,
) -> list[Problem]:
    """What does not go together, or is missing."""
    found = []
    if over is None and resume is None:
        found.append(Problem("--over", None, "NAME=FROM:TO, such as omega=0.5:1.4; or --resume FILE"))
    if at is not None and resume is None:
        found.append(Problem("--at", repr(at), "--resume FILE with it, whose special point that is"))
    for option, given in (("--near", near), ("--initial", initial)):
        if given and resume is not None:
            found.append(
                Problem(option, repr(given), "only one of it and --resume: the file says where to begin")
            )
    return found


def _read(problems: list[Problem], case: Case, over: str) -> TypedLimits | None:
    """What is wrong with it joins the other problems."""
    try:
        return read_between(case, over)
    except CaseError as error:
        problems += error.problems
        return None


def near_value(case: Case, between: TypedLimits, near: str) -> dict[str, float]:
    """A value of the parameter as it stands in the case, without a unit in that of the limits. Raises
    `CaseError` for one of another parameter."""
    unit = "" if behind_number(near) else between.unit
    short, number = case.resolve(between.named, f"{near}{unit}")
    if short != between.short:
        raise CaseError("--near", [Problem("--near", repr(near), f"a value of {between.named}")])
    return {short: number}


def check_inside(
    case: Case, between: TypedLimits, value: float, how: str = " (--near gives another one)"
) -> None:
    """Raises `CaseError` where the value to begin at lies outside the limits."""
    from .answers.asked import Asked

    if between.lower <= value <= between.upper:
        return
    asked = Asked.of(case, between.short, between.named, between.unit)
    expected = f"an interval that holds the value to begin at, {asked.text(value)}{how}"
    ends = asked.reach(between.lower, between.upper)
    raise CaseError("--over", [Problem(f"--over {between.named}", ends, expected)])


def _resumed(
    case: Case, family: Family, between: TypedLimits | None, path: Path, at: int | None
) -> BranchInputs:
    """From a branch that was kept: as it is, or from one of its orbits."""
    from gearlash.results.branch_file import load_branch

    kept = load_branch(path)
    case, family = as_kept(case, kept.values)
    if set(kept.values) != set(family.defaults):
        raise CaseError("--resume", [Problem("--resume", repr(str(path)), "a branch of this case")])
    if at is not None and at > len(kept.special):
        expected = f"a special point of the file, which has {len(kept.special)}"
        raise CaseError("--at", [Problem("--at", repr(at), expected)])
    point = None if at is None else kept.special[at - 1].point
    if point is None and between is not None:
        point = min(kept.points, key=lambda each: abs(each.arclength))
    value = kept.values[kept.name] if point is None else point.value
    parameters = {**kept.values, kept.name: value}
    check_same(case, family.complete(), parameters, {kept.name})
    if between is None:
        own = [unit for where, _, unit in case.physical(kept.name, 1.0) if where == kept.name]
        between = TypedLimits(kept.name, kept.name, kept.lower, kept.upper, "".join(own))
    if point is not None:
        check_inside(case, between, parameters[between.short])
    return BranchInputs(case, family, between, parameters, kept=kept, point=point)


def as_kept(case: Case, kept: Iterable[str]) -> tuple[Case, Family]:
    """The case with what varies in a file beside the parameters of its model, where it has that."""
    for name in kept:
        if name not in case.family()[0].defaults:
            try:
                case = case.varying(name)
            except (CaseError, UnknownNameError):
                break  # it is a file of another case, which is told
    return case, case.family()[0]


def check_same(
    case: Case, here: Mapping[str, float], kept: Mapping[str, float], free: Container[str]
) -> None:
    """All parameters of the file that are not ``free`` are those of the case. Raises `CaseError` with each
    that is not."""
    problems = []
    for each, value in kept.items():
        size = max(abs(value), abs(here[each]), 1e-300)
        if each not in free and abs(value - here[each]) > SAME_VALUE * size:
            expected = f"{here[each]:.10g} as in the case; or --set {each}={value!r}"
            problems.append(Problem(f"--resume {each}", f"{value:.10g}", expected))
    if problems:
        raise CaseError("--resume", problems)
