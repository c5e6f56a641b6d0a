"""The table of claims: what the article says, what was computed, and the verdict."""

from __future__ import annotations

from gearlash.article import NOT_FOUND, REPRODUCED, SHIFTED, ClaimRow, Reproduction
from gearlash.plots.regimes import short
from gearlash.report.blocks import Cell, Inline, Note, Ref, Section, Strong, Table, Text
from gearlash.report.numbers import percent

from .words import verdict

OTHERS = " Other readings: "  # of a zone; here its own table has them
HEADINGS = (
    "Claim of the article",
    "Printed",
    "Computed",
    "Deviation",
    "Verdict",
    "Where it was found, and remarks",
)


def section(done: Reproduction) -> Section:
    """Every claim, one row each."""
    table = Table(
        "table-claims",
        "Every claim of the article except those of its multibody section, with its computed counterpart.",
        HEADINGS,
        tuple(_row(claim) for claim in done.claims),
        frozenset({3}),
        widths=(29, 11, 14, 10, 14, 22),
    )
    intro = Text.of(
        f"“{REPRODUCED}”: the labels are equal and the value lies within 0.5 % of the printed one. "
        f"“{SHIFTED}”: the labels are equal and the value lies within 10 %. “{NOT_FOUND}”: anything else. "
        "Rules for what is no value with labels are in ",
        Ref("table-rules-of-verdicts"),
        ". Where not every way of scanning gives the verdict, those that do are named below it. "
        "What the article prints is never read by what computes the other column; it only says which of the "
        "computed things it is compared with, and around which value a picture is centred. Labels P-Q-R "
        "count mesh cycles, drive-side impacts and back-side impacts of one period.",
    )
    return Section("claims", "Claims of the article", (intro, *_fitted(done), table))


def _fitted(done: Reproduction) -> list[Note]:
    """What the numbers that were fitted to are worth."""
    if not any(claim.fitted for claim in done.claims):
        return []
    text = (
        "The article states neither load, ripple, error nor bearing damping. Five numbers (bearing damping, "
        "second stiffness harmonic, error over load, error phase, load) were chosen so that five of its "
        "critical values come out; they are marked “fitted” below. These five values therefore test nothing. "
        "What tests the set is what it was not chosen for: the labels on both sides of each value, the "
        "coincidence at D ≈ 0.3523, the zone in D from 0.459, and the motions elsewhere. That the stiffness "
        "varies twice a mesh cycle was chosen after looking as well. This is strong evidence, not proof."
    )
    return [Note(Text.of(text), "What is a test here and what is not")]


def counts(done: Reproduction) -> dict[str, int]:
    """How many claims have which verdict."""
    return {kind: sum(c.verdict == kind for c in done.claims) for kind in (REPRODUCED, SHIFTED, NOT_FOUND)}


def _row(claim: ClaimRow) -> tuple[Cell, ...]:
    what: Cell = [Strong(claim.quantity), f"at {claim.where}" if claim.where else "", f"“{claim.sentence}”"]
    printed: Cell = [_with_unit(claim.printed, claim.unit), claim.reported_labels]
    computed: Cell = [_with_unit(claim.computed, claim.unit), _labels(claim.computed_labels)]
    note, others, _ = claim.note.partition(OTHERS)
    remarks: list[Inline | tuple[Inline, ...]] = [line for line in (claim.branch, note) if line] or [""]
    remarks += [("All readings: ", Ref("zones"), ".")] if others else []
    judged: list[Inline | tuple[Inline, ...]] = [verdict(claim.verdict)]
    judged += [f"only with: {claim.needs}"] if claim.needs else []
    judged += ["value fitted; labels are not"] if claim.fitted else []
    remarks += [(Strong(f"{p.what}: "), f"{p.computed} ", verdict(p.verdict)) for p in claim.parts]
    return what, printed, computed, percent(claim.deviation), judged, remarks


def _labels(text: str) -> str:
    return " → ".join(short(part) for part in text.split(" → "))


def _with_unit(text: str, unit: str) -> str:
    return f"{text} {unit}".strip()
