"""What follows of the pair with real teeth, as the data say, and on what that rests."""

from __future__ import annotations

from gearlash.article import Reproduction
from gearlash.article.verified import REPORTED, Verified, VerifiedPoint, VerifiedWay
from gearlash.article.verifying import RELIEF
from gearlash.report.blocks import Block, Bullets, Note, Text
from gearlash.report.numbers import number

from . import lumped_beside, window
from .seen import HELD, motion, parts, share
from .teeth import told

Row = tuple[str, float, str, float]
"""Setting, speed, label, share of time apart."""
AS_STATED = "bearings as stated"
NUMBERS = ("error over static deflection", "half backlash over static deflection")
FITTED = (
    "Bearing damping, phase of the error, load and error come from fits of the lumped model to numbers of "
    "the article; the backlash in µm, on which torque and error in SI rest, is assumed, and so are bearings "
    "along the line of centres and against tilt."
)
END = (
    "The article leaves torque, error and backlash open, and states a stiffness that unmodified teeth of "
    "the stated size do not have: so this neither confirms nor refutes its simulation, whose inputs are "
    "not known."
)


def blocks(found: Verified, done: Reproduction) -> list[Block]:
    """Conclusion, what it rests on, how both models compare, harmonics, and when everything was fixed."""
    rests = [*(_rests_on(found, way) for way in found.ways), *_stated_bearings(found), FITTED]
    return [
        Note(_conclusion(found), "Conclusion"),
        Text.of("What the conclusion rests on:"),
        Bullets(tuple(Text.of(part) for part in rests if part)),
        *lumped_beside.blocks(found, done),
        _harmonics(found),
        Text.of("The run was not strictly blind:"),
        fixed_when(),
    ]


def agreeing(found: Verified) -> list[VerifiedWay]:
    """The ways in which real teeth do at both speeds as the article reports: the same label where they part,
    and contact that stays where it stays there."""

    def is_so(point: VerifiedPoint, reported: str) -> bool:
        if parts(reported, None):
            return point.label == reported
        return not parts(point.label, point.apart)

    return [way for way in found.ways if all(map(is_so, way.points, REPORTED))]


def in_short(found: Verified) -> str:
    """One clause: with how many ways to hold the inputs both reported motions were found."""
    agree = [way.name for way in agreeing(found)]
    held = [way.name for way in found.ways if way.name in HELD]
    said = (
        f"real teeth part and stay in contact as the article reports with {len(agree)} of {len(found.ways)} "
        "ways to hold the inputs"
    )
    if not held:
        return said
    with_held = sum(name in HELD for name in agree)
    return f"{said}, and with {with_held} of the {len(held)} that hold the dimensionless numbers"


def _conclusion(found: Verified) -> Text:
    """What disagrees comes first: the ways that hold the article's numbers."""
    agree = agreeing(found)
    said = [
        f"In short: {in_short(found)}.",
        _with_numbers_held(found),
        *(_both_beside(way) for way in found.ways if way not in agree),
        *(_in_numbers(found, way) for way in agree),
        "" if agree else "With none of the inputs do teeth at both speeds as is reported.",
        END,
    ]
    return Text.of(" ".join(part for part in said if part))


def _motions(way: VerifiedWay) -> str:
    """Label and least force at each speed."""
    return " and ".join(
        f"{told(p.label)} at {p.speed:.0f} rpm (force at least {number(p.least, 2)} of its mean)"
        if not parts(p.label, p.apart)
        else f"{told(p.label)} at {p.speed:.0f} rpm (apart {share(p.apart)} of the time)"
        for p in way.points
    )


def _with_numbers_held(found: Verified) -> str:
    ways = [way for way in found.ways if way.name in HELD]
    if not ways:
        return ""
    moves = "; ".join(f"“{way.name}”: {_motions(way)}" for way in ways)
    told_so = [_as_reported(ways, index, reported) for index, reported in enumerate(REPORTED)]
    return (
        f"With the dimensionless numbers of the case held, the ripple of the stiffness excepted: "
        f"{'; '.join(told_so)} ({moves})."
    )


def _as_reported(ways: list[VerifiedWay], index: int, reported: str) -> str:
    """Of one speed, the lower or the higher: whether teeth part in these ways, beside what is reported."""
    points = [way.points[index] for way in ways]
    parting = sum(parts(point.label, point.apart) for point in points)
    count = len(points)
    which = ("at the lower speed", "at the higher speed")[index]
    if parts(reported, None):
        return f"{which} {reported[:-2]} is reported, and real teeth part with {parting} of {count} inputs"
    stay = count - parting
    return f"{which} {reported[:-2]} is reported, and real teeth stay in contact with {stay} of {count}"


