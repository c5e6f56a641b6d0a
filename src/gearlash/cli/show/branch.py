"""Branches in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.case.units import pretty
from gearlash.cli.answers.branch import BranchAnswer
from gearlash.cli.answers.branch_parts import BranchFound, LawFound, NextPoint, SpecialFound
from gearlash.results.contact_words import sided

from .layout import assumed, facts, headline, note, table
from .numbers import Marks, number, polar

MOST_NAMED = 12
SAME = 1e-8  # relative: a point at which a branch was begun and one at which it ends are one
MOST_LINES = 40  # special points of one branch; all of them are in --json
HOLD = "all hold: a0 ≠ 0, no multiplier is 1, the extremum moves with the parameter, c ≠ 0"
DIGITS = 10  # of a value that was solved for


def branch_view(answer: BranchAnswer, width: int) -> Iterator[Text]:
    """Sentence, every branch with its special points and ends, and what was not looked for."""
    marks = Marks({})
    yield from headline(answer.sentence, width)
    if answer.status != "ok":
        rows = [("status", answer.status), ("message", answer.message), ("what to do", answer.advice)]
        yield from facts("", [row for row in rows if row[1]], width)
    for branch in answer.branches:
        yield from _branch(answer, branch, marks, width)
    yield from _coexisting(answer, width)
    yield from _not_switched(answer, width)
    if answer.not_looked_for:
        yield from note(f"Not looked for: {'; '.join(answer.not_looked_for)}.", width)
    yield from assumed((answer.axis.held,), width)
    footnote = marks.footnote()
    if footnote:
        yield from note(footnote, width)


def _branch(answer: BranchAnswer, branch: BranchFound, marks: Marks, width: int) -> Iterator[Text]:
    asked = answer.axis.asked
    where = "" if branch.parent is None else f", from {branch.parent_special} of branch {branch.parent}"
    title = f"Branch {branch.number}{where}: {', '.join(branch.labels[:8])}"
    if len(branch.labels) > 8:
        title += f" and {len(branch.labels) - 8} more labels"
    shown = branch.special[:MOST_LINES]
    unit = pretty(asked.unit) if asked.unit else asked.title
    columns = [
        ("", "right"), (unit, "right"), ("error", "right"), ("kind", "left"), ("gap", "left"),
        ("before | after", "left"), ("unstable", "left"),
    ]  # fmt: skip
    if shown:
        teeth = answer.case.between_teeth
        rows = [_row(special, asked.factor, marks, teeth) for special in shown]
        yield from table(title, columns, rows, width)
    else:
        yield from facts(title, [("special points", "none found")], width)
    left = len(branch.special) - len(shown)
    if left:
        yield from note(f"and {left} more special points (--json has all)", width)
    yield from facts("", list(_facts(answer, branch)), width)
    for special in shown:
        yield from _law(answer, special, width)


def _row(special: SpecialFound, factor: float, marks: Marks, teeth: bool) -> list[str]:
    error = "–" if special.error is None else f"{abs(special.error * factor):.0e}"
    rests = special.physical[0].rests_on if special.physical and factor != 1.0 else ()
    kind = special.kind if special.side is None else sided(special.note.partition(";")[0], teeth)
    return [
        str(special.number),
        marks.of(f"{special.value_asked:.{DIGITS}g}", rests),
        error,
        f"grazing, {kind}" if special.side is not None else kind,
        special.clearance or "",
        f"{special.label_before} | {special.label_after}",
        f"{special.unstable_before} | {special.unstable_after}",
    ]


def _facts(answer: BranchAnswer, branch: BranchFound) -> Iterator[tuple[str, str]]:
    asked, teeth = answer.axis.asked, answer.case.between_teeth
    yield (
        "orbits",
        f"{len(branch.orbits)}: " + ", ".join(f"{n} {verdict}" for verdict, n in branch.certificates.items()),
    )
    for end, name in zip(branch.ends, ("begins", "ends"), strict=True):
        evidence = f" ({sided(end.note, teeth)})" if end.note else ""
        yield name, f"{asked.text(end.value, DIGITS)}: {end.kind}{evidence}"
    for i, special in enumerate(s for s in branch.special if s.note.partition("; ")[2]):
        yield "" if i else "to note", f"at {special.number}: {sided(special.note.partition('; ')[2], teeth)}"
    for i, each in enumerate(branch.unexplained):
        yield "" if i else "unexplained", each


def _law(answer: BranchAnswer, special: SpecialFound, width: int) -> Iterator[Text]:
    if special.law_missing:
        yield from facts(f"Law at {special.number}", [("none", special.law_missing)], width)
    elif special.law is not None:
        yield from facts(f"Law at {special.number}: λ0 + c √depth", list(_terms(answer, special.law)), width)


def _terms(answer: BranchAnswer, law: LawFound) -> Iterator[tuple[str, str]]:
    yield "λ0", ", ".join(polar(m.re, m.im, m.modulus) for m in law.multipliers if m.im >= 0.0)
    pairs = zip(law.multipliers, law.coefficients, strict=True)
    yield "c", ", ".join(_coefficient(c.re, c.im) for m, c in pairs if m.im >= 0.0)
    yield (
        "conditions",
        "; ".join(law.missing) or HOLD,
    )
    yield "predicted", _next(answer, law.predicted, "no fold or doubling")
    yield "computed", _next(answer, law.computed, f"no fold or doubling before {law.until or 'its end'}")


def _coefficient(real: float, imag: float) -> str:
    if imag == 0.0:
        return number(real, 4)
    return f"{number(real, 4)} {'+' if imag > 0.0 else '-'} {number(abs(imag), 4)}i"


def _next(answer: BranchAnswer, point: NextPoint | None, none: str) -> str:
    if point is None:
        return none
    where = "" if point.value is None else f", {answer.axis.asked.text(point.value, 8)}"
    return f"{point.kind} at depth {number(point.depth, 4)}{where}"


def _coexisting(answer: BranchAnswer, width: int) -> Iterator[Text]:
    asked = answer.axis.asked
    rows = []
    for each in answer.coexisting[:MOST_LINES]:
        ends = asked.inner(each.low, each.high)
        rows.append([", ".join(each.labels), asked.between(*ends)])
    if rows:
        columns = [("labels", "left"), ("", "left")]
        yield from table("Stable motions of these branches that coexist", columns, rows, width)


def _not_switched(answer: BranchAnswer, width: int) -> Iterator[Text]:
    rows = [
        (f"{each.special} of branch {each.branch}", each.why or f"branch {each.known}, followed already")
        for each in answer.not_switched
    ]
    if rows:
        yield from facts("No further branch from", rows, width)
    followed = {(each.parent, each.parent_special) for each in answer.branches}
    tried = followed | {(each.branch, each.special) for each in answer.not_switched}
    left = [
        f"{special.number} of branch {branch.number}"
        for branch in answer.branches
        for special in branch.special
        if special.born
        and (branch.number, special.number) not in tried
        and not _came_from(answer, branch, special)
    ]
    if left:
        shown = ", ".join(left[:MOST_NAMED]) + (" …" if len(left) > MOST_NAMED else "")
        yield from note(f"Other branches begin at {shown}: --switch and --depth follow them.", width)


def _came_from(answer: BranchAnswer, branch: BranchFound, special: SpecialFound) -> bool:
    """Whether the branch was switched to where it joins the other one there."""
    if branch.parent is None or branch.parent_special is None or not special.kind.startswith("joins"):
        return False
    begun = answer.branches[branch.parent - 1].special[branch.parent_special - 1].value
    return abs(special.value - begun) <= SAME * max(abs(begun), abs(special.value))
