"""The tables of every command, by the names of their files; the main one first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from .tables import table_of

if TYPE_CHECKING:
    import xarray as xr

    from gearlash.branches.curves import Curve
    from gearlash.case import Case
    from gearlash.orbits import Attractor
    from gearlash.results import PlaneMap, Sweep
    from gearlash.results.atlas import Atlas
    from gearlash.results.columns import Column
    from gearlash.studies import Zones

    from .answers.asked import Asked
    from .answers.atlas import AtlasAnswer
    from .answers.branch_parts import LimitsUsed
    from .answers.compare import CompareAnswer
    from .answers.curve import CurveAnswer
    from .answers.run import RunAnswer
    from .answers.sweep import AxisUsed, SweepAnswer
    from .answers.tolerance import ToleranceAnswer
    from .answers.zones import ZonesAnswer

Made = dict[str, "Sequence[Column]"]


def series_tables(case: Case, values: Mapping[str, float], found: Attractor) -> Made:
    """Samples of a motion, and its order spectrum."""
    from gearlash.orbits import Orbit
    from gearlash.studies.series import series_of, spectrum_of

    series = series_of(case, values, found)
    return {"history": series, "spectrum": spectrum_of(series, isinstance(found, Orbit))}


def run_tables(case: Case, values: Mapping[str, float], found: Attractor, answer: RunAnswer) -> Made:
    """Samples, spectrum and contact events; nothing of a motion that ran away."""
    if answer.numbers is None:
        return {}
    from .answers.motion import ContactEvent
    from .answers.physical import PhysicalEvent

    events = table_of(answer.numbers.events, ContactEvent)
    if answer.physical is not None:
        physical = table_of(answer.physical.events, PhysicalEvent)
        events = [*(_in_unit(column) for column in physical), *events]
    return {**series_tables(case, values, found), "events": events}


def _in_unit(column: Column) -> Column:
    """With the unit that stands in its name: ``time_ms``."""
    from gearlash.results.columns import Column

    name, _, unit = column.name.partition("_")
    return Column(name, column.values, unit.replace("mm_s", "mm/s"), column.description)


def sweep_tables(case: Case, found: Sequence[Sweep], answer: SweepAnswer) -> Made:
    """A row for every point of every direction, and one for every stretch of one label."""
    from gearlash.results.columns import Column

    from .answers.sweep import Regime
    from .asked_columns import told_as_asked
    from .measured_columns import measured_columns

    regimes = [(way.direction, each) for way in answer.sweeps for each in way.regimes]
    stretches = table_of([each for _, each in regimes], Regime)
    return {
        "sweep": [*_points(case, found, answer.axis), *measured_columns(case, found)],
        "regimes": [
            Column("direction", [way for way, _ in regimes]),
            *told_as_asked(stretches, answer.axis.asked, ("first", "last")),
        ],
    }


def _points(case: Case, found: Sequence[Sweep], axis: AxisUsed) -> list[Column]:
    """A row a point of every direction."""
    from gearlash.results import sweep_dataset
    from gearlash.results.columns import table_of_dataset

    from .asked_columns import axes_first

    return axes_first(table_of_dataset(sweep_dataset(case, found)), case, [(axis.name, axis.asked)])


def map_tables(case: Case, found: PlaneMap, axes: Sequence[AxisUsed]) -> Made:
    """A row a pixel; ``axes`` are x and y."""
    from gearlash.results import plane_dataset
    from gearlash.results.columns import table_of_dataset

    from .asked_columns import axes_first

    asked = [(axis.name, axis.asked) for axis in axes]
    return {"map": axes_first(table_of_dataset(plane_dataset(case, found)), case, asked)}


def zones_tables(case: Case, found: Sequence[Zones], answer: ZonesAnswer) -> Made:
    """A row a zone, one for every motion in it, and the sweeps behind."""
    from gearlash.results.columns import Column

    from .answers.zones_parts import Resident, ZoneFound
    from .asked_columns import told_as_asked

    living = [(i, each) for i, zone in enumerate(answer.zones, 1) for each in zone.residents]
    motions = table_of([each for _, each in living], Resident)
    kept = ("", "stable_", "exists_", "assured_")
    ends = [f"{what}{end}" for what in kept for end in ("lower", "upper")]
    values = ("lower_value", "upper_value")
    return {
        "zones": told_as_asked(table_of(answer.zones, ZoneFound), answer.asked, values),
        "residents": [
            Column("zone", [i for i, _ in living]),
            *told_as_asked(motions, answer.asked, ends),
        ],
        "sweep": _points(case, found[0].sweeps, answer.axis),
    }


def branch_tables(case: Case, datasets: Sequence[xr.Dataset], axis: LimitsUsed) -> Made:
    """A row an orbit of every branch, and all special points with the number of the branch and their own, as
    in the answer."""
    from gearlash.results.columns import table_of_dataset

    from .asked_columns import axes_first

    asked = [(axis.name, axis.asked)]
    found: Made = {
        f"branch-{i}": axes_first(table_of_dataset(each), case, asked) for i, each in enumerate(datasets, 1)
    }
    found["special"] = _special(datasets, axis.asked)
    return found


def _special(datasets: Sequence[xr.Dataset], asked: Asked) -> list[Column]:
    import pandas as pd

    from gearlash.results.columns import columns_of

    from .asked_columns import told_as_asked

    frames, about = [], {}
    for i, dataset in enumerate(datasets, 1):
        names = [name for name, each in dataset.data_vars.items() if each.dims == ("special",)]
        frame = dataset[names].to_dataframe().rename(columns=lambda name: name.removeprefix("special_"))
        about |= {str(name).removeprefix("special_"): dataset[name].attrs for name in names}
        frame.insert(0, "branch", i)
        frame.insert(1, "number", range(1, len(frame) + 1))
        frames.append(frame)
    if not frames:
        return []
    whole = pd.concat(frames)
    found: list[Column] = []
    for name in map(str, whole.columns):
        found += columns_of(name, whole[name].to_numpy(), about.get(name, {}))
    return told_as_asked(found, asked, ("value",))


def curve_tables(case: Case, curves: Sequence[Curve], answer: CurveAnswer) -> Made:
    """A row an orbit of every curve, and all points at which two things happen at once."""
    from gearlash.results.columns import Column, table_of_dataset
    from gearlash.results.curve_dataset import curve_dataset

    from .asked_columns import axes_first

    one, two = answer.axes
    asked = [(axis.name, axis.asked) for axis in (one, two)]
    found: Made = {
        f"curve-{i}": axes_first(table_of_dataset(curve_dataset(case, each)), case, asked)
        for i, each in enumerate(curves, 1)
    }
    points = [(curve.number, point) for curve in answer.curves for point in curve.special]
    numbers = [
        Column("curve", [number for number, _ in points]),
        Column("number", [point.number for _, point in points]),
        Column("kind", [point.kind for _, point in points]),
    ]
    for k, axis in enumerate((one, two)):
        numbers.append(Column(axis.name, [point.values[k] for _, point in points]))
        numbers.append(Column(f"{axis.name}_error", [point.errors[k] for _, point in points]))
    for k in range(2):
        each = [list(point.physical[k]) for _, point in points]
        for j in range(max(map(len, each), default=0)):
            first = next(row[j] for row in each if len(row) > j)
            numbers.append(
                Column(first.name, [row[j].value if len(row) > j else None for row in each], first.unit)
            )
    said = ("label_before", "label_after", "solved", "admissible", "status", "note")
    numbers += [Column(name, [_told(getattr(point, name)) for _, point in points]) for name in said]
    return {**found, "special": axes_first(numbers, case, asked)}


def _told(value: object) -> object:
    return value if value is None or isinstance(value, bool) else str(value)


def atlas_tables(case: Case, found: Atlas, answer: AtlasAnswer) -> Made:
    """A row an orbit of every curve, the points at which two things happen at once, and the map behind."""
    from gearlash.results.columns import Column

    from .answers.atlas import PointFound
    from .asked_columns import told_as_asked

    rows = [
        (number.number, str(number.kind), point)
        for number, each in zip(answer.curves, found.curves, strict=True)
        for point in each.curve.points
    ]
    curves = [
        Column("curve", [number for number, _, _ in rows]),
        Column("kind", [kind for _, kind, _ in rows]),
    ]
    axes, points = (answer.x, answer.y), table_of(answer.points, PointFound)
    for k, axis in enumerate(axes):
        own = [Column(axis.name, [point.values[k] for _, _, point in rows])]
        curves += told_as_asked(own, axis.asked, (axis.name,), axis.asked.name)
        points = told_as_asked(points, axis.asked, (f"values_{k + 1}",), axis.asked.name)
    return {"curves": curves, "points": points, **map_tables(case, found.plane, axes)}


def tolerance_tables(answer: ToleranceAnswer) -> Made:
    """The probability along the axis, the bands, and every input with its influence."""
    from gearlash.results.columns import Column

    from .answers.tolerance import BandFound, InputFound

    kinds = {"always": answer.always, "never": answer.never, "case as it is": answer.nominal}
    bands = [(kind, each) for kind, some in kinds.items() for each in some]
    return {
        "tolerance": [
            Column(answer.axis, answer.values, answer.unit),
            Column("probability", answer.probability),
            Column("standard_error", answer.probability_error),
        ],
        "profile": _profile(answer),
        "bands": [
            Column("band", [kind for kind, _ in bands]),
            *(
                Column(each.name, each.values, answer.unit)
                for each in table_of([each for _, each in bands], BandFound)
            ),
        ],
        "inputs": table_of(answer.inputs, InputFound),
    }


def _profile(answer: ToleranceAnswer) -> list[Column]:
    """The probability in pieces, from one value of the axis to the next."""
    from gearlash.results.columns import Column

    from .answers.tolerance import ProfileFound

    found = answer.profile or ProfileFound((), (), ())
    return [
        Column(f"{answer.axis}_from", found.edges[:-1], answer.unit),
        Column(f"{answer.axis}_to", found.edges[1:], answer.unit),
        Column("probability", found.probability),
        Column("standard_error", found.error),
    ]


def compare_tables(answer: CompareAnswer) -> Made:
    """A row a measured speed, and the measured jumps with the events beside them."""
    from gearlash.results.columns import Column

    points, unit = answer.points, answer.unit
    events = [(i, jump, event) for i, jump in enumerate(answer.jumps, 1) for event in jump.events or (None,)]
    told = [event for _, _, event in events if event is not None]
    return {
        "compare": [
            Column("speed" if answer.speed_unit else "omega", [p.speed for p in points], answer.speed_unit),
            Column("measured", [p.measured for p in points], unit),
            Column("rising", [p.up for p in points], unit),
            Column("falling", [p.down for p in points], unit),
            Column("residual", [p.residual for p in points], unit),
            Column("direction", [p.direction for p in points]),
            Column("residual_nearer", [p.residual_nearer for p in points], unit),
            Column("motion_rising", [p.label_up for p in points]),
            Column("motion_falling", [p.label_down for p in points]),
        ],
        "jumps": [
            Column("jump", [i for i, _, _ in events]),
            Column("lower", [jump.lower for _, jump, _ in events], answer.speed_unit),
            Column("upper", [jump.upper for _, jump, _ in events], answer.speed_unit),
            Column("change", [jump.change for _, jump, _ in events], unit),
            Column("direction", [jump.direction for _, jump, _ in events]),
            *[
                Column(f"event_{name}", [getattr(event, name, None) for _, _, event in events])
                for name in (("kind", "direction", "lower", "upper", "below", "above") if told else ())
            ],
        ],
    }
