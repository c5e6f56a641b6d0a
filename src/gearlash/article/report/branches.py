"""The two sweeps as branches: figures over the clouds, what coexists and why, every change as a special
point."""

from __future__ import annotations

from gearlash import branch_dataset, plots
from gearlash.article import Diagram, Reproduction
from gearlash.article.reproduction import Explained, Scan, Stretch
from gearlash.case import Case
from gearlash.plots.regimes import short
from gearlash.report.blocks import Block, Cell, Figure, Section, Table, Text
from gearlash.report.numbers import complex_number, number, scientific
from gearlash.report.pictures import Picture

from .coexistence import DIGITS, Chain, counted, end_words, sentences, told
from .quantities import Quantities, fixed_words, symbol
from .words import plural

DRAWN = 6  # longest period of a branch in the picture of a whole sweep
BESIDE = 0.4  # of the width of an interval, on either side of it in its own picture
TABLED = 1e-3  # of the swept interval: narrower stable stretches are left out of the table
TITLES = {"omega": "Mesh frequency", "D": "Backlash"}
NONE = "none of these branches has it"


def section(done: Reproduction) -> tuple[Section, list[Picture]]:
    """One part for each scan."""
    quantities, parts, pictures = Quantities.of(done.case), [], []
    for scan in done.scans:
        diagram = done.frequency if scan.parameter == done.frequency.parameter else done.backlash
        made, drawn = _part(done.case, scan, diagram, quantities)
        parts.append(made)
        pictures += drawn
    intro = Text.of(
        "A sweep shows which motion attracts. Why one ends, what lies beside it and what separates the two "
        "is seen on branches of periodic orbits: every periodic attractor of the sweeps was followed in its "
        "parameter, stable or not, through grazings and round folds, to the ends of the sweep or until it "
        "closed. Motions that no sweep met, and that no branch leads to, are not in it."
    )
    return Section("branches", "The sweeps as branches", (intro,), tuple(parts)), pictures


def _part(case: Case, scan: Scan, diagram: Diagram, quantities: Quantities) -> tuple[Section, list[Picture]]:
    stem, name = f"branches-{scan.parameter}", symbol(scan.parameter)
    datasets = {
        number: branch_dataset(case, branch, extremes=False)
        for number, branch in enumerate(scan.branches)
        if branch.points[0].period <= DRAWN or any(number in _numbers(chain) for chain in told(scan))
    }
    whole = [datasets[i] for i, branch in enumerate(scan.branches) if branch.points[0].period <= DRAWN]
    over = TITLES.get(scan.parameter, scan.parameter).lower()
    title = f"{case.name}: branches over {over}, at {fixed_words(scan.fixed)}"
    look = {"cloud": diagram.dataset, "units": quantities.units, "title": title}
    pictures = [Picture(stem, plots.branch_diagram, (whole, "strobes"), look)] if whole else []
    figures = [_figure(scan, stem, quantities, len(whole))] if whole else []
    widest = max(told(scan), key=lambda chain: chain.width, default=None)
    if widest is not None:
        near = [datasets[i] for i in sorted(_numbers(widest))]
        zoom = {**look, "span": _span(widest)}
        pictures.append(Picture(f"{stem}-beside", plots.branch_diagram, (near, "strobes"), zoom))
        figures.append(_zoom(widest, f"{stem}-beside", quantities))
    blocks: list[Block] = [Text.of(f"At {fixed_words(scan.fixed)}: {counted(scan)}")]
    blocks += [*figures[:1], *sentences(scan), *figures[1:], _events(scan, stem), _stable(scan, stem)]
    blocks += _left(scan)
    title = f"{TITLES.get(scan.parameter, scan.parameter)} {name}"
    return Section(f"section-{stem}", title, tuple(blocks)), pictures


def _numbers(chain: Chain) -> set[int]:
    """Branches that have a part in it."""
    return {stretch.branch for stretch in chain.stretches}


def _span(chain: Chain) -> tuple[float, float]:
    """What is shown of it: within the sweep, with room on both sides."""
    room = BESIDE * (chain.upper - chain.lower)
    return max(chain.scan.lower, chain.lower - room), min(chain.scan.upper, chain.upper + room)


