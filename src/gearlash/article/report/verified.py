"""The pair with real teeth beside the lumped model and what the article reports of its own simulation."""

from __future__ import annotations

import numpy as np

from gearlash import plots
from gearlash.article import Reproduction
from gearlash.article.verified import REPORTED, Verified, VerifiedPoint, verified
from gearlash.report.blocks import Block, Bullets, Cell, Figure, Note, Ref, Section, Strong, Table, Text
from gearlash.report.numbers import number, scientific
from gearlash.report.pictures import Picture
from gearlash.studies.verification.plan import AT_WINDOW
from gearlash.studies.verification.settings import PLANNED

from . import conclusion, settings_beside, teeth, window
from .seen import KEPT, NONE, RULES, UNEVEN, parts, share, told

STEM = "verified-forces"


def section(
    done: Reproduction, real: Verified | None = None, checked: str = ""
) -> tuple[Section, list[Picture]] | None:
    """The comparison, as it was computed in the run or as it is kept, and what a check said of the latter;
    None where the case is not the one that was verified."""
    found = verified(done.case) if real is None else real
    if found is None:
        return None
    blocks: list[Block] = [
        _origin(found, checked),
        _intro(),
        _ways(found),
        _table(found),
        _figure(),
        *conclusion.blocks(found, done),
        *window.blocks(found),
        *settings_beside.blocks(found),
    ]
    more, pictures = teeth.drawn(done.case, found)
    blocks += [*more, _limits(found)]
    pictures.insert(0, Picture(STEM, plots.force_beside, (_panels(found),)))
    return Section("verified", "The pair with real teeth", tuple(blocks)), pictures


def _origin(found: Verified, checked: str) -> Text:
    """Where the numbers come from, before any of them."""
    if found.in_run:
        return Text.of("All numbers of this section were computed in this run, with gearlash verify’s plan.")
    made = found.computed
    which = f", commit {made['commit']} of {made['day']}," if made else ""
    renewed = f"{made['command']} renews them, and " if made else ""
    return Text.of(
        f"The numbers of this section are kept and were not computed in this run: gearlash {found.gearlash}"
        f"{which} computed them; {renewed}gearlash reproduce --verify computes them in the run. "
        f"{checked or 'Whether this code still computes them was not checked in this run.'}"
    )


def _intro() -> Text:
    return Text.of(
        "The article confirms its model with a flexible multibody simulation at two speeds: teeth part once "
        "a mesh cycle at ω = 0.942, and never at 1.047. Here the same pair is computed as bodies in space "
        "with involute teeth, compliance from finite elements and contact that only pushes. No equation of "
        "the lumped model is used. None of its stiffness is an input, though that of the case chooses the "
        "width of “stiffness”, the torque, speeds and bearings of “dimensionless”, and the relief. Masses "
        "and backlash are those of the case, torque and bearings, too, where nothing else is said below; "
        "the error is the same at all contacts; damping matches the ratios of the case. The lumped model "
        "then gets what those teeth have: mean stiffness, its first three harmonics, torque, error, what "
        "the teeth make of the error under load, and damping ratios. Teeth as wide as the stated masses ask "
        "for are about five times stiffer than the stated stiffness, so there are several ways to hold the "
        "inputs. The phase of the error is counted from the second harmonic of the stiffness, the one that "
        "the case has; it is small with unmodified teeth."
    )


def _ways(found: Verified) -> Bullets:
    return Bullets(
        tuple(
            Text.of(
                Strong(way.name),
                f": {way.held}. Face width {number(way.face_width, 3)} mm, mean stiffness "
                f"{number(way.stiffness / 1e8, 3)}·10⁸ N/m, ripple {conclusion.ripples(way)} at the first "
                f"three mesh orders, torque {number(way.torque, 4)} N·m, error {number(way.error, 4)} µm; "
                f"beside it the flanks make {conclusion.in_um(way.errors_under_load)} at these orders under "
                "load.",
            )
            for way in found.ways
        )
    )


