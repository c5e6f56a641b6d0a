"""What follows of the pair with real teeth, as the data say: what agrees with what, and on what that "
"rests."""

from __future__ import annotations

from collections.abc import Iterable

from gearlash.article.verified import REPORTED, Verified, VerifiedPoint, VerifiedWay
from gearlash.article.verifying import RELIEF
from gearlash.report.blocks import Block, Bullets, Note, Text
from gearlash.report.numbers import number

from .teeth import told

RULES = ("always", "in-contact", "no-tension")
HELD = ("stiffness", "dimensionless")
"""The ways in which all dimensionless numbers but the ripple of the stiffness are those of the case."""
AS_STATED = "bearings as stated"
NUMBERS = ("error over static deflection", "half backlash over static deflection")
FITTED = (
    "Bearing damping, phase of the error, load and error come from fits of the lumped model to numbers of "
    "the "
    "article; bearings along the line of centres and against tilt are assumed."
)


def blocks(found: Verified) -> list[Block]:
    """Conclusion, how both models compare, harmonics, and when everything was fixed."""
    return [
        Note(_conclusion(found), "Conclusion"),
        Text.of(_models(found)),
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


def _conclusion(found: Verified) -> Text:
    """What disagrees comes first: the ways that hold the article's numbers."""
    agree = agreeing(found)
    said = [
        _with_numbers_held(found),
        *(_in_numbers(found, way) for way in agree),
        *(_rests_on(way) for way in agree),
        "" if agree else "With none of the inputs do teeth at both speeds as is reported.",
        _other_ways(found),
        FITTED,
        "The article leaves torque, error and backlash open, and states a stiffness that unmodified teeth of "
        "the stated size do not have: so this neither confirms nor refutes its simulation, whose inputs are "
        "not known.",
    ]
    return Text.of(" ".join(part for part in said if part))


def quoted(names: Iterable[str]) -> str:
    """Names of ways in quotation marks."""
    return ", ".join(f"“{name}”" for name in names)


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
        f"With the article’s dimensionless numbers held, the ripple of the stiffness excepted, "
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


def _in_numbers(found: Verified, way: VerifiedWay) -> str:
    """Where a way agrees: in which numbers, and how far its dimensionless ones are from those of the case."""
    said = f"Teeth part and stay in contact as reported with the inputs “{way.name}” ({_motions(way)})"
    case = next((each for each in found.ways if each.name == HELD[0]), None)
    if case is None or way.name in HELD:
        return f"{said}."
    error, play = ((way.numbers[name], case.numbers[name]) for name in NUMBERS)
    omegas = [" and ".join(f"{p.omega:.3f}" for p in each.points) for each in (way, case)]
    window = f" On the grid of speeds teeth stay in contact from {way.up}, speed rising." if way.up else ""
    return (
        f"{said}, which hold the numbers in SI and not the dimensionless ones: the error is "
        f"{number(error[0], 3)} static deflections of the mesh, half the backlash {number(play[0], 3)}, the "
        f"mesh frequency {omegas[0]} of that of the mesh, where the case has {number(error[1], 3)}, "
        f"{number(play[1], 3)}, and {omegas[1]}.{window}"
    )


def _rests_on(way: VerifiedWay) -> str:
    """With which settings an agreement is lost, at each speed."""
    said = []
    for point in way.points:
        rows = [row for row in way.beside if round(row[1]) == round(point.speed)]
        apart = parts(point.label, point.apart)
        lost = [
            f"{setting} ({told(label)})"
            for setting, _, label, share_apart in rows
            if parts(label, share_apart) != apart or (apart and label != point.label)
        ]
        if rows:
            which = f"label {point.label}" if apart else "contact"
            names = f": {'; '.join(lost)}" if lost else ""
            said.append(
                f"the {which} at {point.speed:.0f} rpm is lost with {len(lost)} of {len(rows)} settings "
                "beside"
                f"{names}"
            )
    return f"With “{way.name}” {'. There '.join(said)}." if said else ""


def _other_ways(found: Verified) -> str:
    """Ways that hold nothing dimensionless and do not agree, and bearings that are not scaled."""
    agree = agreeing(found)
    others = [way for way in found.ways if way.name not in HELD and way not in agree]
    said = [f"With “{way.name}”: {_motions(way)}." for way in others]
    stated = [
        f"{told(label)} at {speed:.0f} rpm"
        for way in found.ways
        for setting, speed, label, _ in way.beside
        if setting == AS_STATED
    ]
    if stated:
        said.append(
            "Where bearings stay as the case states them while torque and speed grow with the mesh, so that "
            "they "
            f"are softer beside it than in the case: {' and '.join(stated)}."
        )
    return " ".join(said)


def parts(label: str, apart: float | None) -> bool:
    """Whether teeth part: by the label, or of a motion without one whether they were seen apart. An aperiodic
    motion of the lumped model parts, as one without contact events would be periodic."""
    if label.count("-") == 2:
        return not label.endswith("-0-0")
    return label == "aperiodic" or bool(apart)


def same(points: list[VerifiedPoint], rule: str) -> int:
    """How often both models agree on whether teeth part at all."""
    return sum(
        parts(p.label, p.apart) == parts(p.lumped.get(rule, ""), p.lumped_apart.get(rule)) for p in points
    )


def _models(found: Verified) -> str:
    """How the lumped model compares at the same inputs."""
    points = [p for way in found.ways for p in way.points]
    count = len(points)
    parting = ", ".join(f"{same(points, rule)} under “{rule}”" for rule in RULES)
    labels = ", ".join(f"{sum(p.lumped.get(rule) == p.label for p in points)}" for rule in RULES)
    differs = [
        f"“{way.name}” {direction} at {', '.join(f'{speed:.0f}' for speed in speeds)} rpm"
        for way in found.ways
        for direction, speeds in zip(
            ("rising", "falling"), way.apart_differs.get(RULES[0], [[], []]), strict=True
        )
        if speeds
    ]
    on_grid = (
        f" On the grid of speeds one of both parts and the other does not under “{RULES[0]}” with "
        f"{'; '.join(differs)}."
        if differs
        else ""
    )
    return (
        f"The lumped model, given what real teeth have, agrees with them on whether teeth part at so many of "
        f"{count} points: {parting}; on the full label at {labels}.{on_grid}{_forces(found)}"
    )


def _forces(found: Verified) -> str:
    """Where both models part, how far apart their forces are."""
    rule = RULES[0]
    rows = [
        f"“{way.name}” at {p.speed:.0f} rpm: apart {share(p.apart)} of the time, greatest force "
        f"{number(p.peak, 3)} of the mean with real teeth; {share(p.lumped_apart[rule] or 0.0)} and "
        f"{number(p.lumped_peak[rule], 3)} in the lumped model"
        for way in found.ways
        for p in way.points
        if parts(p.label, p.apart) and parts(p.lumped[rule], p.lumped_apart[rule])
    ]
    return f" The same answer is not the same force: {'; '.join(rows)}." if rows else ""


def share(part: float) -> str:
    """A share in per cent."""
    return f"{100.0 * part:.3g} %"


def ripples(way: VerifiedWay) -> str:
    """The first two harmonics of the stiffness."""
    return f"{share(way.ripples[0])} and {share(way.ripples[1])}"


def _harmonics(found: Verified) -> Text:
    plain = [way for way in found.ways if way.name != "modified"]
    turned = [way for way in found.ways if way.name == "modified" and way.ripples[1] > way.ripples[0]]
    said = (
        "The stiffness that the case had to assume varies twice a mesh cycle. That of unmodified real teeth "
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
)


def fixed_when() -> Bullets:
    """The run was not strictly blind: what was fixed before what was seen."""
    return Bullets(tuple(Text.of(f"{when}, these were fixed: {what}.") for when, what in FIXED))
