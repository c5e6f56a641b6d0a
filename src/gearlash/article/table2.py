"""The article's Table 2, filled from special points of branches."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gearlash import SpecialKind, SpecialPoint
from gearlash.plots.words import GEARS
from gearlash.system import Label, Signature, label_text

from .judge import NOT_FOUND, REPRODUCED, coincides
from .kinds import CODIMENSION_TWO, STANDARD, table2_type
from .reproduction import Centre, Event, Explained, Scan, Table2Row
from .stretches import special_points

SMOOTH_KINDS = (SpecialKind.FOLD, SpecialKind.DOUBLING, SpecialKind.TORUS)
EXAMPLES = 6


def fill(
    scans: Sequence[Scan], events: Sequence[Event], points: Sequence[Centre] = ()
) -> tuple[Table2Row, ...]:
    """The three rows: what the article says of each type, and what the branches of this run have of it.

    Counted are special points that a stable orbit comes to; shown first are those that the article has, then
    others that the sweeps met. A row of its own has the points of two parameters behind the second type."""
    met = [special for scan in scans for special in met_by_stable(scan)]
    grazes = [special for special in met if special.is_grazing]
    standard = [special for special in grazes if table2_type(special) == STANDARD]
    double = [special for special in grazes if table2_type(special) == CODIMENSION_TWO]
    smooth = [special for special in met if special.kind in SMOOTH_KINDS]
    matched = {event.value for event in events if event.found}
    swept = sorted(
        (each for scan in scans for each in scan.events if each.special is not None),
        key=lambda each: each.point.value not in matched,
    )
    kept = all(special.label_before.period == special.label_after.period for special in standard)
    negative = all(exponent_at(special) < 0.0 for special in standard)
    return (
        _row(
            "Standard Grazing Bifurcation",
            "LLE < 0",
            "No change",
            "Sudden change (birth or death of impacts)",
            "Boundaries of “1-0” zones (e.g., ω≈1.112, 0.972)",
            [each for each in swept if each.point.is_grazing and table2_type(each.point) == STANDARD],
            REPRODUCED if standard and kept and negative else NOT_FOUND,
            f"{len(standard)} on the branches, where a stable orbit comes to them; the period is kept at "
            f"{_all(kept)} of them, the exponent is negative at {_all(negative)}. The change of the counts "
            "is sudden, that of the motion is not: the map is C¹ there.",
        ),
        _codimension_two(double, grazes, events),
        *map(_in_two_parameters, points),
        _row(
            "Smooth Bifurcation (e.g., Period-doubling, Saddle-node)",
            "LLE ≈ 0 or specific multiplier condition",
            "Changes or leads to chaos",
            "May change gradually or chaotically",
            "Various regions leading to chaotic motion",
            [each for each in swept if each.point.kind in SMOOTH_KINDS],
            REPRODUCED if smooth else NOT_FOUND,
            f"{len(smooth)} on the branches, where a stable orbit comes to them: "
            + ", ".join(f"{n} {kind}" for kind, n in Counter(str(each.kind) for each in smooth).items())
            + ". At each a multiplier is ±1, or a pair of them on the unit circle, by construction.",
        ),
    )


def met_by_stable(scan: Scan) -> list[SpecialPoint]:
    """Special points of its branches that a stable orbit comes to."""
    return [
        special
        for branch in scan.branches
        for special in special_points(branch)
        if min(special.unstable_before, special.unstable_after) == 0
    ]


def exponent_at(special: SpecialPoint) -> float:
    """Largest exponent of the orbit there, per unit of τ; at a doubling or fold zero but for rounding."""
    duration = special.period * 2.0 * np.pi / special.values["omega"]
    return float(np.log(np.abs(special.multipliers[0])) / duration)


def _row(
    kind: str,
    condition: str,
    period: str,
    pattern: str,
    region: str,
    found: Sequence[Explained],
    verdict: str,
    note: str,
) -> Table2Row:
    shown = list(found)[:EXAMPLES]
    return Table2Row(
        type=kind,
        condition=condition,
        reported_effect_p=period,
        reported_effect_qr=pattern,
        reported_region=region,
        events=tuple(f"{_symbol(each.point.name)} = {each.point.value:.4f}" for each in shown),
        exponent=tuple(exponent_at(each.point) for each in shown),
        periods=tuple(f"{_period(each.before)} → {_period(each.after)}" for each in shown),
        patterns=tuple(f"{label_text(each.before)} → {label_text(each.after)}" for each in shown),
        verdict=verdict,
        note=note,
    )


def _codimension_two(
    double: Sequence[SpecialPoint], grazes: Sequence[SpecialPoint], events: Sequence[Event]
) -> Table2Row:
    """Points with a multiplier at −1; else pairs of doubling and grazing, judged by whether the printed
    digits tell them apart."""
    row = _row(
        "Co-dimension-2 Grazing Bifurcation",
        "LLE ≈ 0 (coupled with period-doubling)",
        "Changes (e.g., P/2)",
        "Sudden change",
        "Within chaotic or period-multiplying regimes (e.g., D≈0.3523)",
        (),
        REPRODUCED if double else NOT_FOUND,
        f"{len(double)} on the branches." if double else _nearest_coincidence(grazes),
    )
    if double:
        row = replace(
            row,
            events=tuple(f"{_symbol(each.name)} = {each.value:.4f}" for each in double[:EXAMPLES]),
            exponent=tuple(map(exponent_at, double[:EXAMPLES])),
            periods=tuple(
                f"{each.label_below.period} → {each.label_above.period}" for each in double[:EXAMPLES]
            ),
            patterns=tuple(f"{each.label_below} → {each.label_above}" for each in double[:EXAMPLES]),
        )
    pairs = [(event, event.coincidence) for event in events if event.coincidence is not None]
    if double or not pairs:
        return row
    event, both = min(pairs, key=lambda pair: pair[1].apart)
    name = _symbol(event.parameter)
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


def _in_two_parameters(point: Centre) -> Table2Row:
    """Where both conditions hold at once, in every plane in which that was met."""
    periods, labels = (dict.fromkeys(row) for row in (map(_period, point.labels), map(str, point.labels)))
    return Table2Row(
        type="Co-dimension-2 Grazing Bifurcation: the point itself, in two parameters",
        condition="a multiplier −1 and a grazing of one orbit",
        reported_effect_p="",
        reported_effect_qr="",
        reported_region="not told: of two parameters one was varied",
        events=tuple(
            f"({', '.join(map(_symbol, place.parameters))}) = "
            f"({place.values[0]:.10g}, {place.values[1]:.10g})"
            for place in point.places
        ),
        exponent=tuple(place.exponent for place in point.places),
        periods=tuple(" → ".join(periods) for _ in point.places),
        patterns=tuple(" → ".join(labels) for _ in point.places),
        verdict="",
        note="Solved for; the largest estimate of an error is "
        f"{max(max(place.errors) for place in point.places):.0e}. The doubling and the grazings that are "
        "found over one parameter are cuts of the curves that leave it.",
    )


def _symbol(name: str) -> str:
    return GEARS.symbols.get(name, name)


def _period(label: Label | None) -> str:
    return str(label.period) if isinstance(label, Signature) else label_text(label)


def _all(flag: bool) -> str:
    return "all" if flag else "not all"


def _nearest_coincidence(grazes: Sequence[SpecialPoint]) -> str:
    """The grazing whose multipliers come nearest to -1."""
    if not grazes:
        return "No stable orbit comes to a grazing on the branches."
    nearest = min(grazes, key=lambda special: special.to_doubling)
    return (
        f"No grazing has a multiplier at −1; the nearest is at {_symbol(nearest.name)} = {nearest.value:.6f} "
        f"({nearest.label_below} → {nearest.label_above}) with least |λ+1| = {nearest.to_doubling:.3f}. One "
        "parameter alone meets such a point only by coincidence."
    )
