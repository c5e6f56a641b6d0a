"""The bifurcation diagrams of both scans, with the changes and events that are marked in them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gearlash.case import Case
from gearlash.results import Direction, sweep_dataset
from gearlash.studies.transition import Transition

from .reproduction import Diagram, DiagramMark, Event
from .rows import Found, Row


def diagram(
    case: Case,
    name: str,
    fixed: Mapping[str, float],
    done: Sequence[Row],
    found: Sequence[Found],
    events: Sequence[Event],
) -> Diagram:
    """The sweeps over one parameter, with the changes that were met in them; those that are an event of the
    article are marked as such."""
    special = {event.value for event in events if event.found}
    marks = tuple(_mark(t, directions, t.value in special) for t, directions in found)
    return Diagram(name, dict(fixed), sweep_dataset(case, [row.sweep for row in done]), marks)


def _mark(transition: Transition, directions: Sequence[Direction], article: bool) -> DiagramMark:
    point = transition.point
    boundary = point.touch.boundary if point is not None and point.is_grazing else 0
    where = "all" if len(directions) == 3 else ",".join(str(d) for d in directions)
    return DiagramMark(
        transition.value,
        transition.kind,
        boundary,
        transition.label_below,
        transition.label_above,
        where,
        article,
    )
