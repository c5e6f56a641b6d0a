"""What follows of the pair with real teeth, as the data say, and on what that rests."""

from __future__ import annotations

from collections.abc import Sequence

from gearlash.article import Reproduction
from gearlash.article.verified import REPORTED, Verified, VerifiedPoint, VerifiedWay
from gearlash.article.verifying import RELIEF
from gearlash.case import Case
from gearlash.report.blocks import Block, Bullets, Note, Text
from gearlash.report.numbers import number

from . import lumped_beside, window, with_settings
from .seen import HELD, MODIFIED, UNEVEN, case_itself, parts, share
from .when_fixed import when_fixed
from .words import joined

ERROR, PLAY = "error over static deflection", "half backlash over static deflection"
BEARINGS, STIFFNESS = "bearings over those of the case", "stiffness over that of the case"
FITTED = (
    "Bearing damping, phase of the error, load and error come from fits of the lumped model to numbers of "
    "the article. The backlash in µm, on which torque and error in SI rest, is assumed, and so are bearings "
    "along the line of centres and against tilt, and the shaft of a pinion that bends. Face widths and "
    "inertias are inferred from the masses as solid discs, so the speeds in rpm, too. The tooth profile is a "
    "standard one, not shifted."
)
END = (
    "The article leaves torque, error and backlash open, and states a stiffness that unmodified teeth as "
    "wide as its masses ask for do not have here: so this neither confirms nor refutes its simulation, whose "
    "inputs are not known."
)
READ_ANEW = (
    " as mesh cycles are compared now (by mean forces). As they were compared before (at single places), "
    "none did in the last data (computed by commit fedb86e); in the first data “absolute” did"
)
COUNTED = (
    f"That asks for the label {REPORTED[0]} at the lower speed, and for contact at the higher one, with a "
    "label or without."
)
NEAR = 0.05
"""Relative, of the dimensionless numbers of a way to those of the case: what is worth telling."""


def blocks(found: Verified, done: Reproduction) -> list[Block]:
    """Conclusion, what it rests on, how both models compare, harmonics, and when everything was fixed."""
    rests = [*(_rests_on(found, way) for way in found.ways), FITTED]
    return [
        Note(_conclusion(found), "Conclusion"),
        *_with_other_numbers(found, done.case),
        Text.of("What the conclusion rests on, one assumption or setting changed at a time:"),
        Bullets(tuple(Text.of(part) for part in rests if part)),
        *lumped_beside.blocks(found, done),
        _harmonics(found),
        Text.of("The run was not strictly blind:"),
        when_fixed(),
    ]


def agreeing(found: Verified) -> list[VerifiedWay]:
    """The ways in which real teeth do at both speeds as the article reports."""

    def is_so(point: VerifiedPoint, reported: str) -> bool:
        return with_settings.as_reported(point.label, point.apart, reported)

    return [way for way in found.ways if all(map(is_so, way.points, REPORTED))]


def by_label(found: Verified) -> list[VerifiedWay]:
    """The ways in which both labels are those that the article reports."""
    return [way for way in found.ways if tuple(point.label for point in way.points) == REPORTED]


def in_short(found: Verified) -> str:
    """One clause: with how many ways to hold the inputs both reported motions were found, and at which ω."""
    agree = agreeing(found)
    elsewhere = [f"“{way.name}” at ω {_omegas(way)}" for way in agree if way.name not in HELD]
    held = [way for way in found.ways if way.name in HELD]
    said = (
        f"real teeth part and stay in contact as the article reports with {len(agree)} of {len(found.ways)} "
        "ways to hold the inputs, begun with teeth pressed together"
    )
    if elsewhere:
        said += f" ({joined(elsewhere)}, not at the reported ω)"
    if not held:
        return said
    with_held = sum(way in agree for way in held)
    return f"{said}, and with {with_held} of the {len(held)} that hold the dimensionless numbers"


def _omegas(way: VerifiedWay) -> str:
    return " and ".join(f"{point.omega:.3f}" for point in way.points)


def _conclusion(found: Verified) -> Text:
    """What disagrees comes first: the ways that hold the article's numbers."""
    agree = agreeing(found)
    said = [
        f"In short: {in_short(found)}. {COUNTED}",
        f"By the label alone, the rule at first, {len(by_label(found))} of {len(found.ways)} agree"
        f"{READ_ANEW}.",
        _with_numbers_held(found),
        with_settings.both_motions(found),
        with_settings.both_bending(found, agree),
        "" if agree else "With none of the inputs do teeth at both speeds as is reported.",
        END,
    ]
    return Text.of(" ".join(part for part in said if part))


