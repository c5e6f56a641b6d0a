"""What `gearlash zones` does with two axes: the zone around the operating point in the plane of both."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from gearlash.case import Case, CaseError, Problem
from gearlash.system import GearlashError

from .exits import ExitCode

if TYPE_CHECKING:
    from gearlash.orbits import Settings as SearchSettings
    from gearlash.plots import Twin
    from gearlash.results.beside import Beside
    from gearlash.results.columns import Column
    from gearlash.studies.plane_zone import PlaneZone

    from .answers.plane_zone import PlaneZoneAnswer
    from .folder import OutFolder
    from .frame import StudyInputs
    from .inputs import TypedLimits
    from .tables import CsvAsked

FILES = ("zone.json", "zone.csv", "zone.svg", "zone.pdf")


def zone_in_plane(
    case: str,
    over: Sequence[str],
    kind: str | None,
    tolerance: Sequence[str] | None,
    settings: list[str] | None,
    initial: list[str] | None,
    search: tuple[int | None, int | None],
    as_json: bool,
    csv: CsvAsked,
    out: Path | None,
) -> ExitCode:
    """Reads, computes, keeps and shows it."""
    from .answers.asked import Asked
    from .answers.plane_zone import plane_zone_answer
    from .branch_inputs import check_inside
    from .frame import StudyInputs, deliver
    from .interrupt import optional, signalled

    limits: list[TypedLimits] = []

    def read_axes(chosen: Case) -> tuple[()]:
        limits.extend(_limits(chosen, over, settings))
        return ()

    asked = StudyInputs.read(case, settings, initial, over, read_axes)
    tolerances = _tolerances(asked.case, limits, tolerance)
    folder = asked.made_ready(out, FILES)
    units = tuple(Asked.of(asked.case, each.short, each.named, each.unit) for each in limits)
    for each in limits:
        check_inside(asked.case, each, asked.parameters[each.short], " (--set gives another one)")
    chosen = asked.search(*search)
    zone = _zone(asked, limits, kind, tolerances, chosen)
    beside = optional(lambda: _beside(asked, chosen))
    answer = plane_zone_answer(asked.case, zone, beside, (units[0], units[1]), bool(signalled()))

    def keep(folder: OutFolder) -> None:
        _write(folder, asked.case, zone, answer, csv)

    return deliver(answer, as_json, folder, keep, csv.printing(lambda: {"zone": _table(answer)}))


def _limits(case: Case, over: Sequence[str], settings: list[str] | None) -> list[TypedLimits]:
    from .inputs import read_between

    found, problems = [], []
    if len(over) == 1:  # it comes here for its --tolerance alone
        raise GearlashError(
            "--tolerance needs two --over, without numbers of points, such as --over omega=0.9:1.1 "
            "--over D=0.5:1.5: by what all tolerances together can be multiplied is told in a plane"
        )
    for text in over:
        try:
            found.append(read_between(case, text))
        except CaseError as error:
            problems += error.problems
    if len(over) != 2:
        problems.append(Problem("--over", f"{len(over)} given", "one, or two for a zone in a plane"))
    elif not problems and found[0].short == found[1].short:
        both = f"{found[0].named} and {found[1].named}"
        problems.append(Problem("--over", repr(both), "two that do not name the same quantity"))
    if problems:
        raise CaseError("--over", problems)
    return found


def _tolerances(
    case: Case, limits: Sequence[TypedLimits], texts: Sequence[str] | None
) -> dict[str, float] | None:
    """Of both parameters by short name. Raises `CaseError` for others."""
    from .inputs import assignments

    if not texts:
        return None
    typed, problems = assignments(texts, "--tolerance")
    found: dict[str, float] = {}
    for name, value in typed.items():
        short, number = case.resolve(name, value)
        if short in found or not number > 0.0:
            problems.append(Problem(f"--tolerance {name}", repr(value), "one positive tolerance a parameter"))
        found[short] = number
    expected = {each.short for each in limits}
    if not problems and set(found) != expected:
        names = " and ".join(each.named for each in limits)
        problems.append(Problem("--tolerance", ", ".join(typed), f"those of both parameters, {names}"))
    if problems:
        raise CaseError("--tolerance", problems)
    return found


def _zone(
    asked: StudyInputs,
    limits: Sequence[TypedLimits],
    kind: str | None,
    tolerances: dict[str, float] | None,
    search: SearchSettings,
) -> PlaneZone:
    from gearlash.jobs import Execution
    from gearlash.studies.plane_zones import plane_zone
    from gearlash.studies.point import point
    from gearlash.studies.zone_end import Quiet

    from .progress import progress_bar

    if kind is None:  # the stricter one that the motion here has
        here = point(asked.family, asked.parameters, start=asked.start, settings=search)
        kind = str(Quiet.IMPACT_FREE if here.impact_free else Quiet.DRIVE_SIDE_ONLY)
    one, two = limits
    with progress_bar("orbits") as progress:
        return plane_zone(
            asked.case, (one.short, two.short), lower=(one.lower, two.lower), upper=(one.upper, two.upper),
            quiet=kind, tolerances=tolerances, start=asked.start, settings=search,
            execution=Execution(progress=progress),
        )  # fmt: skip


def _beside(asked: StudyInputs, search: SearchSettings) -> Beside | None:
    """What other starts lead to at the operating point."""
    from gearlash.orbits import attractor
    from gearlash.studies.beside import motions_beside

    from .late import late_bar

    cold = asked.family.start(asked.parameters)
    start = list(cold) if asked.start is None else asked.start
    found = attractor(asked.family.system(asked.parameters), start, settings=search)
    with late_bar("other starts") as tell:
        named = dict(zip(asked.family.states, map(float, start), strict=True))
        return motions_beside(found, named, cold, settings=search, tell=tell)


def _write(folder: OutFolder, case: Case, zone: PlaneZone, answer: PlaneZoneAnswer, csv: CsvAsked) -> None:
    """The answer (JSON), the boundary (CSV), and the figure as SVG and PDF."""
    from gearlash.results.store import write_together

    from .files import at_what, draw_if
    from .jsonio import text

    contents = {
        folder.file("zone.json"): text(answer).encode("utf-8"),
        folder.file("zone.csv"): csv.content(_table(answer)),
    }
    write_together(contents, instead_of=folder.outdated("zone.json", FILES[2:]))
    twins, title = _twins(case, answer), f"Zone of {case.name} around its operating point{at_what(case)}"
    draw_if(folder, "zone", True, lambda plots: plots.zone_in_plane(zone, case, title=title, along=twins))


def _twins(case: Case, answer: PlaneZoneAnswer) -> list[Twin | None]:
    """The units that were asked for, for the axes of the figure; of a parameter that has one."""
    from .answers.parts import rests_in
    from .second_scale import second_scale

    return [
        second_scale(each, bool(rests_in(case, name, each.name, each.unit, computed=False)))
        for name, each in zip(answer.names, answer.asked, strict=True)
    ]


def _table(answer: PlaneZoneAnswer) -> list[Column]:
    """A row an orbit of the boundary: in the units that were asked for, and dimensionless."""
    from gearlash.results.columns import Column

    from .asked_columns import told_as_asked

    rows = [(i, part, values) for i, part in enumerate(answer.boundary, 1) for values in part.values]
    found = [
        Column("part", [i for i, _, _ in rows]),
        Column("kind", [part.kind for _, part, _ in rows]),
        Column("event", [part.event for _, part, _ in rows]),
    ]
    for k, (name, asked) in enumerate(zip(answer.names, answer.asked, strict=True)):
        own = [Column(name, [v[k] for _, _, v in rows])]
        found += told_as_asked(own, asked, (name,), asked.name)
    return found
