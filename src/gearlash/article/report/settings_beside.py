"""Every setting of the plan, and what the motion of real teeth was with it."""

from __future__ import annotations

from gearlash.article.verified import Verified, VerifiedWay
from gearlash.report.blocks import Block, Cell, Table
from gearlash.studies.verification.plan import AT_WINDOW
from gearlash.studies.verification.settings import PLANNED

from .seen import NOT_COMPUTED, motion


def blocks(found: Verified) -> list[Block]:
    """The table; nothing where no setting beside was computed."""
    if not any(way.beside for way in found.ways):
        return []
    names = [PLANNED.name, *dict.fromkeys(row[0] for way in found.ways for row in way.beside)]
    names += [name for each in found.settings if (name := each["name"]) not in (*names, AT_WINDOW.name)]
    ways = found.ways
    rows = tuple((name, *(_cell(way, name) for way in ways)) for name in names)
    return [
        Table(
            "table-verified-settings",
            "Every setting of the plan: the motion of real teeth at the lower speed, above, and at the "
            "higher one, with one thing changed. “Not repeating”: not within 1 %. “Impacts not repeating”: "
            "within 1 % in the mean forces, but not with as many impacts in every period. “×” and “/” are "
            f"factors of what the plan has; {NOT_COMPUTED} was not run with these inputs, or could not be "
            "integrated."
            f"{_plan(found)}",
            ("setting", *(way.name for way in ways)),
            rows,
            widths=(20, *(80 // len(ways) for _ in ways)),
        )
    ]


def _cell(way: VerifiedWay, name: str) -> Cell:
    """Motions at the speeds of a way, one below the other."""
    said: list[str] = []
    for point in way.points:
        if name == PLANNED.name:
            said.append(motion(point.label, point.apart))
            continue
        row = next((r for r in way.beside if r[0] == name and round(r[1]) == round(point.speed)), None)
        said.append(NOT_COMPUTED if row is None else motion(row[2], row[3]))
    return NOT_COMPUTED if set(said) == {NOT_COMPUTED} else [*said]


def _plan(found: Verified) -> str:
    """Steps and cycles of the plan, and those of the window."""
    said = [
        f" {words}: {each['solver']}, {each['steps']} steps a mesh cycle{_finer(each)}, "
        f"{each['settle']} mesh cycles to settle{_longer(found, each)} and {each['read']} that are read."
        for name, words in ((PLANNED.name, "The plan"), (AT_WINDOW.name, "The window"))
        for each in found.settings
        if each["name"] == name
    ]
    return "".join(said)


def _finer(each: dict[str, str]) -> str:
    return "" if each["finer"] == "1" else f" ({each['finer']} times as many in those that are read)"


def _longer(found: Verified, each: dict[str, str]) -> str:
    """How many motions had not come back after one mesh cycle and were given more, and how many at most."""
    if int(each["longest"]) == 1:
        return ""
    cycles = [row[2] for way in found.ways for row in way.settled]
    longer = sum(count > int(each["settle"]) for count in cycles)
    if not longer:
        return f" (enough for all {len(cycles)} motions of this table)"
    return (
        f" (more, {max(cycles)} at most, for {longer} of the {len(cycles)} motions of this table: of those "
        "that had not come back after one cycle, the ones in which the slowest vibration of bodies had not "
        "faded yet)"
    )
