"""The whole report of a pair as blocks, and the figures it needs."""

from __future__ import annotations

from gearlash.case import Case
from gearlash.report.blocks import Badge, Block, Page, Section, Table
from gearlash.report.pictures import Picture

from . import basis, maps, motions, speed, stated
from .contents import Contents
from .noise import backlash_matters, not_quiet, reversing, unloaded
from .verdict import NO_APPROVAL, Line, place, verdict
from .words import Words

CAPTION = "In short. Found means: by the starts and sweeps that are named at the end."


def document(contents: Contents) -> tuple[Page, list[Picture]]:
    """Verdict, curves over speed, motions, maps, and what it rests on; as far as they are there."""
    found, units = contents.found, contents.units
    values = found.values
    load = -values["load"] if found.turned else values["load"]
    torque = units.torque.text(load) if units.torque.name else f"load = {load:.4g}"
    speed_text = units.speed.text(found.here, 5) if units.speed.name else f"omega = {found.here:.5g}"
    parts, pictures = [_first(contents)], []
    if contents.run is not None and contents.run.measured():
        made, drawn = speed.section(contents, f"{found.case.name}, {torque}, present speed {speed_text}")
        parts.append(made)
        pictures += drawn
    if contents.histories:
        made, drawn = motions.section(contents)
        parts.append(made)
        pictures += drawn
    if contents.maps:
        made, drawn = maps.section(contents)
        parts.append(made)
        pictures += drawn
    for page_part in (stated, basis):
        parts.append(page_part.section(contents))
        pictures += page_part.pictures(contents)
    about = f" {found.case.description}." if found.case.description else ""
    page = Page(
        f"{found.case.name}: {place(found.case, units, found.here, load)}",
        f"What the model of this pair does there and around.{about}{_which(found.case)}",
        tuple(parts),
        f"{NO_APPROVAL} Figures lie beside this file as SVG and PDF, curves, histories and spectra as CSV "
        "and NetCDF, all numbers as report.json.",
        contents_printed=False,
    )
    return page, pictures


def _which(case: Case) -> str:
    """The pair in a line; nothing where the case states none of it."""
    brief = stated.in_brief(case)
    return f" {brief[0].upper()}{brief[1:]}." if brief else ""


def _noise(contents: Contents, words: Words) -> str:
    """What is loud without impacts."""
    run, units = contents.run, contents.units
    assert run is not None
    return " ".join(filter(None, [not_quiet(run, units, words), unloaded(run, units, words)]))


def _first(contents: Contents) -> Section:
    found = contents.found
    said = verdict(found)
    lines = list(said.lines)
    if contents.run is not None:
        words = Words(contents.units, found.here)
        more = (
            ("Noise", _noise(contents, words)),
            ("Bearings", reversing(contents.run, words)),
            ("Backlash", backlash_matters(found, contents.run, contents.units)),
        )
        if contents.maps:
            more = (*more, ("Other torques", maps.other_torques(contents)))
        lines[-1:-1] = [Line(title, text) for title, text in more if text]
    rows = tuple((line.title, line.text) for line in lines)
    blocks: list[Block] = [Table("verdict-lines", CAPTION, ("", ""), rows, widths=(18, 82))]
    return Section("verdict", "May it run there?", tuple(blocks), badge=Badge(said.short, said.kind))