def _with_other_numbers(found: Verified, case: Case) -> list[Note]:
    """The ways that agree, and those that were not made to hold the article's dimensionless numbers."""
    agree = agreeing(found)
    said = [_in_numbers(found, way) for way in agree]
    said += [_otherwise(found, way, case) for way in found.ways if way.name not in HELD and way not in agree]
    return [Note(Text.of(" ".join(said)), "With other inputs")] if said else []


def _how(points: Sequence[VerifiedPoint]) -> str:
    """How long teeth are apart, or how near they come to it."""
    if not any(parts(point.label, point.apart) for point in points):
        return f"force at least {joined([number(point.least, 2) for point in points])} of its mean"
    if len(points) == 1:
        return f"apart {share(points[0].apart)} of the time"
    return joined([_how([point]) for point in points])


def _uneven(point: VerifiedPoint) -> str:
    """Of a motion whose force comes back, and not the number of its impacts."""
    if point.label != UNEVEN:
        return ""
    return (
        f" (mean forces come back within {share(point.returns)}, but with {number(point.impacts, 3)} "
        "beginnings of contact a mesh cycle: no label)"
    )


def _moves(way: VerifiedWay) -> str:
    return joined([f"{_how([point])} at {point.speed:.0f} rpm{_uneven(point)}" for point in way.points])


def _with_numbers_held(found: Verified) -> str:
    ways = [way for way in found.ways if way.name in HELD]
    if not ways:
        return ""
    names = joined([f"“{way.name}”" for way in ways])
    told_so = "; ".join(_at_speed(ways, index, reported) for index, reported in enumerate(REPORTED))
    return (
        f"With the dimensionless numbers of the case held ({names}), the ripple of the stiffness excepted: "
        f"{told_so}."
    )


def _at_speed(ways: list[VerifiedWay], index: int, reported: str) -> str:
    """Of one speed, the lower or the higher: whether teeth part in these ways, beside what is reported."""
    points = [way.points[index] for way in ways]
    parting = sum(parts(point.label, point.apart) for point in points)
    which = ("at the lower speed", "at the higher speed")[index]
    do, count = ("part", parting) if parts(reported, None) else ("stay in contact", len(points) - parting)
    return (
        f"{which} {reported[:-2]} is reported, and real teeth {do} with {count} of {len(points)} inputs "
        f"({_how(points)})"
    )


def _in_numbers(found: Verified, way: VerifiedWay) -> str:
    """Where a way agrees: in which numbers, and how far its dimensionless ones are from those of the case."""
    said = f"Teeth part and stay in contact as reported with the inputs “{way.name}” ({_moves(way)})"
    case = case_itself(found)
    if case is None or way.name in HELD:
        return f"{said}."
    error, play = ((way.numbers[name], case.numbers[name]) for name in (ERROR, PLAY))
    return (
        f"{said}, which hold the numbers in SI and not the dimensionless ones: the error is "
        f"{number(error[0], 3)} static deflections of the mesh, half the backlash {number(play[0], 3)}, the "
        f"mesh frequency {_omegas(way)} of that of the mesh, where the case has {number(error[1], 3)}, "
        f"{number(play[1], 3)}, and {_omegas(case)}. So {_what_agrees(way)}, not at the reported "
        f"ω{_softer(way)}; which resonance acts there was not examined."
    )


def _what_agrees(way: VerifiedWay) -> str:
    """Label or contact, at each speed."""
    speeds = [f"{point.speed:.0f} rpm" for point in way.points]
    alike = [point.label == reported for point, reported in zip(way.points, REPORTED, strict=True)]
    if all(alike):
        return f"the labels at {joined(speeds)} agree"
    what = [f"the {'label' if same else 'contact'} at {at}" for same, at in zip(alike, speeds, strict=True)]
    return f"{joined(what)} agree"


def _softer(way: VerifiedWay) -> str:
    """Bearings that are not, beside the mesh, what they are in the case."""
    over = bearings_beside_mesh(way)
    return (
        ""
        if abs(over - 1.0) < NEAR
        else f", and with bearings {number(over, 2)} times as stiff beside the mesh"
    )


def bearings_beside_mesh(way: VerifiedWay) -> float:
    """Stiffness of the bearings over that of the mesh, over the same in the case."""
    return way.numbers[BEARINGS] / way.numbers[STIFFNESS]


