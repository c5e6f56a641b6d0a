"""A reproduction in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.cli.answers.reproduce import Claim, ReproduceAnswer
from gearlash.jobs import seconds_as_text

from .layout import facts, headline, note, remarks, table

FITTED = (
    "‡ Five values that the article leaves open were chosen to meet these five numbers: the numbers test "
    "nothing, the labels on both sides of them, the coincidence and the zone in D do."
)


def reproduce_view(answer: ReproduceAnswer, width: int) -> Iterator[Text]:
    """Sentence, the table of claims, what was measured, where the report is."""
    yield from headline(answer.sentence, width)
    claims = [(_verdict(c), c.reported, c.computed, _about(c)) for c in answer.claims]
    yield from remarks("Claims: verdict, reported, computed", claims, width)
    checks = [(c.value, c.bound, _held(c.holds), c.what) for c in answer.checks]
    yield from table(
        "Measured in this run",
        [("value", "right"), ("bound", "left"), ("", "left"), ("", "left")],
        checks,
        width,
    )
    total = seconds_as_text(answer.seconds["total"])
    if any(c.fitted for c in answer.claims):
        yield from note(FITTED, width)
    rows = [("time", f"{total} with {answer.workers} worker{'s' if answer.workers != 1 else ''}")]
    if answer.status != "ok":
        rows.insert(0, ("status", answer.status))
    yield from facts("", [*rows, ("report", answer.report)], width)


def _about(claim: Claim) -> str:
    """What the numbers are of, and the labels where the article gives them."""
    about = f"{claim.quantity}, {claim.where}" if claim.where else claim.quantity
    if claim.reported_labels and claim.reported_labels != claim.reported:
        about += f"; {claim.reported_labels}, computed {claim.computed_labels or '–'}"
    if claim.needs:
        about += f"; * only with: {claim.needs}"
    return "; ".join([about, *(f"{part.what}: {part.computed}, {part.verdict}" for part in claim.parts)])


def _verdict(claim: Claim) -> str:
    """With a star where it needs a certain scan, with a dagger where it tests nothing."""
    return claim.verdict + ("*" if claim.needs else "") + ("‡" if claim.fitted else "")


def _held(holds: bool | None) -> str:
    return "" if holds is None else "holds" if holds else "does not hold"
