"""The whole report as blocks, and the figures it needs."""

from __future__ import annotations

from gearlash.article import Reproduction
from gearlash.article.verified import Verified
from gearlash.article.verified import verified as kept_of
from gearlash.report.blocks import Page
from gearlash.report.pictures import Picture

from . import branches, claims, events, method, rules, sources, summary, sweeps, table2, verified, zones


def document(
    done: Reproduction, real: Verified | None = None, checked: str = ""
) -> tuple[Page, list[Picture]]:
    """Summary, claims, zones, sweeps, branches, events, rules, real teeth, Table 2, assumptions, method."""
    swept, drawn_sweeps = sweeps.section(done)
    zoned, drawn_zones = zones.section(done)
    shown, drawn_events = events.section(done)
    compared = rules.section(done)
    followed, drawn_branches = branches.section(done)
    shown_real = kept_of(done.case) if real is None else real
    teeth = verified.section(done, shown_real, checked)
    parts = (
        summary.section(done, shown_real),
        claims.section(done),
        zoned,
        swept,
        *([followed] if done.scans else []),
        shown,
        *([compared] if compared is not None else []),
        *([teeth[0]] if teeth is not None else []),
        table2.section(done),
        sources.section(done),
        method.section(done),
    )
    source = str(done.case.source.get("title", "")) or done.case.name
    version = done.run.versions.get("gearlash_version", "")
    page = Page(
        "A helical gear pair with backlash: the article’s study, computed",
        f"Compared with: {source}",
        parts,
        f"Made by gearlash {version}. Figures lie beside this file as SVG and PDF, all numbers as "
        "report.json.",
    )
    drawn_real = [] if teeth is None else teeth[1]
    return page, [*drawn_zones, *drawn_sweeps, *drawn_branches, *drawn_events, *drawn_real]
