"""What is stable side by side, in sentences made of the special points that bound it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from gearlash import EndKind, EndOfBranch, SpecialKind, SpecialPoint
from gearlash.article.reproduction import Explained, Scan, Stretch, Together
from gearlash.plots.regimes import short
from gearlash.report.blocks import Bullets, Inline, Strong, Text
from gearlash.report.numbers import number

from .quantities import symbol
from .words import joined, plural

DIGITS = 7
TOLD = 1e-3  # of the swept interval: narrower coexistence is only counted
WAYS = {"up": "upwards", "down": "downwards"}


@dataclass(frozen=True, eq=False)
class Chain:
    """Neighbouring intervals in which motions coexist; each has a motion in common with the next."""

    scan: Scan
    intervals: tuple[Together, ...]

    @property
    def lower(self) -> float:
        return self.intervals[0].lower

    @property
    def upper(self) -> float:
        return self.intervals[-1].upper

    @property
    def width(self) -> float:
        return (self.upper - self.lower) / (self.scan.upper - self.scan.lower)

    @property
    def stretches(self) -> tuple[Stretch, ...]:
        """All of them, by rising value."""
        numbers = sorted({i for each in self.intervals for i in each.stretches})
        return tuple(self.scan.stretches[i] for i in numbers)

    def named(self, stretch: Stretch) -> str:
        """Its label, with the number of its branch where another branch has the same label here."""
        twins = {each.branch for each in self.stretches if each.label == stretch.label}
        return short(stretch.label) + (f" (branch {stretch.branch + 1})" if len(twins) > 1 else "")

    @property
    def labels(self) -> tuple[str, ...]:
        """Of all of them, each once."""
        return tuple(dict.fromkeys(short(each.label) for each in self.stretches))


def chains(scan: Scan) -> tuple[Chain, ...]:
    """Where motions coexist along a scan, by rising value."""
    made: list[list[Together]] = []
    for each in scan.together:
        last = made[-1][-1] if made else None
        if last is not None and last.upper == each.lower and set(last.stretches) & set(each.stretches):
            made[-1].append(each)
        else:
            made.append([each])
    return tuple(Chain(scan, tuple(intervals)) for intervals in made)


def told(scan: Scan) -> tuple[Chain, ...]:
    """Those that are wide enough to be told one by one."""
    return tuple(chain for chain in chains(scan) if chain.width >= TOLD)


def sentences(scan: Scan) -> list[Text | Bullets]:
    """What coexists, from where to where, what bounds each motion, and which way a sweep goes on."""
    found = chains(scan)
    wide, narrow = (
        [chain for chain in found if (chain.width >= TOLD) is told_apart] for told_apart in (True, False)
    )
    if not found:
        return [Text.of("Along these branches no two stable motions lie side by side.")]
    blocks: list[Text | Bullets] = []
    if wide:
        blocks += [Text.of("Stable side by side:"), Bullets(tuple(map(_told, wide)))]
    if narrow:
        each = "; ".join(
            f"{joined([chain.named(each) for each in chain.stretches])}, {_from_to(chain)}"
            for chain in narrow
        )
        blocks.append(Text.of(f"In intervals narrower than {TOLD:.1%} of the sweep: {each}."))
    return blocks


def _told(chain: Chain) -> Text:
    parts: list[Inline] = [
        Strong(f"{symbol(chain.scan.parameter)} = {_from_to(chain)}: "),
        _pairs(chain),
        " ",
    ]
    parts += [f"{_stable(chain, each)} " for each in chain.stretches]
    parts += [f"{text} " for text in _hysteresis(chain)]
    return Text(tuple(parts))


def _from_to(chain: Chain) -> str:
    return f"{number(chain.lower, DIGITS)} to {number(chain.upper, DIGITS)}"


def _pairs(chain: Chain) -> str:
    """Which motions, from where to where."""
    names = [
        joined([chain.named(chain.scan.stretches[i]) for i in each.stretches]) for each in chain.intervals
    ]
    if len(names) == 1:
        return f"{names[0]}."
    ends = (number(each.upper, DIGITS) for each in chain.intervals)
    return "; ".join(f"{name} up to {end}" for name, end in zip(names, ends, strict=True)) + "."


def _stable(chain: Chain, stretch: Stretch) -> str:
    """``3-3-1 is stable from D = 0.4521586 (its period doubling) to 0.4854106 (its fold).``"""
    lower, upper = (end_words(end, stretch) for end in (stretch.lower_end, stretch.upper_end))
    return (
        f"{chain.named(stretch)} is stable from {symbol(chain.scan.parameter)} = "
        f"{number(stretch.lower, DIGITS)} ({lower}) to {number(stretch.upper, DIGITS)} ({upper})."
    )


def end_words(end: SpecialPoint | EndOfBranch, stretch: Stretch) -> str:
    """What a stable stretch ends at."""
    if isinstance(end, EndOfBranch):
        return "end of the sweep" if end.kind in (EndKind.LOWER, EndKind.UPPER) else str(end.kind)
    if end.kind is SpecialKind.FOLD:
        return "its fold"
    if end.kind is SpecialKind.DOUBLING:
        return "its period doubling"
    if end.kind is SpecialKind.JOINS:
        return f"joins the orbit of period {end.point.period // 2} at its doubling"
    if end.kind is SpecialKind.GRAZING:
        beyond = end.label_after if end.label_before == stretch.label else end.label_before
        return f"grazing, {short(beyond)} beyond it"
    return str(end.kind)


def _hysteresis(chain: Chain) -> Iterator[str]:
    """What the sweeps did at the folds that bound the coexistence."""
    bounds = {id(end) for each in chain.stretches for end in (each.lower_end, each.upper_end)}
    for event in chain.scan.events:
        if event.kind == SpecialKind.FOLD and id(event.special) in bounds:
            yield from _left(chain.scan, event)


def _left(scan: Scan, event: Explained) -> Iterator[str]:
    name = symbol(scan.parameter)
    for way in (way for way in WAYS if way in event.directions):
        one, two = (event.before, event.after) if way == "up" else (event.after, event.before)
        if event.special is None or one != event.special.label_before:
            continue  # what was found beyond the fold was another motion before it, too
        yield (
            f"Followed {WAYS[way]}, {short(one)} is left at the fold at {name} = "
            f"{number(event.value, DIGITS)}, for {short(two)}."
        )


def counted(scan: Scan) -> str:
    """How much of the sweeps the branches account for."""
    matched = sum(event.special is not None for event in scan.events)
    text = (
        f"{plural(len(scan.branches), 'branch', 'branches')} with "
        f"{sum(len(branch.points) for branch in scan.branches)} orbits, stable and unstable; "
        f"{scan.on_branches} of {scan.attractors} periodic attractors of the sweeps lie on one of them, and "
        f"{matched} of {len(scan.events)} located changes are special points of theirs (same kind, values "
        "equal to a relative 10⁻⁹)."
    )
    if scan.switched:
        switched = plural(len(scan.switched), "branch", "branches")
        text += f" {switched} had no attractor of a sweep: switched to at a doubling."
    return text
