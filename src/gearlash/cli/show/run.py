"""A run in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.cli.answers.motion import ForceNumbers, MotionNumbers, OtherClearance
from gearlash.cli.answers.physical import PhysicalEvent, PhysicalRun
from gearlash.cli.answers.run import RunAnswer
from gearlash.results.beside import Beside
from gearlash.results.contact_words import damping_in_the_gap
from gearlash.system import ContactRule, Label, MotionKind

from .layout import facts, headline, note, table
from .numbers import Marks, number, polar, quantity
from .words import cycles, side

MOST_EVENTS = 24  # lines of contact events; all of them are in --json
BOTH = 100  # columns from which contact events are shown in both kinds of numbers
FORCES = {
    "maximum": "contact force, largest (peak)",
    "minimum": "contact force, least (peak)",
    "peak_to_peak": "contact force, peak-to-peak",
    "mean": "contact force, mean",
    "rms": "contact force, rms",
    "alternating_rms": "contact force, rms about the mean",
}
TURNED = {"maximum": "minimum", "minimum": "maximum"}
"""On the back side, where forces are below 0, the largest one is the lowest number."""


def run_view(answer: RunAnswer, width: int) -> Iterator[Text]:
    """Sentence, status, numbers, contacts, and what rests on assumed values."""
    marks = Marks(answer.physical.rests_on if answer.physical else {})
    yield from headline(answer.sentence, width)
    yield from facts("", list(_facts(answer, marks)), width)
    if answer.numbers:
        yield from _amplitudes(answer, answer.numbers, marks, width)
        if answer.numbers.events:
            yield from _events(answer, answer.numbers, marks, width)
        for other in answer.numbers.others:
            yield from _other(other, width)
        said = answer.case.between_teeth and damping_in_the_gap(
            ContactRule(answer.numbers.contact),
            answer.numbers.force.minimum,
            answer.numbers.force.maximum,
            answer.numbers.share_without_contact,
        )
        if said:
            yield from note(said, width)
    footnote = marks.footnote()
    if footnote:
        yield from note(footnote, width)


GEAR_COUNTS = "mesh cycles in a period, impacts on the drive side, on the back side"
COUNTS = "cycles in a period, impacts on side +, on side -"
GEAR = ("omega", "D", "load")  # what a gear pair is shown by; of other systems, every parameter is


def _facts(answer: RunAnswer, marks: Marks) -> Iterator[tuple[str, str]]:
    yield "status", f"{answer.status}: {answer.message}"
    if answer.status != "ok":
        yield "what to do", answer.advice
    shown = GEAR if set(GEAR) <= set(answer.parameters) else tuple(answer.parameters)
    dimensionless = ", ".join(f"{name} {number(answer.parameters[name], 7)}" for name in shown)
    yield "parameters", _operation(answer.physical, marks) if answer.physical else dimensionless
    if answer.physical:
        yield "", dimensionless
    if answer.signature:
        counted = GEAR_COUNTS if answer.case.between_teeth else COUNTS
        yield (
            "signature",
            f"{answer.label} ({counted}"
            + "".join(f"; those of {other.name}" for other in answer.signature.others)
            + ")",
        )
    if answer.multipliers:
        pairs = (polar(m.re, m.im, m.modulus) for m in answer.multipliers if m.im >= 0.0)
        yield "multipliers", f"{', '.join(pairs)} ({'stable' if answer.stable else 'unstable'})"
    error = f" ± {number(answer.exponent_error, 2)}" if answer.exponent_error else ""
    yield "exponent", f"{number(answer.exponents[0])}{error} per unit of τ (the largest)"
    yield (
        "certificate",
        ": ".join(filter(None, (answer.certificate.verdict, "; ".join(answer.certificate.reasons)))),
    )
    if answer.beside:
        yield "other starts", ", ".join(_beside(answer.beside, answer.label))
    if answer.numbers:
        yield "no contact", f"{100.0 * answer.numbers.share_without_contact:.3g} % of the time"


def _beside(beside: Beside, own: Label) -> Iterator[str]:
    same = "aperiodic motion, too" if own is MotionKind.APERIODIC else "the same motion"
    yield f"{beside.same} of {beside.starts} to {same}"
    for motion in beside.others:
        status = "" if motion.status == "ok" else f" ({motion.status})"
        yield f"{motion.starts} to {motion.label}{status}"
    if beside.undecided:
        yield f"{beside.undecided} settled to nothing in the time given"


def _operation(found: PhysicalRun, marks: Marks) -> str:
    parts = [
        marks(quantity(found.pinion_speed_rpm, "rpm", 6), "speed"),
        marks(quantity(found.mesh_frequency_Hz, "Hz", 6), "frequency"),
        f"{found.backlash_name} {marks(quantity(found.backlash_um, 'µm'), 'backlash')}",
    ]
    if found.torque_Nm is not None:
        parts.append(f"torque {marks(quantity(found.torque_Nm, 'N·m'), 'torque')}")
    return ", ".join(parts)


def _amplitudes(answer: RunAnswer, numbers: MotionNumbers, marks: Marks, width: int) -> Iterator[Text]:
    """Forces and displacements, each saying what kind of amplitude it is."""
    physical, teeth = answer.physical, answer.case.between_teeth
    rows = list(_force_rows(numbers.force, physical.force_N if physical else None, marks))
    rows.append(("dynamic factor (peak over mean)", number(numbers.dynamic_factor, 4), ""))
    rows += _length_rows(numbers, physical, marks, teeth)
    along = "Along the line of action" if teeth else "Along X"
    if physical:  # first, as who states it has a drawing
        rows = [(name, shown, plain) for name, plain, shown in rows]
    heads = ("physical", "dimensionless") if physical else ("dimensionless", "")
    columns = [("", "left"), *((head, "right") for head in heads)]
    yield from table(f"{along}, over {cycles(numbers.cycles, teeth)}", columns, rows, width)


def _force_rows(
    force: ForceNumbers, newtons: ForceNumbers | None, marks: Marks
) -> Iterator[tuple[str, str, str]]:
    on_the_back = force.maximum < 0.0
    for field, name in FORCES.items():
        field = TURNED.get(field, field) if on_the_back else field
        physical = marks(quantity(getattr(newtons, field), "N"), "force", "model") if newtons else ""
        yield name, number(getattr(force, field)), physical


def _length_rows(
    numbers: MotionNumbers, physical: PhysicalRun | None, marks: Marks, teeth: bool
) -> Iterator[tuple[str, str, str]]:
    error, apart = numbers.displacement, numbers.distances
    what = "displacement of the flanks X" if teeth else "X"
    values = {f"{what}, peak-to-peak": error.peak_to_peak, f"{what}, rms about the mean": error.rms}
    whole = numbers.transmission_error
    if whole is not None:
        values |= {"transmission error, peak-to-peak": whole.peak_to_peak}
        values |= {"transmission error, rms about the mean": whole.rms}
    if "drive" in numbers.sides:
        values |= {"least X − D": apart.drive.minimum, "largest X − D": apart.drive.maximum}
    if "back" in numbers.sides:
        values["least X + D⁻"] = apart.back.minimum
    unit = physical.um_per_length if physical else None
    for name, value in values.items():
        shown = marks(quantity(value * unit, "µm"), "length", "model") if unit is not None else ""
        yield name, number(value), shown


def _events(answer: RunAnswer, numbers: MotionNumbers, marks: Marks, width: int) -> Iterator[Text]:
    """In both kinds of numbers where there is room, else in physical ones."""
    physical, teeth = answer.physical, answer.case.between_teeth
    dimensionless = physical is None or width >= BOTH
    columns = [("phase", "right"), ("", "left")]
    columns += [("X′", "right"), ("Φ", "right")] if dimensionless else []
    columns += [("time", "right"), ("velocity", "right"), ("force", "right")] if physical else []
    rows = []
    for i, event in enumerate(numbers.events[:MOST_EVENTS]):
        row = [f"{event.phase:.5f}", f"{event.event}, {side(event.side, teeth)}"]
        row += [number(event.velocity), number(event.force)] if dimensionless else []
        row += _physical_event(physical.events[i], marks) if physical else []
        rows.append(row)
    count = len(numbers.events)
    more = f", the first {MOST_EVENTS} of {count} (--json has all)" if count > len(rows) else ""
    yield from table(f"Contact events{more}", columns, rows, width)


def _other(other: OtherClearance, width: int) -> Iterator[Text]:
    """A further clearance: its contacts and what it carries, dimensionless."""
    shown = other.events[:MOST_EVENTS]
    more = f", the first {len(shown)} of {len(other.events)}" if len(other.events) > len(shown) else ""
    columns = [("phase", "right"), ("", "left"), ("X′", "right"), ("Φ", "right")]
    rows = [
        (f"{e.phase:.5f}", f"{e.event}, {side(e.side, False)}", number(e.velocity), number(e.force))
        for e in shown
    ]
    if rows:
        yield from table(f"Contact events of {other.name}{more}", columns, rows, width)
    free = f"{100.0 * other.share_without_contact:.3g} % of the time"
    force = f"{number(other.force.minimum)} to {number(other.force.maximum)}"
    yield from facts(f"In {other.name}", [("no contact", free), ("contact force", force)], width)


def _physical_event(event: PhysicalEvent, marks: Marks) -> list[str]:
    return [
        marks(quantity(event.time_ms, "ms"), "time", "model"),
        marks(quantity(event.velocity_mm_s, "mm/s"), "velocity", "model"),
        marks(quantity(event.force_N, "N"), "force", "model"),
    ]
