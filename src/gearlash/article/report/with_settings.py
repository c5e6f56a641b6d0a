"""What settings beside the planned one do, in sentences; the table of settings has every motion."""

from __future__ import annotations

from gearlash.article.verified import REPORTED, Verified, VerifiedPoint, VerifiedWay
from gearlash.report.numbers import number

from .seen import HELD, case_itself, has_label, motion, parts
from .words import joined

Row = tuple[str, float, str, float]
"""Setting, speed, label, share of time apart."""
FASTER = 1.05
"""Speed over that of the case: what is worth telling."""
FEW = 3
"""Names that may stand in a bracket where nothing differs."""


def as_reported(label: str, apart: float, reported: str) -> bool:
    """Whether a motion is the reported one: the same label where teeth part, and contact where they stay."""
    return label == reported if parts(reported, None) else not parts(label, apart)


def rows_at(way: VerifiedWay, point: VerifiedPoint) -> list[Row]:
    """Settings beside at one speed."""
    return [row for row in way.beside if round(row[1]) == round(point.speed)]


def both_motions(found: Verified) -> str:
    """With how many settings beside a way has the reported motion at both speeds."""
    ways = [way for way in found.ways if way.beside]
    if not ways:
        return ""
    most = max(len(rows_at(way, way.points[0])) for way in ways)
    said = []
    for way in ways:
        have, ran = with_both(way), len(rows_at(way, way.points[0]))
        names = f" ({', '.join(have)})" if 0 < len(have) <= FEW else ""
        of = f"{ran}" if 2 * ran > most else f"the {ran} run"
        said.append(f"{len(have)} of {of} with “{way.name}”{names}")
    return f"Settings beside with both reported motions: {', '.join(said)}."


def with_both(way: VerifiedWay) -> list[str]:
    """Names of the settings with which each speed has the reported motion."""
    at = [{row[0]: row for row in rows_at(way, point)} for point in way.points]
    return [
        name
        for name in at[0]
        if all(
            name in rows and as_reported(*rows[name][2:], reported)
            for rows, reported in zip(at, REPORTED, strict=True)
        )
    ]


def both_bending(found: Verified, agree: list[VerifiedWay]) -> str:
    """What a pinion that bends, beside a gear that does, leaves of both motions."""
    names = {each["name"] for each in found.settings if each["flexible"] == each["flexible_pinion"] == "True"}
    tried = [(way, rows) for way in found.ways if len(rows := _named(way, names)) == len(way.points)]
    if not tried:
        return ""
    has = sum(bool(names & {*with_both(way)}) for way, _ in tried)
    moves = "; ".join(
        f"“{way.name}”{_turned(way, rows, way in agree)} {_moves(way, rows)}" for way, rows in tried
    )
    return (
        "The article’s simulation has flexible bodies. With a pinion that bends, too, "
        f"{has} of the {len(tried)} inputs tried {'has' if has == 1 else 'have'} both motions: {moves}. "
        f"The shaft of that pinion is assumed{_nearer(found, [way for way, _ in tried])}."
    )


def _nearer(found: Verified, tried: list[VerifiedWay]) -> str:
    """Ways that hold ω and run faster than the case, whose bodies ring as before."""
    case = case_itself(found)
    if case is None:
        return ""
    times = [(way.name, way.points[0].speed / case.points[0].speed) for way in tried if way.name in HELD]
    faster = [f"with “{name}” {number(ratio, 3)} times as high" for name, ratio in times if ratio > FASTER]
    if not faster:
        return ""
    return (
        ". Modes of bodies keep their Hz: beside them the mesh frequency is higher than in the case, "
        f"{joined(faster)}"
    )


def _named(way: VerifiedWay, names: set[str]) -> list[Row]:
    """The row of each speed with a setting of such a name."""
    return [row for point in way.points for row in rows_at(way, point) if row[0] in names]


def _moves(way: VerifiedWay, rows: list[Row]) -> str:
    motions = ["parting" if parts(row[2], row[3]) else "contact" for row in rows]
    if len(set(motions)) == 1:
        return f"{motions[0]} at both speeds"
    speeds = [f"{point.speed:.0f} rpm" for point in way.points]
    return joined([f"{what} at {speed}" for what, speed in zip(motions, speeds, strict=True)])


def _turned(way: VerifiedWay, rows: list[Row], agrees: bool) -> str:
    """Beside what is reported, and beside the rigid pinion."""
    apart = [parts(row[2], row[3]) for row in rows]
    reported = [parts(each, None) for each in REPORTED]
    if all(one != other for one, other in zip(apart, reported, strict=True)):
        return " has the reverse,"
    return " loses its agreement," if agrees and apart != reported else " has"


def one_changed(way: VerifiedWay) -> str:
    """With how many settings the motion of each speed stays what it is, and with which it does not."""
    beside = "; ".join(each for point in way.points if (each := _at_speed(way, point)))
    return f" {beside}." if beside else ""


def _at_speed(way: VerifiedWay, point: VerifiedPoint) -> str:
    rows = rows_at(way, point)
    if not rows:
        return ""
    apart, where = parts(point.label, point.apart), f"at {point.speed:.0f} rpm"
    alike = [row for row in rows if parts(row[2], row[3]) == apart]
    if not apart:
        return f"{where} contact is kept with {len(alike)} of {len(rows)}{_listed(rows, alike)}"
    said = f"{where} teeth part with {len(alike)} of {len(rows)}"
    if not has_label(point.label):
        return f"{said}{_listed(rows, alike)}"
    named = [row for row in alike if row[2] == point.label]
    return f"{said}, and the label is {point.label} with {len(named)}{_listed(rows, named)}"


def _listed(rows: list[Row], alike: list[Row]) -> str:
    """Which settings do not as planned, or which do, where these are fewer; all settings where there are
    few."""
    names = [row[0] for row in alike]
    others = [f"{row[0]} ({motion(row[2], row[3])})" for row in rows if row not in alike]
    if not others:
        return f" ({', '.join(names)})" if len(names) <= FEW else ""
    if len(names) < len(others):
        return f" (with {', '.join(names)})" if names else ""
    return f" (not with {', '.join(others)})"