def _rests_on(found: Verified, way: VerifiedWay) -> str:
    """What settings beside do to a way; of one that agrees, also what is not settled."""
    said = with_settings.one_changed(way)
    if way in agreeing(found):
        said += f"{_unsettled(way)}{window.beside_points(way)}"
    return f"“{way.name}”:{said}" if said else ""


def _unsettled(way: VerifiedWay) -> str:
    """Where contact is kept as reported and the period is not found: by how much it is missed, and where else
    it was found."""
    said = []
    for point, reported in zip(way.points, REPORTED, strict=True):
        if parts(reported, None) or parts(point.label, point.apart) or point.label == reported:
            continue
        rows = with_settings.rows_at(way, point)
        have = sum(row[2] == reported for row in rows)
        began = window.from_neighbours(way, point, reported)
        said.append(
            f" The reported force repeats every mesh cycle; as planned that at {point.speed:.0f} rpm does "
            f"not within 1 % (it misses itself by {share(point.returns)}). {reported} was found there "
            f"{began and f'{began} and '}with {have} of {len(rows)} settings."
        )
    return "".join(said)


def _otherwise(found: Verified, way: VerifiedWay, case: Case) -> str:
    """A way that was not made to hold dimensionless numbers, and that does not agree."""
    near = _near(found, way, case)
    return (
        f"With “{way.name}”{near} the reported pair of motions was not found from teeth pressed together: "
        f"{_moves(way)}."
        f"{window.coexisting(found, way)}"
    )


def _near(found: Verified, way: VerifiedWay, case: Case) -> str:
    """How far the dimensionless numbers of a way are from those of the case, where that is little."""
    itself = case_itself(found)
    if itself is None:
        return ""
    off = max(abs(one / other - 1.0) for one, other in _compared(way, itself))
    if off > NEAR:
        return ""
    said = (
        ", whose error on the flanks and backlash over static deflection, bearings over the mesh and ω are "
        f"within {share(off)} of those of “{itself.name}”,"
    )
    if way.ripples[1] > max(way.ripples[0], way.ripples[2]):
        said += (
            f" whose stiffness varies most twice a mesh cycle ({lumped_beside.second(way, case)}; "
            f"{share(way.ripples[0])} once and {share(way.ripples[2])} three times),"
        )
    if way.name == MODIFIED:
        said += (
            f" and whose flanks make an error of their own under load ({in_um(way.errors_under_load)} at the "
            "first three mesh orders), which these numbers leave out,"
        )
    return said


def _compared(way: VerifiedWay, itself: VerifiedWay) -> list[tuple[float, float]]:
    """Dimensionless numbers of a way, and of the one that has those of the case."""
    pairs = [(way.numbers[name], itself.numbers[name]) for name in (ERROR, PLAY)]
    pairs.append((bearings_beside_mesh(way), bearings_beside_mesh(itself)))
    return pairs + [(one.omega, other.omega) for one, other in zip(way.points, itself.points, strict=True)]


def in_um(amplitudes: Sequence[float]) -> str:
    """Of the first three mesh orders."""
    return f"{joined([number(each, 3) for each in amplitudes])} µm"


def ripples(way: VerifiedWay) -> str:
    """The first three harmonics of the stiffness."""
    return joined([share(each) for each in way.ripples[:3]])


def _harmonics(found: Verified) -> Text:
    plain = [way for way in found.ways if way.name != MODIFIED]
    turned = [way for way in found.ways if way.name == MODIFIED and way.ripples[1] > way.ripples[0]]
    said = (
        "The stiffness that the case assumes, found by a fit, varies twice a mesh cycle. That of unmodified "
        "real teeth varies mostly once: "
        + "; ".join(
            f"{ripples(way)} at {number(way.face_width, 3)} mm under {way.torque:.0f} N·m"
            for way in plain[:2]
        )
    )
    if not turned:
        return Text.of(f"{said}.")
    return Text.of(
        f"{said}. Strong modification turns it round under {turned[0].torque:.0f} N·m: relief of both "
        f"tips by {RELIEF['tip'] * 1e6:.0f} µm over {RELIEF['length'] * 1e3:.3g} mm of roll and crowning of "
        f"{RELIEF['crowning'] * 1e6:.0f} µm give {ripples(turned[0])}, and at "
        f"{number(turned[0].face_width, 3)} mm bring the mean "
        f"stiffness down to {number(turned[0].stiffness / 1e8, 3)}·10⁸ N/m."
    )
