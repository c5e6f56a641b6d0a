"""Histories, phase portraits and order spectra at the present speed and of the hardest motion."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from gearlash import plots
from gearlash.plots.measured import Column, Strip, measured_histories
from gearlash.plots.regimes import short
from gearlash.plots.spectra import FLOOR, HIGHEST, Levels, order_spectra
from gearlash.report.blocks import Block, Cell, Figure, Section, Table, Text
from gearlash.report.pictures import Picture
from gearlash.results.contact_words import damping_in_the_gap
from gearlash.results.pair_units import PairUnits, Unit
from gearlash.studies.history import History, Spectrum, spectrum

from .contents import Contents

SHOWN = 8
"""Mesh cycles of a history that are drawn."""
LEFT_OUT = (
    f"Orders above {HIGHEST:g}, the mean and lines more than {FLOOR:g} dB below the highest of a row are not "
    "drawn."
)
SPECTRA = ("mesh_force", "transmission_error")


def section(contents: Contents) -> tuple[Section, list[Picture]]:
    """The motions as figures, and their numbers as a table."""
    units, shown, case = contents.units, contents.histories, contents.found.case
    titles = [title(contents, one) for one in shown]
    spectra = [spectrum(one) for one in shown]
    time = f"time  [{units.time.name}]" if units.time.name else r"time  $\tau$"
    columns = [_column(one, units, words) for one, words in zip(shown, titles, strict=True)]
    motions = [one.motion for one in shown]
    look = {"titles": titles, "physical": True}
    pictures = [
        Picture("histories", measured_histories, (columns, time)),
        Picture("portraits", plots.gallery, (motions, plots.Units.of(case)), look),
        Picture("spectra", order_spectra, (_levels(shown, spectra, units), titles)),
    ]
    grey = "; grey: no contact" if any(column.free.any() for column in columns) else ""
    which = "at the present speed and of the hardest motion over speed (highest mesh force)"
    which = which if len(shown) > 1 else "at the present speed, which has the highest mesh force found"
    blocks: list[Block] = [
        _table(contents),
        *_damping(contents),
        _figure("histories", f"Histories {which}{grey}. At most {SHOWN} mesh cycles are drawn."),
        _figure(
            "portraits",
            f"Phase portraits {which}: relative displacement of the flanks and its velocity. Σ_1, Σ_2: where "
            "drive side and back side begin to touch, as far as the picture reaches.",
        ),
        _figure("spectra", f"Order spectra {which}. {_window(spectra)}{_reference(units)} {LEFT_OUT}"),
    ]
    return Section("motions", "Motions", tuple(blocks)), pictures


def title(contents: Contents, one: History) -> str:
    """``drive, 4200 rpm, 150 N·m: 1-0``."""
    units, found = contents.units, contents.found
    load = found.values["load"]
    torque = units.torque.text(load, 4) if units.torque.name else f"load = {load:.4g}"
    return f"{found.case.name}, {_speed(units, one)}, {torque}:  {short(one.label)}"


def _speed(units: PairUnits, one: History) -> str:
    return units.speed.text(one.omega, 5) if units.speed.name else f"omega = {one.omega:.5g}"


def _figure(stem: str, caption: str) -> Figure:
    return Figure(f"figure-{stem}", Text.of(caption), caption, stem)


def _window(spectra: list[Spectrum]) -> str:
    if all(not one.window for one in spectra):
        return "Lines are those of the Fourier series of one period, rms of each. "
    return (
        "Lines of periodic motion are those of the Fourier series of one period, rms of each; of other "
        "motion 64 mesh cycles under a Hann window. "
    )


def _reference(units: PairUnits) -> str:
    if not units.force.name:
        return "Levels in dB are those of rms values and refer to 1, as this case has no units."
    return "Levels are those of rms values and refer to 1 µN and 1 pm (ISO 1683)."


def level(rms: np.ndarray, unit: Unit) -> np.ndarray:
    """In dB over the reference of a unit; -inf where there is nothing."""
    with np.errstate(divide="ignore"):
        return 20.0 * np.log10(unit.factor * rms / unit.reference)


def unit_of(units: PairUnits, quantity: str) -> Unit:
    """Of a readout's quantity."""
    return units.force if quantity == "force" else units.length