def _both_beside(way: VerifiedWay) -> str:
    """Settings beside with which a way that does not agree has both reported motions."""
    lower, higher = ({row[0]: row for row in _rows(way, point)} for point in way.points)
    with_both = [
        name
        for name in lower
        if name in higher and lower[name][2] == REPORTED[0] and not parts(higher[name][2], higher[name][3])
    ]
    if not with_both:
        return ""
    has = "has" if len(with_both) == 1 else "have"
    return (
        f"Of {len(lower)} settings beside, each with one change, {len(with_both)} {has} both reported "
        f"motions with “{way.name}”: {', '.join(with_both)}."
    )


def _in_numbers(found: Verified, way: VerifiedWay) -> str:
    """Where a way agrees: in which numbers, and how far its dimensionless ones are from those of the case."""
    said = f"Teeth part and stay in contact as reported with the inputs “{way.name}” ({_motions(way)})"
    case = next((each for each in found.ways if each.name == HELD[0]), None)
    if case is None or way.name in HELD:
        return f"{said}.{_unsettled(way)}"
    error, play = ((way.numbers[name], case.numbers[name]) for name in NUMBERS)
    omegas = [" and ".join(f"{p.omega:.3f}" for p in each.points) for each in (way, case)]
    return (
        f"{said}, which hold the numbers in SI and not the dimensionless ones: the error is "
        f"{number(error[0], 3)} static deflections of the mesh, half the backlash {number(play[0], 3)}, the "
        f"mesh frequency {omegas[0]} of that of the mesh, where the case has {number(error[1], 3)}, "
        f"{number(play[1], 3)}, and {omegas[1]}: the labels agree, at another place beside the resonance of "
        f"the mesh than the reported one.{_unsettled(way)}{window.beside_points(way)}"
    )


def _unsettled(way: VerifiedWay) -> str:
    """Where contact is kept as reported and the period is not found."""
    speeds = [
        f"{p.speed:.0f} rpm"
        for p, reported in zip(way.points, REPORTED, strict=True)
        if not parts(reported, None) and not parts(p.label, p.apart) and p.label != reported
    ]
    if not speeds:
        return ""
    return (
        f" The force that the article reports repeats every mesh cycle; within 1 % that was not found at "
        f"{', '.join(speeds)}."
    )


def _rests_on(found: Verified, way: VerifiedWay) -> str:
    """What else is to be known of a way, and what the settings beside do to the motion of each speed, whether
    it is the reported one or not."""
    said = [f"{_motions(way)}{_near(found, way)}.{window.coexisting(way)}"] if _other(found, way) else []
    beside = [each for point in way.points if (each := _beside(way, point))]
    if beside:
        ran, most = (len({row[0] for row in each.beside} - {AS_STATED}) for each in (way, _most(found)))
        rest = (
            f" The other {most - ran} settings were not run, or not integrated, with these inputs."
            if ran < most
            else ""
        )
        said.append(f"One assumption or setting changed at a time: {'; '.join(beside)}.{rest}")
    return f"“{way.name}”: {' '.join(said)}" if said else ""


def _most(found: Verified) -> VerifiedWay:
    """The way with the most settings beside."""
    return max(found.ways, key=lambda way: len(way.beside))


def _rows(way: VerifiedWay, point: VerifiedPoint) -> list[Row]:
    """Settings beside at one speed, those with other inputs apart."""
    return [row for row in way.beside if round(row[1]) == round(point.speed) and row[0] != AS_STATED]


def _beside(way: VerifiedWay, point: VerifiedPoint) -> str:
    """With how many settings the motion of one speed stays what it is, and with which it does not."""
    rows = _rows(way, point)
    if not rows:
        return ""
    apart, where = parts(point.label, point.apart), f"at {point.speed:.0f} rpm"
    alike = [row for row in rows if parts(row[2], row[3]) == apart]
    if not apart:
        return f"{where} contact is kept with {len(alike)} of {len(rows)}{_listed(rows, alike)}"
    said = f"{where} teeth part with {len(alike)} of {len(rows)}"
    if point.label.count("-") != 2:
        return f"{said}{_listed(rows, alike)}"
    named = [row for row in alike if row[2] == point.label]
    return f"{said}, and the label is {point.label} with {len(named)}{_listed(rows, named)}"


def _listed(rows: list[Row], alike: list[Row]) -> str:
    """Which settings do not as planned, or which do, where these are fewer; all settings where there are few.
    The table of settings has the others."""
    names = [row[0] for row in alike]
    others = [f"{row[0]} ({motion(row[2], row[3])})" for row in rows if row not in alike]
    if not others:
        return f" ({', '.join(names)})" if len(names) <= FEW else ""
    if len(names) < len(others):
        return f" (with {', '.join(names)})" if names else ""
    return f" (not with {', '.join(others)})"