def _figure(scan: Scan, stem: str, quantities: Quantities, drawn: int) -> Figure:
    name, rest = symbol(scan.parameter), len(scan.branches) - drawn
    longer = f" {plural(rest, 'branch', 'branches')} of longer periods are not drawn." if rest else ""
    caption = (
        f"Branches of period up to {DRAWN} over {name} at {fixed_words(scan.fixed)}: X on σ_t, solid where "
        f"stable, dashed where not, with markers at special points; in grey what the sweeps found."
        f"{longer}"
    )
    words = f"{drawn} branches of periodic orbits over {name}, over the points of the sweeps"
    assumed = quantities.assumed(quantities.units.of_parameter(scan.parameter), quantities.units.length)
    return Figure(f"figure-{stem}", Text.of(caption), words, stem, assumed)


def _zoom(chain: Chain, stem: str, quantities: Quantities) -> Figure:
    name = symbol(chain.scan.parameter)
    caption = (
        f"The widest interval with more than one stable motion, {name} = {number(chain.lower, DIGITS)} to "
        f"{number(chain.upper, DIGITS)}, with the branches of {', '.join(chain.labels)} and all orbits on "
        "them in this picture."
    )
    words = f"Branches around the coexistence of {', '.join(chain.labels)}"
    assumed = quantities.assumed(quantities.units.of_parameter(chain.scan.parameter), quantities.units.length)
    return Figure(f"figure-{stem}", Text.of(caption), words, stem, assumed)


def _events(scan: Scan, stem: str) -> Table:
    head = (
        f"{symbol(scan.parameter)}, as swept", "kind", "labels below → above", "sweeps", "on the branch of",
        "multipliers outside the unit circle", "leading multiplier there", "apart by",
    )  # fmt: skip
    caption = "Changes that were located along the sweeps, and the special point of a branch that each is."
    return Table(
        f"table-{stem}-events",
        caption,
        head,
        tuple(_event(scan, event) for event in scan.events),
        frozenset({0, 7}),
        widths=(12, 11, 16, 10, 15, 12, 14, 10),
    )


def _event(scan: Scan, event: Explained) -> tuple[Cell, ...]:
    start = (
        f"{event.value:.10g}",
        event.kind,
        f"{short(event.before)} → {short(event.after)}",
        ", ".join(event.directions),
    )
    special = event.special
    if special is None:
        return (*start, NONE, "", "", "")
    labels = dict.fromkeys((short(special.label_before), short(special.label_after)))
    return (
        *start,
        f"{', '.join(labels)} (branch {event.branch + 1})",
        f"{special.unstable_before} → {special.unstable_after}",
        complex_number(complex(special.point.multipliers[0])),
        scientific(event.apart),
    )


def _stable(scan: Scan, stem: str) -> Table:
    width = scan.upper - scan.lower
    shown = [each for each in scan.stretches if each.upper - each.lower >= TABLED * width]
    left = len(scan.stretches) - len(shown)
    caption = "Where the branches are stable, and what each stable stretch ends at."
    if left:
        caption += (
            f" {plural(left, 'stretch', 'stretches')} narrower than {TABLED:.1%} of the sweep left out."
        )
    head = ("motion", "branch", f"{symbol(scan.parameter)} from", "where", "to", "where")
    rows = tuple(_stretch(each) for each in shown)
    return Table(f"table-{stem}-stable", caption, head, rows, frozenset({1, 2, 4}))


def _stretch(each: Stretch) -> tuple[Cell, ...]:
    return (
        short(each.label),
        str(each.branch + 1),
        f"{each.lower:.10g}",
        end_words(each.lower_end, each),
        f"{each.upper:.10g}",
        end_words(each.upper_end, each),
    )


def _left(scan: Scan) -> list[Block]:
    unexplained = [text for branch in scan.branches for text in branch.unexplained]
    said = []
    if scan.left:
        said.append(f"Not followed: {'; '.join(scan.left)}.")
    if unexplained:
        said.append(
            f"Steps on which something changed that no special point was found for: {'; '.join(unexplained)}."
        )
    return [Text.of(" ".join(said))] if said else []
