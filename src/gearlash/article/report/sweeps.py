"""The two sweeps: bifurcation diagrams and the list of what was located along them."""

from __future__ import annotations

from gearlash import plots
from gearlash.article import Diagram, Reproduction
from gearlash.article.force import FORCE
from gearlash.plots.regimes import short
from gearlash.report.blocks import Cell, Figure, Ref, Section, Table, Text
from gearlash.report.numbers import number
from gearlash.report.pictures import Picture

from .quantities import Quantities, fixed_words, symbol
from .words import plural

MOST_TEXTS = 14  # labelled lines of a diagram beside those of the article's events
BOUNDARY = {1: "Σ₁", -1: "Σ₂"}


def section(done: Reproduction) -> tuple[Section, list[Picture]]:
    """Both diagrams."""
    quantities = Quantities.of(done.case)
    parts, pictures = [], []
    for diagram, title in ((done.frequency, "Mesh frequency"), (done.backlash, "Backlash")):
        stem = f"sweep-{diagram.parameter}"
        data = diagram.dataset, marks(diagram), quantities.units, FORCE
        title_drawn = f"{done.case.name}: sweep over {title.lower()}, at {fixed_words(diagram.fixed)}"
        pictures.append(Picture(stem, plots.diagram, data, {"title": title_drawn}))
        parts.append(_part(diagram, title, stem, quantities))
    intro = Text.of(
        "Each point of a diagram is an attractor, found three ways: from rest at every value (cold "
        "start), and by following the motion along the parameter, up and down. Where the three differ, "
        "motions coexist."
    )
    return Section("sweeps", "Sweeps", (intro,), tuple(parts)), pictures


def marks(diagram: Diagram) -> tuple[plots.Mark, ...]:
    """Lines of a diagram: those of the article's events in bold, some others with text, the rest as ticks."""
    texts = {id(m) for m in [m for m in diagram.marks if not m.article][:: _stride(diagram)]}
    return tuple(
        plots.Mark(m.value, m.kind, _text(m) if m.article or id(m) in texts else "", m.article)
        for m in diagram.marks
    )


def _stride(diagram: Diagram) -> int:
    return max(1, -(-sum(not m.article for m in diagram.marks) // MOST_TEXTS))


def _text(mark) -> str:
    change = f"  {short(mark.before)} → {short(mark.after)}" if mark.before and mark.after else ""
    return f"{mark.value:.4f}{change}"


def _part(diagram: Diagram, title: str, stem: str, quantities: Quantities) -> Section:
    values, where = diagram.dataset[diagram.parameter].values, fixed_words(diagram.fixed)
    name, total = symbol(diagram.parameter), diagram.dataset["label"].size
    caption = Text.of(
        f"{title} {name} swept at {where}: labels, X on σ_t, mesh force F on σ_d and σ_b (in the article's "
        "sign, F = −Φ; its σ_b samples the releases S3 → S2), and the largest Lyapunov exponent. Points "
        "swept up or down are drawn only where they differ from the cold start; two aperiodic motions "
        "count as the same. Bold lines are events of the article."
    )
    changes = plural(len(diagram.marks), "located change")
    words = f"Bifurcation diagram over {title.lower()} with {changes} of the motion"
    blocks = (
        Text.of(
            f"{name} from {number(values[0])} to {number(values[-1])} at {where}, {total} attractors. ",
            *_doubt(diagram),
            "Every located change of the motion is in ",
            Ref(f"table-{stem}"),
            ".",
        ),
        Figure(
            f"figure-{stem}",
            caption,
            words,
            stem,
            quantities.assumed(quantities.units.of_parameter(diagram.parameter)),
        ),
        _table(diagram, stem),
    )
    return Section(f"section-{stem}", f"{title} {name}", blocks)


def _doubt(diagram: Diagram) -> tuple[str, ...]:
    labels = diagram.dataset["label"].values
    unresolved = int((labels == "unresolved").sum())
    missing = int((labels == "").sum())
    said = []
    if unresolved:
        said.append(
            f"{unresolved} of them are unresolved: neither proved periodic nor shown aperiodic within the "
            "budget. "
        )
    if missing:
        said.append(f"{missing} were not computed or failed; they are left out. ")
    return tuple(said)


def _table(diagram: Diagram, stem: str) -> Table:
    rows: list[tuple[Cell, ...]] = [
        (
            f"{mark.value:.8g}",
            mark.kind,
            BOUNDARY.get(mark.boundary, ""),
            f"{short(mark.before)} → {short(mark.after)}",
            mark.direction.replace(",", ", "),
            "event of the article" if mark.article else "",
        )
        for mark in diagram.marks
    ]
    head = (symbol(diagram.parameter), "kind", "boundary", "labels below → above", "found in the sweeps", "")
    return Table(
        f"table-{stem}",
        "Changes of the motion solved for along the sweeps.",
        head,
        tuple(rows),
        frozenset({0}),
    )