FEW = 3
"""Names that may stand in a bracket where nothing differs."""


def _other(found: Verified, way: VerifiedWay) -> bool:
    """Whether the conclusion itself says nothing of a way: one that was not made to hold dimensionless
    numbers, and that does not agree."""
    return way.name not in HELD and way not in agreeing(found)


def _stated_bearings(found: Verified) -> list[str]:
    """Bearings that are not scaled with the mesh."""
    stated = [
        f"{motion(label, apart)}, at {speed:.0f} rpm"
        for way in found.ways
        for setting, speed, label, apart in way.beside
        if setting == AS_STATED
    ]
    if not stated:
        return []
    return [
        "“dimensionless” with bearings as the case states them, so that they are softer beside the mesh "
        "than in "
        f"the case: {' and '.join(stated)}."
    ]


def _near(found: Verified, way: VerifiedWay) -> str:
    """How far the dimensionless numbers of a way are from those of the case, where that is little."""
    case = next((each for each in found.ways if each.name == HELD[0]), None)
    if case is None:
        return ""
    pairs = [(way.numbers[name], case.numbers[name]) for name in NUMBERS]
    pairs += [(one.omega, other.omega) for one, other in zip(way.points, case.points, strict=True)]
    off = max(abs(one / other - 1.0) for one, other in pairs)
    if off > NEAR:
        return ""
    twice = way.ripples[1] > max(way.ripples[0], way.ripples[2])
    ripple = ", and the stiffness varies mostly twice a mesh cycle, as that of the case" if twice else ""
    return f"; the dimensionless numbers are within {share(off)} of those of the case{ripple}"


NEAR = 0.05
"""Relative, of the dimensionless numbers of a way to those of the case: what is worth telling."""


def ripples(way: VerifiedWay) -> str:
    """The first two harmonics of the stiffness."""
    return f"{share(way.ripples[0])} and {share(way.ripples[1])}"


def _harmonics(found: Verified) -> Text:
    plain = [way for way in found.ways if way.name != "modified"]
    turned = [way for way in found.ways if way.name == "modified" and way.ripples[1] > way.ripples[0]]
    said = (
        "The stiffness that the case assumes, found by a fit, varies twice a mesh cycle. That of unmodified "
        "real teeth "
        "varies mostly once: "
        + "; ".join(f"{ripples(way)} at {number(way.face_width, 3)} mm" for way in plain[:2])
    )
    if not turned:
        return Text.of(f"{said}.")
    return Text.of(
        f"{said}. Strong modification at this light load turns it round: relief of both tips by "
        f"{RELIEF['tip'] * 1e6:.0f} µm over {RELIEF['length'] * 1e3:.3g} mm of roll and crowning of "
        f"{RELIEF['crowning'] * 1e6:.0f} µm give {ripples(turned[0])}, and at "
        f"{number(turned[0].face_width, 3)} mm bring the mean "
        f"stiffness down to {number(turned[0].stiffness / 1e8, 3)}·10⁸ N/m."
    )


FIXED = (
    (
        "Before anything was computed",
        "flanks, masses, bearings across and along the shafts, torque, error, backlash and damping of the "
        "case; "
        "the inputs “stiffness”, “dimensionless” and “absolute”; both speeds and the grid of the window; "
        "bearings "
        "along the line of centres as stiff as across it, 150 mm between the bearings of a shaft; the "
        "settings "
        "of bearings, centre line, phase of the error, damping, step and solver; what a label means",
    ),
    (
        "After motions with a rigid gear had been seen",
        "a gear that bends as the planned one; 192 steps a mesh cycle; the setting with the centre distance "
        "held; "
        "modified flanks, found by a search for stiffness and harmonics, not for a motion",
    ),
    (
        "After the findings of a second reader",
        "bearings that grow with the mesh in “dimensionless” (before they stayed as stated, which now is a "
        "setting beside); modified flanks as stiff as the case says and run at its speeds; the settings "
        "beside "
        "with the inputs “absolute”; a pinion that bends; 80 mesh cycles in place of 60 before a motion is "
        "read, "
        "and three times the steps while it is; the error that relief makes, for the lumped model",
    ),
    (
        "After the findings of a third reader",
        "torque, bearings and speeds of “dimensionless” from the stiffness under its own torque; every "
        "setting with each of the inputs that are not modified; error and torque changed by a tenth",
    ),
)


def fixed_when() -> Bullets:
    """The run was not strictly blind: what was fixed before what was seen."""
    return Bullets(tuple(Text.of(f"{when}, these were fixed: {what}.") for when, what in FIXED))