def _table(found: Verified) -> Table:
    rows: list[tuple[Cell, ...]] = []
    for way in found.ways:
        for point, reported in zip(way.points, REPORTED, strict=True):
            rows.append(
                (
                    way.name,
                    [f"{point.speed:.0f} rpm", f"ω {number(point.omega, 4)}"],
                    [*_seen(point)],
                    told(point.rigid),
                    *(_lumped(point, rule) for rule in RULES),
                    reported[:-2],
                )
            )
    return Table(
        "table-verified",
        "Motion at the two speeds: real teeth with a gear that bends and with a rigid one, the "
        "lumped model at the same inputs under three contact rules, and what the article reports of its own "
        "simulation; shares of time without contact, forces over their mean. ω is the mesh frequency over "
        "√(k/m_e) with the stiffness of these teeth. The article names ω 0.942 and 1.047, which are 3600 and "
        "4000 rpm with the stiffness of the case. Of a label P-Q-R, Q are the impacts in P mesh cycles.",
        ("inputs", "speed", "real teeth", "rigid gear", *(f"lumped, {rule}" for rule in RULES), "reported"),
        tuple(rows),
        widths=(12, 12, 19, 11, 12, 12, 12, 10),
    )


def _seen(point: VerifiedPoint) -> list[str]:
    forces = f"force {number(point.least, 2)} to {number(point.peak, 3)} of its mean"
    label, apart = told(point.label), f"apart {share(point.apart)} of the time"
    if point.label in (NONE, KEPT):
        label = f"{label} (misses itself by {share(point.returns)})"
    if point.label == UNEVEN:
        label = f"{label} (mean forces come back within {share(point.returns)})"
    if not parts(point.label, point.apart):
        return [label, apart, forces]
    back = f", {number(point.back_impacts, 3)} on the back side" if point.back_impacts else ""
    return [label, apart, f"impacts a mesh cycle: {number(point.impacts, 3)}{back}", forces]


def _lumped(point: VerifiedPoint, rule: str) -> Cell:
    label = told(point.lumped.get(rule, ""))
    apart, peak = point.lumped_apart.get(rule), point.lumped_peak.get(rule)
    more = "" if apart is None else f"apart {share(apart)}"
    return [label, *([more] if more else []), *([] if peak is None else [f"force to {number(peak, 3)}"])]


def _figure() -> Figure:
    return Figure(
        "fig-verified",
        Text.of(
            "Contact force over two mesh cycles at both speeds: real teeth, and the lumped model at the same "
            "inputs with the article’s contact rule. Real teeth that are apart have no force; under that "
            "rule the lumped model is damped in the gap, too, and its force may be of either sign there."
        ),
        "Contact forces over time, a row for every way to hold the inputs and a column for each speed.",
        STEM,
    )


def _panels(found: Verified) -> list[list[plots.ForcePanel]]:
    return [
        [
            plots.ForcePanel(
                f"{way.name}, {point.speed:.0f} rpm: {told(point.label).partition(',')[0]}",
                *(
                    np.asarray(each)
                    for each in (point.phase, point.force, point.lumped_phase, point.lumped_force)
                ),
            )
            for point in way.points
        ]
        for way in found.ways
    ]


def _limits(found: Verified) -> Note:
    computed = {row[0] for way in found.ways for row in way.beside}
    own = PLANNED.name, AT_WINDOW.name
    failed = [name for each in found.settings if (name := each["name"]) not in (*own, *computed)]
    missing = f" Planned and not integrated: {', '.join(failed)}." if failed else ""
    return Note(
        Text.of(
            "Each motion of real teeth in ",
            Ref("table-verified"),
            ", and with every setting beside, begins with teeth pressed together: others may coexist, and "
            "with settings none were looked for. Neither model has friction, a film of oil, housings or, "
            "but with a flexible pinion, shafts that bend. Labels of real teeth are those of motions that "
            "repeat after at most 8 mesh cycles, within 1 % in the mean forces of every 1/64 of a mesh "
            "cycle, over the range of these means; at single places they may miss more. In the balance of "
            f"energy of these {sum(len(way.points) for way in found.ways)} motions at most "
            f"{scientific(_missing(found))} of what dampers take is missing; of settings and the window none "
            f"is kept.{_bearings(found)} No setting lets more of the bodies below the teeth give way; "
            "docs/verification.md estimates that the stiffness of the mesh may be 10 to 15 % above that of "
            f"bodies which give way down to their shafts.{missing}",
        ),
        "Limits",
    )


def _missing(found: Verified) -> float:
    """In the balance of energy over what is read, at most."""
    return max(abs(p.energy_residual) for way in found.ways for p in way.points)


def _bearings(found: Verified) -> str:
    """Ways whose bearings are not, beside the mesh, what they are in the case."""
    softer = [
        f"{number(over, 2)} with “{way.name}”"
        for way in found.ways
        if abs((over := conclusion.bearings_beside_mesh(way)) - 1.0) > conclusion.NEAR
    ]
    if not softer:
        return ""
    return (
        f" Stiffness of the bearings over that of the mesh, beside the same in the case: {', '.join(softer)}."
    )
