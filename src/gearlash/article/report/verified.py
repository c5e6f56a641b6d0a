"""The pair with real teeth beside the lumped model and what the article reports of its own simulation."""

from __future__ import annotations

import numpy as np

from gearlash import plots
from gearlash.article import Reproduction
from gearlash.article.verified import REPORTED, Verified, VerifiedPoint, VerifiedWay, verified
from gearlash.report.blocks import Block, Bullets, Cell, Figure, Note, Section, Strong, Table, Text
from gearlash.report.numbers import number
from gearlash.report.pictures import Picture

from . import teeth
from .teeth import told
from .words import plural

STEM = "verified-forces"
RULES = ("always", "in-contact", "no-tension")


def section(done: Reproduction) -> tuple[Section, list[Picture]] | None:
    """The comparison; None where the case is not the one that was verified."""
    found = verified(done.case)
    if found is None:
        return None
    blocks: list[Block] = [
        _intro(),
        _ways(found),
        _table(found),
        _figure(),
        *_conclusion(found),
        *_beside(found),
    ]
    more, pictures = teeth.drawn(done.case, found)
    blocks += [*more, _limits(found)]
    pictures.insert(0, Picture(STEM, plots.force_beside, (_panels(found),)))
    return Section("verified", "The pair with real teeth", tuple(blocks)), pictures


def _intro() -> Text:
    return Text.of(
        "The article confirms its model with a flexible multibody simulation at two speeds: teeth part "
        "once a mesh cycle at ω = 0.942, and never at 1.047. Here the same pair is computed as bodies in "
        "space with involute teeth, compliance from finite elements and contact that only pushes, in which "
        "nothing of the lumped model is used. The lumped model then gets what those teeth have: mean "
        "stiffness, its first three harmonics, and the same torque, error and damping ratios. Teeth as wide "
        "as the stated masses ask for are about five times stiffer than the stated stiffness, so there are "
        "several ways to hold the inputs."
    )


def _ways(found: Verified) -> Bullets:
    return Bullets(
        tuple(
            Text.of(
                Strong(way.name),
                f": {way.held}. Face width {number(way.face_width, 3)} mm, mean stiffness "
                f"{number(way.stiffness / 1e8, 3)}·10⁸ N/m, ripple {_ripples(way)} at the first two mesh "
                f"orders, torque {number(way.torque, 4)} N·m, error {number(way.error, 4)} µm.",
            )
            for way in found.ways
        )
    )


def _ripples(way: VerifiedWay) -> str:
    return f"{_share(way.ripples[0])} and {_share(way.ripples[1])}"


def _share(part: float) -> str:
    return f"{100.0 * part:.3g} %"


def _table(found: Verified) -> Table:
    rows: list[tuple[Cell, ...]] = []
    for way in found.ways:
        for point, reported in zip(way.points, REPORTED, strict=True):
            rows.append(
                (
                    way.name,
                    f"{point.speed:.0f} rpm, ω {number(point.omega, 4)}",
                    _seen(point),
                    told(point.rigid),
                    *(told(point.lumped.get(rule, "")) for rule in RULES),
                    reported[:-2],
                )
            )
    return Table(
        "table-verified",
        "Motion at the two speeds: real teeth with a gear that bends and with a rigid one, the "
        "lumped model at the same inputs under three contact rules, and what the article reports of its own "
        "simulation. ω is the mesh frequency over √(k/m_e) with the stiffness of these teeth.",
        ("inputs", "speed", "real teeth", "rigid gear", *RULES, "reported"),
        tuple(rows),
        widths=(12, 18, 20, 10, 10, 10, 10, 10),
    )


def _seen(point: VerifiedPoint) -> Cell:
    forces = f"force {number(point.least, 2)} to {number(point.peak, 3)} of its mean"
    return [told(point.label), f"apart {_share(point.apart)} of the time", forces]


def _figure() -> Figure:
    return Figure(
        "fig-verified",
        Text.of(
            "Contact force over two mesh cycles at both speeds: real teeth, and the lumped model at the same "
            "inputs with the article’s contact rule. A force of zero is teeth apart."
        ),
        "Contact forces over time, a row for every way to hold the inputs and a column for each speed.",
        STEM,
    )


def _panels(found: Verified) -> list[list[plots.ForcePanel]]:
    return [
        [
            plots.ForcePanel(
                f"{way.name}, {point.speed:.0f} rpm: {told(point.label)}",
                *(
                    np.asarray(each)
                    for each in (point.phase, point.force, point.lumped_phase, point.lumped_force)
                ),
            )
            for point in way.points
        ]
        for way in found.ways
    ]


def agreeing(found: Verified) -> list[str]:
    """The ways in which real teeth move at both speeds as the article reports."""
    return [
        way.name for way in found.ways if all(p.label == r for p, r in zip(way.points, REPORTED, strict=True))
    ]


