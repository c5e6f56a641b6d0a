"""What an engineer reads first: where the pair runs quietly, what holds of the article, and what it all
rests on.
"""

from __future__ import annotations

from gearlash.article import NOT_FOUND, REPRODUCED, SHIFTED, ReportedZone, Reproduction
from gearlash.article.reproduction import Reading
from gearlash.article.verified import Verified
from gearlash.article.zoning import EVERY, SOME
from gearlash.plots.regimes import short
from gearlash.report.blocks import Badge, Bullets, Inline, Ref, Section, Strong, Text
from gearlash.report.numbers import number

from . import conclusion
from .claims import counts
from .quantities import Quantities, fixed_words, symbol
from .words import joined, plural, verdict


def section(done: Reproduction, real: Verified | None = None) -> Section:
    """The summary in plain words; every number in it is computed. ``real`` is what is shown of real teeth."""
    quantities = Quantities.of(done.case)
    blocks = [
        Text.of(
            "Between the teeth of a gear pair there is a gap. When the load does not hold them together "
            "all the time they part and hit, on the driving side or even on the back, and the pair "
            "rattles. This report computes at which speeds and backlashes that happens for the pair of "
            "the article, exactly where it begins, and what of the article’s findings holds."
        ),
        Bullets(tuple(_zones(done, quantities))),
        _verdicts(done),
        *_missed(done),
        *([] if real is None else [_real(real)]),
        _basis(done),
    ]
    return Section("summary", "In plain words", tuple(blocks))


def _zones(done: Reproduction, quantities: Quantities) -> list[Text]:
    return [_zone(zone, quantities) for zone in done.zones]


def _zone(zone: ReportedZone, quantities: Quantities) -> Text:
    some, every = zone.reading(SOME), zone.reading(EVERY)
    quiet = "without any impact" if zone.kind == "impact-free" else "without impacts on the back side"
    what = "Speed: " if zone.parameter == "omega" else "Backlash: "
    if not some.found:
        return Text.of(
            Strong(what),
            f"no interval {quiet} was found at {fixed_words(zone.fixed)}. ",
            verdict(zone.verdict),
        )
    parts: list[Inline] = [Strong(what), f"at {fixed_words(zone.fixed)} the pair can run {quiet} from "]
    parts += _between(zone, some, quantities)
    if some.coexisting:
        others = joined(sorted({short(c.label) for c in some.coexisting}))
        parts.append(
            f". Inside it other motions with impacts exist as well ({others}), and the start decides"
        )
    if every.found:
        parts += [". Every motion found is quiet from ", *_between(zone, every, quantities)]
    parts += [". Compared with the article: ", verdict(zone.verdict)]
    if zone.nearest:
        parts += [f", as the {zone.reading(zone.nearest).name} shows it"]
    parts += [" (", Ref(f"table-zone-{zone.parameter}"), ")."]
    return Text(tuple(parts))


def _between(zone: ReportedZone, reading: Reading, quantities: Quantities) -> list[Inline]:
    low, high = reading.lower.value, reading.upper.value
    words = f"{symbol(zone.parameter)} = {number(low, 5)} to {number(high, 5)}"
    physical = quantities.physical(zone.parameter, low, high)
    return [words] if physical is None else [words + ", that is ", physical]


def _verdicts(done: Reproduction) -> Text:
    found = counts(done)
    special = sum(bool(c.needs) for c in done.claims if c.verdict == REPRODUCED)
    fitted = sum(c.fitted for c in done.claims)
    remarks = ""
    if special:
        remarks += f" {special} of those reproduced need a certain way of scanning, which is named there."
    if fitted:
        remarks += (
            f" The values of {fitted} of them test nothing: open values of this case were chosen to meet "
            "them. Their labels were not."
        )
    return Text.of(
        f"Of {plural(len(done.claims), 'claim')} of the article ",
        f"{found[REPRODUCED]} are ",
        Badge(REPRODUCED, "good"),
        f", {found[SHIFTED]} are ",
        Badge(SHIFTED, "fair"),
        " (right motions, value within 10 %), and ",
        f"{found[NOT_FOUND]} were ",
        Badge(NOT_FOUND, "bad"),
        " with the values used here (",
        Ref("table-claims"),
        ").",
        remarks,
    )


def _missed(done: Reproduction) -> list[Text | Bullets]:
    missed = [c for c in done.claims if c.verdict == NOT_FOUND]
    if not missed:
        return []
    items = tuple(
        Text.of(
            Strong(f"{c.quantity}, {c.where}: " if c.where else f"{c.quantity}: "),
            f"the article has {c.printed}. ",
            c.note,
        )
        for c in missed
    )
    return [Text.of("What does not reproduce:"), Bullets(items)]


def _real(found: Verified) -> Text:
    """The article's own check of its model, repeated."""
    return Text.of(
        "The article checks its model by a multibody simulation at two speeds: teeth part once a mesh cycle "
        "at the lower one and never at the higher one. Repeated here with other means, "
        f"{conclusion.in_short(found)} (",
        Ref("table-verified"),
        ").",
    )


def _basis(done: Reproduction) -> Text:
    values = done.case.values()
    inferred = sum(v.provenance == "inferred" for v in values)
    assumed = sum(v.provenance == "assumed" for v in values)
    marks = Quantities.of(done.case).units.assumed
    dagger = " Physical numbers that rest on an assumed value are marked †." if marks else ""
    return Text.of(
        f"The article does not state everything that a computation needs: {plural(inferred, 'value')} had "
        f"to be inferred from what it does state, and {plural(assumed, 'value')} assumed (",
        Ref("table-open"),
        f").{dagger} What does not reproduce may therefore lie in these values as well as in the article.",
    )
