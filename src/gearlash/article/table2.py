"""The article's Table 2, filled from what was located."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from gearlash.studies.transition import Transition
from gearlash.system import Label, Signature, label_text

from .events import Found, exponent_at
from .judge import NOT_FOUND, REPRODUCED, coincides
from .kinds import CODIMENSION_TWO, STANDARD, table2_type
from .reproduction import Event, Table2Row


def fill(found: Sequence[Found], events: Sequence[Event]) -> tuple[Table2Row, ...]:
    """The three rows: what the article says of each type, and what this run located of it."""
    transitions = [transition for transition, _ in found]
    matched = {event.value for event in events if event.found}
    grazes = [t for t in transitions if t.point is not None and t.point.is_grazing]
    standard = [t for t in grazes if t.point is not None and table2_type(t.point) == STANDARD]
    double = [t for t in grazes if t.point is not None and table2_type(t.point) == CODIMENSION_TWO]
    smooth = [t for t in transitions if t.point is not None and not t.point.is_grazing]
    kept = all(_period(t.label_below) == _period(t.label_above) for t in standard)
    negative = all(exponent_at(t) < 0.0 for t in standard)
    return (
        _row(
            "Standard Grazing Bifurcation",
            "LLE < 0",
            "No change",
            "Sudden change (birth or death of impacts)",
            "Boundaries of “1-0” zones (e.g., ω≈1.112, 0.972)",
            sorted(standard, key=lambda t: t.value not in matched),
            REPRODUCED if standard and kept and negative else NOT_FOUND,
            f"{len(standard)} located; the period is kept at {_all(kept)} of them, the exponent is negative "
            f"at {_all(negative)}. The change of the counts is sudden, that of the motion is not: the map is "
            "C¹ there.",
        ),
        _codimension_two(double, grazes, events),
        _row(
            "Smooth Bifurcation (e.g., Period-doubling, Saddle-node)",
            "LLE ≈ 0 or specific multiplier condition",
            "Changes or leads to chaos",
            "May change gradually or chaotically",
            "Various regions leading to chaotic motion",
            smooth,
            REPRODUCED if smooth else NOT_FOUND,
            f"{len(smooth)} located: "
            + ", ".join(f"{n} {kind}" for kind, n in _kinds(smooth).items())
            + ". At each the critical multiplier is ±1 by construction.",
        ),
    )


def _row(kind, condition, period, pattern, region, transitions, verdict, note) -> Table2Row:
    shown: list[Transition] = list(transitions)[:6]  # examples
    return Table2Row(
        type=kind,
        condition=condition,
        reported_effect_p=period,
        reported_effect_qr=pattern,
        reported_region=region,
        events=tuple(f"{_symbol(t)} = {t.value:.4f}" for t in shown),
        exponent=tuple(exponent_at(t) for t in shown),
        periods=tuple(f"{_period(t.label_below)} → {_period(t.label_above)}" for t in shown),
        patterns=tuple(f"{label_text(t.label_below)} → {label_text(t.label_above)}" for t in shown),
        verdict=verdict,
        note=note,
    )


def _codimension_two(
    double: Sequence[Transition], grazes: Sequence[Transition], events: Sequence[Event]
) -> Table2Row:
    """Points with a multiplier at −1; else pairs of doubling and grazing, judged by whether the printed
    digits tell them apart."""
    row = _row(
        "Co-dimension-2 Grazing Bifurcation",
        "LLE ≈ 0 (coupled with period-doubling)",
        "Changes (e.g., P/2)",
        "Sudden change",
        "Within chaotic or period-multiplying regimes (e.g., D≈0.3523)",
        double,
        REPRODUCED if double else NOT_FOUND,
        f"{len(double)} located." if double else _nearest_coincidence(grazes),
    )
    pairs = [(event, event.coincidence) for event in events if event.coincidence is not None]
    if double or not pairs:
        return row
    event, both = min(pairs, key=lambda pair: pair[1].apart)
    name = {"omega": "ω"}.get(event.parameter, event.parameter)
    return replace(
        row,
        events=(f"{name} = {event.value:.4f}",),
        exponent=(event.exponent,),
        periods=(f"{_period(event.label_below)} → {_period(event.label_above)}",),
        patterns=(f"{event.label_below} → {event.label_above}",),
        verdict=coincides(both.apart, both.doubling.value, event.digits),
        note=f"A doubling at {name} = {both.doubling.value:.7f} and a grazing {both.apart:.1e} beside it: "
        "one event to the article’s digits, two points in truth.",
    )


def _symbol(transition: Transition) -> str:
    return {"omega": "ω"}.get(transition.name, transition.name)


def _period(label: Label | None) -> str:
    return str(label.period) if isinstance(label, Signature) else label_text(label)


def _all(flag: bool) -> str:
    return "all" if flag else "not all"


def _kinds(transitions: Sequence[Transition]) -> dict[str, int]:
    counts: dict[str, int] = {}
    for transition in transitions:
        counts[transition.kind] = counts.get(transition.kind, 0) + 1
    return counts


def _nearest_coincidence(grazes: Sequence[Transition]) -> str:
    """The located grazing whose multipliers come nearest to -1."""
    points = [(t.point.to_doubling, t) for t in grazes if t.point is not None]
    if not points:
        return "No grazing was located."
    least, transition = min(points, key=lambda pair: pair[0])
    return (
        f"No located grazing has a multiplier at −1; the nearest is at {_symbol(transition)} = "
        f"{transition.value:.6f} ({transition.label_below} → {transition.label_above}) with least |λ+1| = "
        f"{least:.3f}. One parameter alone meets such a point only by coincidence."
    )
