"""Speed–torque and speed–backlash maps with the present point."""

from __future__ import annotations

from itertools import groupby

import numpy as np
import xarray as xr

from gearlash import plots
from gearlash.plots.regimes import short
from gearlash.report.blocks import Block, Figure, Section, Text
from gearlash.report.pictures import Picture
from gearlash.results import NO_LABEL
from gearlash.results.physical import backlash_words
from gearlash.studies.zone_end import RANGE, UNKNOWN
from gearlash.system import Label, Signature, read_label

from .contents import Contents
from .words import Words

HEIGHT = 60.0
"""Of a map, mm: two of them fit a page."""
WORDS = {"load": "torque", "D": "backlash"}


def section(contents: Contents) -> tuple[Section, list[Picture]]:
    """A figure for every map there is; a sentence for one that has a single motion throughout."""
    found, pictures, blocks = contents.found, [], [_intro()]
    for name, dataset in contents.maps.items():
        only = _only(dataset)
        if only is not None:
            blocks.append(Text.of(_in_words(contents, dataset, name, only)))
            continue
        stem, words = f"map-{WORDS[name]}", f"speed and {WORDS[name]}"
        present = found.here, found.values[name]
        units = plots.Units.of(found.case)
        look = {
            "present": present,
            "along": [_given(contents, units, each) for each in ("omega", name)],
            "height": HEIGHT,
            "physical": True,
            "bands": [(band.lower.value, band.upper.value) for band in found.separating],
            "not_told": [(part.lower.value, part.upper.value) for part in found.not_told],
            "title": f"{found.case.name}: {words}, {_fixed(contents, name)}",
        }
        pictures.append(Picture(stem, plots.plane, (dataset, units), look))
        caption = f"Motions over {words}, each from the cold start; the star is the present point. "
        caption += _pixel(contents, dataset, name)
        caption += _bars(contents)
        blocks.append(Figure(f"figure-{stem}", Text.of(caption), caption, stem))
    return Section("maps", "Maps", tuple(blocks)), pictures


def other_torques(contents: Contents) -> str:
    """Which motions the map over torque has at the speed that is nearest to the present one."""
    units = contents.units
    if "load" not in contents.maps or not units.torque.name:
        return ""
    dataset = contents.maps["load"]
    column = int(np.argmin(np.abs(dataset["omega"].values - contents.found.here)))
    codes = dataset["label"].transpose("load", "omega").values[:, column]
    torques = [units.torque.text(float(each), 3) for each in dataset["load"].values]
    speed = Words(units, contents.found.here).speed(float(dataset["omega"].values[column]), 4)
    looked = f"{len(torques)} torques from {torques[0]} to {torques[-1]}, {speed}, from the cold start"
    told, quiet, at = [], 0, 0
    for code, run in groupby(codes.tolist()):
        count = len(list(run))
        label = None if code == NO_LABEL else read_label(str(dataset["label_name"].values[code]))
        if isinstance(label, Signature) and label.impacts == 0:
            quiet += count
        else:
            reach = torques[at] if count == 1 else f"{torques[at]} to {torques[at + count - 1]}"
            told.append(f"{'nothing settled' if label is None else short(label)} at {reach}")
        at += count
    if not told:
        return f"Teeth stay in contact at all of {looked}."
    rest = "; at the others teeth stay in contact" if quiet else ""
    return f"{looked}: {'; '.join(told)}{rest}."


def _bars(contents: Contents) -> str:
    """What the bars at the height of the star are."""
    found, said = contents.found, ""
    if found.separating:
        said += (
            " The bars beside the star are the bands of the first lines, in which teeth of a motion that "
            "was found separate: their ends do not depend on pixels"
        )
        open_ended = any(
            each.kind in (RANGE, UNKNOWN) for band in found.separating for each in (band.lower, band.upper)
        )
        said += ", but for those at the ends of what was examined." if open_ended else "."
    if found.not_told:
        said += " Dotted bars there: no motion tells whether teeth separate."
    return said


def _given(contents: Contents, units: plots.Units, name: str) -> plots.Twin | None:
    """The unit of a parameter that the case states in one: its scale stands alone."""
    stated = {value.path for value in contents.found.case.values() if value.provenance != "derived"}
    return None if f"dimensionless.{name}" in stated else units.of_parameter(name)


def _pixel(contents: Contents, dataset: xr.Dataset, name: str) -> str:
    """How wide and high pixels are: what is narrower need not be seen."""
    units = contents.units
    steps = [float(np.diff(dataset[each].values).max()) for each in ("omega", name)]
    wide, high = units.speed.text(steps[0], 3), _size(contents, name, steps[1], 3)
    plain = "" if units.speed.name else " of the axes"
    return f"A pixel is {wide} wide and {high} high{plain}: what is narrower may lie between pixels unseen."


def _size(contents: Contents, name: str, value: float, digits: int) -> str:
    """A torque, or a backlash, in the unit of the case."""
    units = contents.units
    if name == "load":
        return units.torque.text(value, digits)
    return units.length.text(value * (1.0 + contents.found.values["back_gap"]), digits)


def _only(dataset: xr.Dataset) -> Label | None:
    """The label of all motions of a map; None where there are several, or some have none."""
    codes = np.unique(dataset["label"].values)
    if len(codes) > 1 or codes[0] == NO_LABEL:
        return None
    return read_label(str(dataset["label_name"].values[codes[0]]))


def _in_words(contents: Contents, dataset: xr.Dataset, name: str, label: Label) -> str:
    """A map that has one motion throughout."""
    low, high = (_size(contents, name, float(dataset[name].values[i]), 4) for i in (0, -1))
    words = Words(contents.units, contents.found.here)
    speeds = words.reach(*(float(dataset["omega"].values[i]) for i in (0, -1)))
    quiet = isinstance(label, Signature) and label.impacts == 0
    counts = dataset.sizes["omega"], dataset.sizes[name]
    return (
        f"Speed and {WORDS[name]}, {_fixed(contents, name)}: at {counts[0]} speeds, {speeds}, and "
        f"{counts[1]} values of {WORDS[name]}, {low} to {high}, the motion is {short(label)}: teeth "
        f"{'stay in contact' if quiet else 'separate'}. There is nothing else to draw."
    )


def _intro() -> Block:
    return Text.of(
        "P-Q: in P mesh cycles the drive side is hit Q times; P-Q-R: and the back side R times. Every "
        "motion is the one from the cold start: what coexists with it, and what lies between the values that "
        "were tried, is not seen here."
    )


def _fixed(contents: Contents, name: str) -> str:
    """What the other of the two is."""
    units, values = contents.units, contents.found.values
    if name == "load":
        gap = units.length.text(values["D"] * (1.0 + values["back_gap"]))
        return (
            f"{backlash_words(contents.found.case)} {gap}" if units.length.name else f"D = {values['D']:.4g}"
        )
    return (
        f"torque {units.torque.text(values['load'])}" if units.torque.name else f"load = {values['load']:.4g}"
    )
