"""What a report rests on: values that were assumed, how was looked."""

from __future__ import annotations

from gearlash.case import Value
from gearlash.case.units import pretty
from gearlash.plots.stated_curves import curves_of, notice, stated_curves
from gearlash.report.blocks import Block, Cell, Figure, Section, Table, Text
from gearlash.report.numbers import number
from gearlash.report.pictures import Picture
from gearlash.results.provenance import package_version
from gearlash.studies import Zones
from gearlash.studies.assessment import Assessment
from gearlash.studies.beside import THROWS
from gearlash.studies.grids import Grids

from . import ranges
from .contents import Contents

CURVES = "Stiffness and error as the case states them, and the series that the model takes for each."

GEARS_ALONE = (
    "Estimated masses and inertias are those of the gears alone. What turns rigidly with a gear is in the "
    "model only as far as added_inertia and added_mass state it; motor, load and whatever is behind a "
    "coupling or a shaft that twists are no part of it, nor are their torsional frequencies."
)


def pictures(contents: Contents) -> list[Picture]:
    """Curves that the case states."""
    curves = curves_of(contents.found.case)
    return [Picture("curves", stated_curves, (curves,))] if curves else []


def section(contents: Contents) -> Section:
    """Assumed values with their sources, method."""
    case, found = contents.found.case, contents.found
    rows: list[tuple[Cell, ...]] = []
    last = ""
    for value in ranges.not_given(case):
        why = value.reason or value.description
        own = "the same" if why == last else why
        rows.append((value.path, _shown(value.value, value.unit), _range(value), str(value.provenance), own))
        last = why
    blocks: list[Block] = list(ranges.table(found))
    curves = curves_of(case)
    if curves:
        told = " ".join(filter(None, [CURVES, notice(curves)]))
        blocks.append(Figure("figure-curves", Text.of(told), told, "curves"))
    if rows:
        head = ("value", "is", "range", "origin", "source or reason")
        caption = (
            "Values that the case does not give: every number of this report rests on them. Ranges are "
            "those of the estimates."
        )
        blocks.append(Table("assumed", caption, head, tuple(rows), widths=(23, 14, 17, 9, 37)))
    else:
        blocks.append(Text.of("Every value of the case is given."))
    if any(value.path.endswith(".inertia") and value.estimated for value in case.values()):
        blocks.append(Text.of(GEARS_ALONE))
    blocks.append(
        Text.of(
            f"Bands: from sweeps of {len(found.axis)} speeds upwards and downwards, at each of them from the "
            f"cold start{_thrown(found)}, and from beyond the ends of the motions found "
            f"({found.impact_free.starts} starts in all); {_followed(found.impact_free)} "
            "That there is no other motion is not claimed."
        )
    )
    told = Grids.of(found.attractor.propagators).told
    if told:
        blocks.append(Text.of(told))
    if contents.missing:
        blocks.append(Text.of(f"The report was stopped early; not computed: {', '.join(contents.missing)}."))
    blocks.append(Text.of(f"Made by gearlash {package_version()}; case {case.hash[:12]}."))
    return Section("basis", "What this rests on", tuple(blocks))


def _thrown(found: Assessment) -> str:
    """With how much the teeth were thrown."""
    if not found.throws:
        return ""
    many = ", ".join(f"{factor:g}" for factor in THROWS)
    return (
        f" and from {found.throws} states with teeth thrown together or apart (that start with its relative "
        f"velocity changed by {many} times what carries the present motion across its backlash)"
    )


def _followed(zones: Zones) -> str:
    """Which motions were followed."""
    count = len(zones.branches)
    if not zones.left_out:
        many = f"{count} branch{'' if count == 1 else 'es'}"
        return (
            f"every periodic motion was followed along its whole branch ({many}), and ends of bands "
            "are its special points."
        )
    return (
        f"periodic motions were followed along {count} branches, those first on which bands depend, and "
        "ends of bands are their special points. Then the work that a verdict allows was spent: "
        f"{zones.left_out} motions and ends of motions were not followed farther, and count at the speeds "
        "at which sweeps saw them."
    )


def _range(value: Value) -> str:
    """Of an estimated value, in its unit."""
    if value.least is None or value.greatest is None:
        return ""
    return f"{number(value.least, 3)} to {number(value.greatest, 3)}"


def _shown(value: float | str, unit: str) -> str:
    return value if isinstance(value, str) else f"{number(value, 5)} {pretty(unit)}".rstrip()
