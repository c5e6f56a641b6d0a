"""What was given, what was inferred or assumed, and what follows from it."""

from __future__ import annotations

from gearlash.article import Reproduction
from gearlash.case import Case, Value
from gearlash.gears.mesh_cycle import MeshCycle, PairShape
from gearlash.report.blocks import Block, Cell, Marked, Note, Section, Table, Text
from gearlash.report.numbers import number

from .words import plural, provenance

OPEN = ("inferred", "assumed", "calibrated")
HEADINGS = ("value", "", "from", "reason")


def section(done: Reproduction) -> Section:
    """Open values first, then what is computed from them, then what the article gives."""
    values = done.case.values()
    unsure = sorted((v for v in values if v.provenance in OPEN), key=lambda v: OPEN.index(v.provenance))
    derived = [v for v in values if v.provenance == "derived"]
    given = [v for v in values if v.provenance == "given"]
    blocks: list[Block] = [
        Text.of(
            f"{plural(len(unsure), 'value')} of this case are not stated in the article. “Inferred” ones "
            "follow from something it does state, “assumed” ones do not. Every computed number depends on "
            "the inferred ones; a physical number marked † rests on an assumed one as well and is worth "
            "no more than that."
        ),
        _table("table-open", "Values that the article does not state.", unsure),
    ]
    blocks += [
        Note(Text.of(note.text[:1].upper() + note.text[1:]), f"Conflict: {note.path}")
        for note in done.case.notes()
    ]
    blocks += _ripple(done.case)
    blocks.append(
        Note(
            Text.of(
                "The model has no motion of the centre lines and no tilt; “radial” in the article is the "
                "pitch tangent."
            ),
            "Left out",
        )
    )
    blocks.append(_derived(derived))
    blocks.append(_table("table-given", "Values that the article states.", given))
    return Section("assumed", "What was assumed or inferred", tuple(blocks))


def _ripple(case: Case) -> list[Note]:
    """The ripple of the stiffness beside what the length of the contact lines gives."""
    body, own = case.numbers.body, case.family()[0].defaults
    if body.geometry is None or body.face_width is None:
        return []
    used = [abs(own.get(name, 0.0)) for name in ("ripple", "ripple_2")]
    ratios = body.geometry.transverse_contact_ratio, body.geometry.overlap_ratio(body.face_width)
    lines = [abs(float(each)) for each in MeshCycle(*ratios, PairShape.CONSTANT).harmonics(2)]
    said = (
        f"The stiffness used varies by {_per_cent(used[0])} once and {_per_cent(used[1])} twice a mesh "
        "cycle. The "
        f"length of the contact lines of such gears varies by {_per_cent(lines[0])} and "
        f"{_per_cent(lines[1])}, and "
        "with unmodified flanks the second harmonic is never larger than the first. "
    )
    if all(each <= 2.0 * line for each, line in zip(used, lines, strict=True)):
        return []
    return [
        Note(
            Text.of(said, "The values used are not those of a real pair of this drawing."), "Conflict: ripple"
        )
    ]


def _per_cent(part: float) -> str:
    return f"{number(100.0 * part, 2)} %"


def _table(identifier: str, caption: str, values: list[Value]) -> Table:
    rows = tuple((_name(v), _number(v), provenance(v.provenance), v.reason) for v in values)
    return Table(identifier, caption, HEADINGS, rows, frozenset({1}))


def _derived(values: list[Value]) -> Table:
    rows = tuple(
        (_name(v), Marked(text) if v.rests_on else text, v.reason, ", ".join(v.rests_on))
        for v in values
        for text in (_number(v),)
    )
    head = ("value", "", "formula", "rests on the assumed")
    return Table("table-derived", "Numbers computed from these values.", head, rows, frozenset({1}))


def _name(value: Value) -> Cell:
    return [value.description or value.path, value.path] if value.description else value.path


def _number(value: Value) -> str:
    text = number(value.value, 7) if isinstance(value.value, float) else str(value.value)
    return f"{text} {_unit(value.unit)}".strip()


def _unit(text: str) -> str:
    return text.replace("um", "µm").replace("*", "·").replace("^2", "²").replace("deg", "°")