def _levels(shown: tuple[History, ...], spectra: list[Spectrum], units: PairUnits) -> list[list[Levels]]:
    names = [one.name for one in shown[0].what]
    wanted = [*SPECTRA, *(name for name in names if name.startswith("bearing_force_"))]
    if len(wanted) > 4:  # of the bearings the two with the strongest lines
        strength = {name: spectra[0].rms[names.index(name), 1:].max() for name in wanted[2:]}
        wanted = [*SPECTRA, *sorted(wanted[2:], key=lambda name: -strength[name])[:2]]
    rows = []
    for name in wanted:
        i = names.index(name)
        what = shown[0].what[i]
        unit = unit_of(units, what.quantity)
        label = f"dB re {unit.reference_name}"
        rows.append([Levels(what.words, label, s.order, level(s.rms[i], unit)) for s in spectra])
    return rows


def _column(one: History, units: PairUnits, words: str) -> Column:
    last = min(len(one.phase), SHOWN * len(one.phase) // one.cycles)
    time = units.time.factor * 2.0 * np.pi * one.phase[:last] / one.omega
    free = one.motion
    outside = np.interp(one.phase[:last], free.phase, (free.region == 1).astype(float)) > 0.5
    values = {
        what.name: unit_of(units, what.quantity).factor * row[:last]
        for what, row in zip(one.what, one.values, strict=True)
    }
    bearings = tuple(
        (what.words.removeprefix("bearing force, "), values[what.name])
        for what in one.what
        if what.name.startswith("bearing_force_")
    )
    error = values["transmission_error"]
    strips = [
        Strip(_label("mesh force", units.force), (("mesh force", values["mesh_force"]),)),
        *([Strip(_label("bearing force", units.force), bearings)] if bearings else []),
        Strip(_label("DTE", units.length), (("about its mean", error - error.mean()),)),
    ]
    return Column(words, time, outside, tuple(strips))


def _label(words: str, unit: Unit) -> str:
    return f"{words}  [{unit.name}]" if unit.name else words


def _table(contents: Contents) -> Table:
    """The exact figures of each motion."""
    units, shown = contents.units, contents.histories
    rows: list[tuple[Cell, ...]] = []

    def row(words: str, read: Callable[[History], float], unit: Unit) -> None:
        rows.append((words, *(unit.text(read(one)) for one in shown)))

    values = contents.found.values
    static = values["load"] / values["rotation_factor"]
    row("mesh force, largest", lambda one: one.signals.force.most, units.force)
    row("mesh force, least", lambda one: one.signals.force.least, units.force)
    row("mesh force, rms about the mean", lambda one: one.signals.force.rms, units.force)
    row("dynamic factor K_v, largest over static", lambda one: one.signals.force.most / static, _NUMBER)
    for i, what in enumerate(shown[0].what[2:]):
        unit = unit_of(units, what.quantity)
        if what.quantity == "force":
            row(f"{what.words}, peak", lambda one, i=i: one.signals.read[i].peak, unit)
            row(f"{what.words}, peak to peak", lambda one, i=i: one.signals.read[i].peak_to_peak, unit)
        else:
            row(f"{what.words}, peak to peak", lambda one, i=i: one.signals.read[i].peak_to_peak, unit)
            row(f"{what.words}, rms", lambda one, i=i: one.signals.read[i].rms, unit)
    row("share of time without contact", lambda one: one.signals.share_without_contact, _PERCENT)
    row("impact velocity, drive side", lambda one: one.signals.impact_velocity, units.velocity)
    row("impact velocity, back side", lambda one: one.signals.back_velocity, units.velocity)
    heads = (f"{_speed(units, one)}: {short(one.label)}" for one in shown)
    numeric, widths = frozenset(range(1, len(shown) + 1)), (40, *[60 // len(shown)] * len(shown))
    return Table(
        "table-motions", "What is measured on these motions.", ("", *heads), tuple(rows), numeric, widths
    )


def _damping(contents: Contents) -> Iterator[Block]:
    """Why the force pulls, or is there without contact."""
    rule = contents.found.case.numbers.contact
    for one in contents.histories:
        signals = one.signals
        said = damping_in_the_gap(
            rule, signals.force.least, signals.force.most, signals.share_without_contact
        )
        if said:
            yield Text.of(said)
            return


_NUMBER, _PERCENT = Unit(1.0, "", ""), Unit(100.0, "%", "percent")
