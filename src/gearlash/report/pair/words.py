"""Speeds, bands and ends of a pair in words, in the unit of its speed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from gearlash.case.edges import shown_distance, shown_edge
from gearlash.plots.regimes import short
from gearlash.results.pair_units import PairUnits
from gearlash.results.zone_words import event, percent
from gearlash.studies.bands import Band
from gearlash.studies.zone_end import RANGE, Margin, ZoneEnd
from gearlash.system import Label

MOST_LABELS = 4


@dataclass(frozen=True)
class Words:
    """How the numbers of one pair are told; ``here`` is its present speed ω."""

    units: PairUnits
    here: float

    def speed(self, omega: float, digits: int = 5) -> str:
        """``4200 rpm``, ``omega = 0.75``."""
        return self._named(f"{self.units.speed.factor * omega:.{digits}g}")

    def edge(self, end: ZoneEnd, inwards: int) -> str:
        """The end of an interval, rounded into it; the number alone."""
        factor = self.units.speed.factor
        if end.kind == RANGE:  # as it was asked for
            return f"{factor * end.value:.5g}"
        return shown_edge(factor * end.value, inwards, factor * self.here)

    def between(self, low: str, high: str) -> str:
        """Two numbers as an interval."""
        unit = self.units.speed.name
        return f"{low} to {high} {unit}" if unit else f"omega = {low} to {high}"

    def reach(self, low: float, high: float) -> str:
        """How far was looked."""
        factor = self.units.speed.factor
        return self.between(f"{factor * low:.5g}", f"{factor * high:.5g}")

    def span(self, lower: ZoneEnd, upper: ZoneEnd) -> str:
        """An interval of speed."""
        low, high = self.edge(lower, 0), self.edge(upper, 0)
        return self._named(low) if low == high else self.between(low, high)

    def bands(self, found: Sequence[Band]) -> str:
        """Bands in ascending order; neighbours that touch are one, with what is said of their parts."""
        groups: list[list[Band]] = []
        for band in found:
            if groups and groups[-1][-1].upper.value == band.lower.value:
                groups[-1].append(band)
            else:
                groups.append([band])
        return "; ".join(self._group(group) for group in groups)

    def _group(self, group: Sequence[Band]) -> str:
        labels = tuple(dict.fromkeys(label for band in group for label in band.labels))
        text = self.span(group[0].lower, group[-1].upper)
        if labels:
            text += f" ({labelled(labels)})"
        beside = [band for band in group if not band.every]
        if beside and len(beside) == len(group):
            return f"{text}, in all of it beside a motion that does not"
        if beside:
            parts = " and ".join(self.span(band.lower, band.upper) for band in beside)
            return f"{text}, from {parts} beside a motion that does not"
        return text

    def margin(self, margin: Margin, inwards: int) -> str:
        """``teeth begin to separate (grazing) at 4114.1 rpm, 85.9 rpm (2.0 %) below``."""
        factor, end = self.units.speed.factor, margin.end
        apart = shown_distance(factor * self.here, factor * end.value, inwards)
        at = self._named(self.edge(end, inwards))
        side = "below" if inwards > 0 else "above"
        distance = f"{apart} {self.units.speed.name}".rstrip()
        return f"{event(end, True)} at {at}, {distance} ({percent(margin.percent)} %) {side}"

    def _named(self, number: str) -> str:
        unit = self.units.speed.name
        return f"{number} {unit}" if unit else f"omega = {number}"


def labelled(labels: Sequence[Label]) -> str:
    """Labels of motions, a few of them by name."""
    shown = ", ".join(short(label) for label in labels[:MOST_LABELS])
    more = len(labels) - MOST_LABELS
    return f"{shown} and {more} more" if more > 0 else shown


def broken(labels: Sequence[Label | None]) -> list[bool]:
    """Whether each is another one than its neighbour below."""
    return [False, *(a != b for a, b in pairwise(labels))]
