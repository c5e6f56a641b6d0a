"""What is measured over speed: two figures, resonances, and what they say."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gearlash.case import Case
from gearlash.case.rating import band_of_grades, values_of_grades
from gearlash.gears import YAxis
from gearlash.plots.marks import Mark
from gearlash.plots.over_speed import Curve, SpeedAxis, Stack, over_speed
from gearlash.report.blocks import Block, Cell, Figure, Section, Table, Text
from gearlash.report.numbers import number
from gearlash.report.pictures import Picture
from gearlash.results.pair_units import PairUnits, Unit
from gearlash.studies.bands import Band
from gearlash.studies.speed_run import SpeedRun
from gearlash.studies.zone_end import Interval

from .contents import Contents
from .noise import loudest
from .orders import LEAST, exciting, meetings, natural_frequencies
from .words import Words


def section(contents: Contents, title: str) -> tuple[Section, list[Picture]]:
    """Curves over speed, with their sentences; ``title`` names case, torque and backlash."""
    run, units, found = contents.run, contents.units, contents.found
    assert run is not None
    words = Words(units, found.here)
    axis = _axis(contents, run)
    pictures = [
        Picture("speed-forces", over_speed, (axis, _forces(run, units)), {"title": title}),
        Picture("speed-errors", over_speed, (axis, _errors(run, units)), {"title": title}),
    ]
    errors = f"{_ERROR_WORDS}{_HIT_WORDS if _parting(run) else _NEVER_APART}"
    step = units.speed.factor * float(np.diff(run.axis.values).max())
    unit = f" {units.speed.name}" if units.speed.name else " in omega"
    how = (
        f"Each point is a motion followed from its neighbour, {step:.3g}{unit} apart, upwards and downwards; "
        "peaks, means and rms are those of its exact pieces (peaks to 1e-8 of their span), for motion that "
        "is not periodic of 200 mesh cycles. Ends of bands were solved for, and do not depend on this step."
    )
    blocks = [*_factor(contents), *_bearing_table(run, units, words, found.case)]
    forces = "Mesh force and bearing forces" if _bearings(run) else "Mesh force"
    blocks += [
        _figure("speed-forces", f"{forces}{_FORCE_WORDS}{_MEETING_WORDS if axis.resonances else ''}"),
        _figure("speed-errors", errors),
        Text.of(how),
    ]
    blocks += _resonance_table(found.case, units)
    return Section("speed", "Over speed", tuple(blocks)), pictures


_FORCE_WORDS = (
    " over speed: peak over one period. On the right the dynamic factor K_v: mesh force over the static one."
)
_MEETING_WORDS = (
    " Dotted: a mesh order meets a natural frequency of the closed mesh; f1/2: order 2 meets f1 of the table "
    "below (orders above 3 only where teeth separate)."
)
_ERROR_WORDS = (
    "Dynamic transmission error DTE: rotation of both gears along the line of action, to which bearings that "
    "give way and unloaded errors add"
)
_HIT_WORDS = "; share of time without contact; and the highest velocity at which teeth meet again."
_NEVER_APART = (
    ". In no motion of these sweeps do teeth part: no time without contact and no impact is to be shown."
)


def _figure(stem: str, caption: str) -> Figure:
    return Figure(f"figure-{stem}", Text.of(caption), caption, stem)


def _axis(contents: Contents, run: SpeedRun) -> SpeedAxis:
    unit, found = contents.units.speed, contents.found
    return SpeedAxis(
        values=unit.factor * run.axis.values,
        label=_label("pinion speed" if unit.name == "rpm" else "mesh frequency", unit),
        apart=run.apart,
        separating=_spans(tuple(band for band in found.separating if band.every), unit),
        back=_spans(found.back_side, unit),
        present=unit.factor * found.here,
        resonances=resonances(contents, run),
        beside=_spans(tuple(band for band in found.separating if not band.every), unit),
        not_told=_spans(found.not_told, unit),
    )


def _label(words: str, unit: Unit) -> str:
    return f"{words}  [{unit.name}]" if unit.name else rf"{words}  $\omega$"


def _spans(bands: Sequence[Band | Interval], unit: Unit) -> tuple[tuple[float, float], ...]:
    return tuple((unit.factor * band.lower.value, unit.factor * band.upper.value) for band in bands)


def resonances(contents: Contents, run: SpeedRun) -> tuple[Mark, ...]:
    """Speeds at which an order of the mesh frequency meets a natural frequency; orders beyond the first ones
    only where teeth separate, so that the picture stays clear."""
    found, factor = contents.found, contents.units.speed.factor
    low, high = (float(run.axis.values[i]) for i in (0, -1))
    return tuple(
        Mark(factor * one.omega, "resonance", one.text, one.order == 1)
        for one in meetings(found.case, low, high)
        if one.order <= LEAST or any(band.contains(one.omega) for band in found.separating)
    )


def _forces(run: SpeedRun, units: PairUnits) -> list[Stack]:
    values = run.case.family()[0].complete()
    static = units.force.factor * values["load"] / values["rotation_factor"]
    mesh = [("peak", "force.most"), ("mean", "force.mean"), ("rms about the mean", "force.rms")]
    stacks = [
        Stack(
            _unit_label("mesh force", units.force),
            _curves(run, mesh, units.force),
            (static, "$K_v$ of the peak"),
        )
    ]
    bearings = _bearings(run)
    if bearings:
        stacks.append(
            Stack(_unit_label("bearing force, peak", units.force), _curves(run, bearings, units.force))
        )
    return stacks


def _bearings(run: SpeedRun) -> list[tuple[str, str]]:
    """Forces of bearings, in words and as a column."""
    forces = [one for one in run.readouts if one.quantity == "force"]
    return [(one.words.removeprefix("bearing force, "), f"{one.name}.peak") for one in forces]


def _errors(run: SpeedRun, units: PairUnits) -> list[Stack]:
    error = [("peak to peak", "transmission_error.peak_to_peak"), ("rms", "transmission_error.rms")]
    stacks = [Stack(_unit_label("DTE", units.length), _curves(run, error, units.length))]
    if not _parting(run):
        return stacks
    share = Unit(100.0, "%", "percent")
    velocity = [("drive side", "impact_velocity")]
    if np.nanmax([one.back_velocity for _, one in run.measured()], initial=0.0) > 0.0:
        velocity.append(("back side", "back_velocity"))
    return [
        *stacks,
        Stack("no contact  [%]", _curves(run, [("share of time", "share_without_contact")], share)),
        Stack(_unit_label("impact", units.velocity), _curves(run, velocity, units.velocity)),
    ]


def _parting(run: SpeedRun) -> bool:
    """Whether teeth part in any of its motions, or meet again."""
    figures = ("share_without_contact", "impact_velocity", "back_velocity")
    return any(getattr(one, name) > 0.0 for _, one in run.measured() for name in figures)


def _unit_label(words: str, unit: Unit) -> str:
    return f"{words}  [{unit.name}]" if unit.name else words


def _curves(run: SpeedRun, wanted: list[tuple[str, str]], unit: Unit) -> tuple[Curve, ...]:
    return tuple(
        Curve(words, *(unit.factor * run.column(way, name) for way in (0, 1))) for words, name in wanted
    )


def _bearing_table(run: SpeedRun, units: PairUnits, words: Words, case: Case) -> list[Block]:
    rows: list[tuple[Cell, ...]] = []
    for one in loudest(run):
        cells = [
            f"{units.force.text(each[0])} at {words.speed(each[1])}" if each else "no such motion found"
            for each in (one.quiet, one.hitting)
        ]
        rows.append((one.words, *cells))
    if not rows:
        text = "This model has no bearings: shafts do not move sideways, and carry the mesh force itself."
        return [Text.of(text)]
    head = ("", "largest where teeth stay in contact", "largest where they separate")
    caption = f"Peaks of bearing forces over these speeds.{_lateral(case)}"
    return [Table("table-bearings", caption, head, tuple(rows))]


def _lateral(case: Case) -> str:
    """Which part of the force across a shaft the lateral bearing force is."""
    axis = next((str(value.value) for value in case.values() if value.path == "model.y_axis"), None)
    if axis is None:  # numbers of a model alone: their factors say nothing of directions on a drawing
        return ""
    if axis == YAxis.LINE_OF_ACTION:
        return " Lateral ones are along the line of action: all of the force across a shaft."
    return (
        " Lateral ones are along the tangent of the pitch circles: what pushes the shafts apart is not in "
        "them (model.y_axis)."
    )


def _resonance_table(case: Case, units: PairUnits) -> list[Block]:
    hertz = float(case.scales.mesh_hz(1.0)) if case.scales.physical else None
    orders = sorted({*range(1, LEAST + 1), *exciting(case)})
    rows = []
    for i, frequency in enumerate(natural_frequencies(case), start=1):
        cells = [number(units.speed.factor * frequency / order, 5) for order in orders]
        rows.append((f"f{i}", "" if hertz is None else number(hertz * frequency, 5), *cells))
    unit = units.speed.name or "omega"
    head = ("", "Hz" if hertz else "", f"order 1 [{unit}]", *(f"order {order}" for order in orders[1:]))
    caption = (
        "Natural frequencies with closed mesh (undamped, mean stiffness), and speeds at which mesh "
        "orders meet them: the first three, and those that stiffness or error excite."
    )
    columns = frozenset(range(1, 2 + len(orders)))
    return [Table("table-resonances", caption, head, tuple(rows), columns)]


def _factor(contents: Contents) -> list[Block]:
    """The computed dynamic factor beside that of the standard, at the present speed."""
    found = contents.found
    if found.signals is None:
        return []
    static = found.values["load"] / found.values["rotation_factor"]
    own = found.signals.force.most / static
    text = (
        f"At the present speed the computed dynamic factor is {own:.3f}: the highest mesh force over "
        "the static one."
    )
    iso = band_of_grades(found.case, found.here)
    return [Text.of(f"{text} {iso}{_factor_elsewhere(contents, static)}")]


def _factor_elsewhere(contents: Contents, static: float) -> str:
    """Both factors at the greatest speed and at the one with the highest mesh force."""
    found, run = contents.found, contents.run
    rows = run.measured() if run is not None else []
    if not rows:
        return ""
    words = Words(contents.units, found.here)
    fastest, hardest = max(rows, key=lambda row: row[0].value), max(rows, key=lambda row: row[1].force.most)
    said = []
    for what, (point, one) in (("the greatest speed examined", fastest), ("the highest mesh force", hardest)):
        standard = values_of_grades(found.case, point.value)
        beside = f", by the standard {standard}" if standard else ""
        said.append(f"at {what} ({words.speed(point.value)}) {one.force.most / static:.3g}{beside}")
    return f" {said[0][0].upper()}{said[0][1:]}; {said[1]}."
