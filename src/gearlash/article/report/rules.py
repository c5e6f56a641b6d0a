"""What the contact rule does to the window and to the events on the back side, rule by rule."""

from __future__ import annotations

from gearlash.article import Reproduction
from gearlash.article.reproduction import RuleEffect, RuleGrazing, RuleLabel
from gearlash.plots.regimes import short
from gearlash.report.blocks import Block, Bullets, Cell, Note, Section, Strong, Table, Text
from gearlash.report.numbers import number, percent
from gearlash.system import Label, Signature

from .quantities import Quantities, fixed_words

RULES = {
    "always": "the damping of the mesh acts in the gap too (the article’s formula)",
    "in-contact": "the damping acts in contact only",
    "no-tension": "the damping acts in contact only, and contact ends where its force falls to zero: teeth "
    "never pull",
}
SAME_VALUE = 1e-9  # relative difference below which two values are one


def section(done: Reproduction) -> Section | None:
    """The comparison; None where it was not made."""
    if not done.rules:
        return None
    quantities = Quantities.of(done.case)
    blocks: list[Block] = [
        Text.of(
            "The article prints one contact rule. The same small study under all three shows which of its "
            "results are the rule’s and which are the pair’s: the ends of the window without impacts, the "
            "motion at the two multibody speeds, and a sweep over D, followed down."
        ),
        Bullets(tuple(Text.of(Strong(e.rule), f": {RULES[e.rule]}{_own(e)}.") for e in done.rules)),
        _window(done.rules, quantities),
        *_said_of_window(done.rules),
        _backlash(done),
        *_said_of_backlash(done.rules),
    ]
    return Section("rules", "What the contact rule changes", tuple(blocks))


def _own(effect: RuleEffect) -> str:
    return "; the rule of this case" if effect.stated else ""


def _window(rules: tuple[RuleEffect, ...], quantities: Quantities) -> Table:
    rows: list[tuple[Cell, ...]] = [
        ("lower end of the window", *(_end(e.lower, quantities) for e in rules)),
        ("upper end of the window", *(_end(e.upper, quantities) for e in rules)),
    ]
    for i, first in enumerate(rules[0].speeds):
        place = quantities.place("omega", first.value)
        rows.append((place, *(_label(e.speeds[i]) for e in rules)))
    return Table(
        "table-rules-window",
        "The window without impacts, its ends solved for, and cold starts at the multibody speeds, by "
        "contact rule.",
        ("", *(e.rule for e in rules)),
        tuple(rows),
        widths=(19, *[81 // len(rules)] * len(rules)),
    )


def _end(touch: RuleGrazing | None, quantities: Quantities) -> Cell:
    if touch is None:
        return "not found"
    place = quantities.place("omega", touch.value, 9)
    return [place, f"{short(touch.label_below)} → {short(touch.label_above)}", touch.kind]


def _label(found: RuleLabel) -> Cell:
    return f"{short(found.label)}, {found.certificate}"


def _said_of_window(rules: tuple[RuleEffect, ...]) -> list[Block]:
    """How the ends differ from those of the case's own rule, as computed."""
    first, said = rules[0], []
    for other in rules[1:]:
        pairs = [(first.lower, other.lower), (first.upper, other.upper)]
        moved = [b.value / a.value - 1.0 for a, b in pairs if a is not None and b is not None]
        if len(moved) < 2:
            text = ": the window was not found at both ends; nothing to compare."
            said.append(Text.of(Strong(other.rule), text))
        elif max(map(abs, moved)) <= SAME_VALUE:
            said.append(
                Text.of(
                    Strong(other.rule),
                    f": both ends are those of {first.rule}, to {max(map(abs, moved)):.0e} of themselves. "
                    "Until it touches, the motion in permanent contact is the same linear one, and it "
                    "touches the same boundary.",
                )
            )
        else:
            said.append(Text.of(Strong(other.rule), f": {_moved(first, other, moved)}"))
    return [Bullets(tuple(said))] if said else []


def _moved(first: RuleEffect, other: RuleEffect, moved: list[float]) -> str:
    text = f"the ends lie {percent(moved[0], 3)} and {percent(moved[1], 3)} from those of {first.rule}. "
    assert other.lower is not None
    assert first.lower is not None
    if {other.lower.surface, first.lower.surface} == {"gap", "force"}:
        text += (
            "The motion in permanent contact is the same linear one, but a contact that cannot pull ends "
            "where its force falls to zero. That is before the gap opens, so the window is narrower."
            if other.lower.surface == "force"
            else "A contact that may pull lasts until the gap opens, which is later."
        )
    return text


def _backlash(done: Reproduction) -> Table:
    rules = done.rules
    rows = [
        (number(first.value), *(_backlash_cell(e.backlash[i]) for e in rules))
        for i, first in enumerate(rules[0].backlash)
    ]
    where = fixed_words(done.backlash.fixed)
    return Table(
        "table-rules-backlash",
        f"Motions over D at {where}, followed down, by contact rule.",
        ("D", *(e.rule for e in rules)),
        tuple(rows),
        frozenset({0}),
    )


def _backlash_cell(found: RuleLabel) -> str:
    if isinstance(found.label, Signature):  # the label says it
        return short(found.label)
    return f"{found.label}, back side {'hit' if found.back_hit else 'not hit'}"


def _said_of_backlash(rules: tuple[RuleEffect, ...]) -> list[Block]:
    said = tuple(Text.of(Strong(e.rule), f": {_back_side(e)}") for e in rules)
    return [
        Bullets(said),
        Note(
            Text.of(
                "What else differs between the rules lies beyond the first touch: there damping in the gap "
                "takes energy out of a free flight, or does not. Labels are those of one sweep; other "
                "motions may coexist."
            )
        ),
    ]


def _without_back_side(label: Label | None) -> bool:
    return isinstance(label, Signature) and label.back == 0


def _back_side(effect: RuleEffect) -> str:
    """The back-side grazings along D, and from where on no motion of the sweep meets the back side."""
    met = [
        f"D = {number(t.value, 8)} ({short(t.label_below)} → {short(t.label_above)})"
        for t in effect.back_side
    ]
    events = f"back-side grazings at {', '.join(met)}. " if met else "no back-side grazing was located. "
    free = next((t for t in reversed(effect.back_side) if _without_back_side(t.label_above)), None)
    periodic = [p for p in effect.backlash if isinstance(p.label, Signature)]
    if free is not None and periodic and periodic[-1] is effect.backlash[-1]:
        return events + f"Stable P-Q-0 motion from D = {number(free.value, 8)} on, to the end of the sweep."
    if not periodic:
        quiet = [p.value for p in effect.backlash if not p.back_hit]
        last = f"; the back side is not hit any more from D = {number(min(quiet))} on" if quiet else ""
        return events + f"Every motion of the sweep is aperiodic or unresolved{last}."
    return events + "No start of stable P-Q-0 motion was located."