def _conclusion(found: Verified) -> list[Block]:
    agree = agreeing(found)
    others = [way.name for way in found.ways if way.name not in agree]
    first = (
        f"real teeth give the motion that is reported at both speeds with the inputs “{'”, “'.join(agree)}”"
        if agree
        else "real teeth do not give the motion that is reported at both speeds with any of these inputs"
    )
    rest = f", and not with “{'”, “'.join(others)}”" if agree and others else ""
    points = [p for way in found.ways for p in way.points]
    parts = [f"{_same(points, rule)} of {len(points)} under “{rule}”" for rule in RULES]
    return [
        Note(
            Text.of(
                f"{first[:1].upper()}{first[1:]}{rest}.{_when_held(found, agree)} Given what real teeth "
                f"have, the lumped model agrees with them on whether teeth part at {', '.join(parts)}."
                f"{_what_decides(points)} The article "
                "leaves torque, error and backlash open, and states a stiffness that unmodified teeth of the "
                "stated size do not have: so this neither confirms nor refutes its simulation, whose inputs "
                "are not known."
            ),
            "Conclusion",
        ),
        _harmonics(found),
    ]


def _when_held(found: Verified, agree: list[str]) -> str:
    """Where an agreement is lost once the centre distance does not move, which the bearings decide."""
    lost = [
        f"{point.speed:.0f} rpm ({told(moved.label_held)})"
        for way in found.ways
        for moved, point in zip(way.breathing, way.points, strict=False)
        if way.name in agree and moved.label_held != point.label
    ]
    if not lost:
        return ""
    return (
        " That rests on a centre distance that moves, and so on the stiffness assumed for the bearings along "
        f"the line of centres: with it held, the motion is another one at {', '.join(lost)}."
    )


def _what_decides(points: list[VerifiedPoint]) -> str:
    """Whether the inputs or the equations make the difference, where the data say so."""
    if _same(points, RULES[0]) < len(points):
        return ""
    return " At these points whether teeth part rests on the inputs, and not on which model computes it."


def _same(points: list[VerifiedPoint], rule: str) -> int:
    """How often both models agree on whether teeth part at all."""
    return sum(_parts(p.label, p.apart) == _parts(p.lumped.get(rule, ""), 0.0) for p in points)


def _parts(label: str, apart: float) -> bool:
    """Whether teeth part: of a motion without label, whether they were seen apart or it is called so."""
    if label.count("-") == 2:
        return not label.endswith("-0-0")
    return apart > 0.0 or label == "aperiodic"


def _harmonics(found: Verified) -> Text:
    plain = [way for way in found.ways if way.name != "modified"]
    turned = [way for way in found.ways if way.name == "modified" and way.ripples[1] > way.ripples[0]]
    said = (
        "The stiffness that the case had to assume varies twice a mesh cycle. That of unmodified real teeth "
        "varies mostly once: "
        + "; ".join(f"{_ripples(way)} at {number(way.face_width, 3)} mm" for way in plain[:2])
    )
    if not turned:
        return Text.of(f"{said}.")
    return Text.of(
        f"{said}. Strong modification at this light load turns it round: tip relief of 53 µm and crowning "
        f"of 41 µm give {_ripples(turned[0])}, and at {number(turned[0].face_width, 3)} mm bring the mean "
        f"stiffness down to {number(turned[0].stiffness / 1e8, 3)}·10⁸ N/m."
    )


def _beside(found: Verified) -> list[Block]:
    first = found.ways[0]
    blocks: list[Block] = []
    if any(way.up for way in found.ways):
        rows = tuple(
            (way.name, way.up, way.down, way.lumped_up[RULES[0]], way.lumped_down[RULES[0]])
            for way in found.ways
        )
        blocks.append(
            Table(
                "table-verified-window",
                "Speeds of the grid at which teeth stay in contact, each begun from the motion at its "
                "neighbour; of the lumped model those with a periodic motion.",
                ("inputs", "real teeth, rising", "falling", "lumped, rising", "falling"),
                rows,
                widths=(16, 21, 21, 21, 21),
            )
        )
    if len(first.beside) > len(first.points):
        planned = {round(p.speed): (p.label, p.apart > 0.0) for p in first.points}
        changed = [
            f"{setting} at {speed:.0f} rpm ({told(label)})"
            for setting, speed, label, _ in first.beside
            if label != planned[round(speed)][0]
        ]
        tried = plural(len({row[0] for row in first.beside}), "setting")
        changes = "; ".join(changed) if changed else "none"
        blocks.append(
            Text.of(
                f"With the inputs “{first.name}”, {tried} were changed one at a time: stiffness of bearings "
                "along the line of centres and against tilt, motion of the centre line, phase of the error, "
                "damping of contact and bearings, a rigid gear, step and solver. The label changes with: "
                f"{changes}."
            )
        )
    return blocks


def _limits(found: Verified) -> Note:
    return Note(
        Text.of(
            "Computed beforehand with gearlash "
            f"{found.gearlash} for this state of the case (gearlash verify article). Each motion begins "
            "with teeth pressed together: others may coexist. Friction is in neither model. With the face "
            "width of the case, bearings stay as stated, so that their frequencies over that of the mesh "
            "are others."
        ),
        "What this rests on",
    )
