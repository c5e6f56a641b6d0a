"""Speed–torque and speed–backlash maps with the present point."""

from __future__ import annotations

import numpy as np
import xarray as xr

from gearlash import plots
from gearlash.report.blocks import Block, Figure, Section, Text
from gearlash.report.pictures import Picture

from .contents import Contents

HEIGHT = 60.0
"""Of a map, mm: two of them fit a page."""
WORDS = {"load": "torque", "D": "backlash"}


def section(contents: Contents) -> tuple[Section, list[Picture]]:
    """A figure for every map there is."""
    found, blocks, pictures = contents.found, [_intro()], []
    for name, dataset in contents.maps.items():
        stem, words = f"map-{WORDS[name]}", f"speed and {WORDS[name]}"
        present = found.here, found.values[name]
        units = plots.Units.of(found.case)
        look = {
            "present": present,
            "along": [_given(contents, units, each) for each in ("omega", name)],
            "height": HEIGHT,
            "physical": True,
            "bands": [(band.lower.value, band.upper.value) for band in found.separating],
            "title": f"{found.case.name}: {words}, {_fixed(contents, name)}",
        }
        pictures.append(Picture(stem, plots.plane, (dataset, units), look))
        caption = f"Motions over {words}, each from the cold start; the star is the present point. "
        caption += _pixel(contents, dataset, name)
        if found.separating:
            caption += (
                " The bars beside the star are the bands of the first lines, in which teeth of a motion that "
                "was found separate: their ends do not depend on pixels."
            )
        blocks.append(Figure(f"figure-{stem}", Text.of(caption), caption, stem))
    return Section("maps", "Maps", tuple(blocks)), pictures


def _given(contents: Contents, units: plots.Units, name: str) -> plots.Twin | None:
    """The unit of a parameter that the case states in one: its scale stands alone."""
    stated = {value.path for value in contents.found.case.values() if value.provenance != "derived"}
    return None if f"dimensionless.{name}" in stated else units.of_parameter(name)


def _pixel(contents: Contents, dataset: xr.Dataset, name: str) -> str:
    """How wide and high pixels are: what is narrower need not be seen."""
    units = contents.units
    steps = [float(np.diff(dataset[each].values).max()) for each in ("omega", name)]
    if name == "load":
        other = units.torque.text(steps[1], 3)
    else:
        other = units.length.text(steps[1] * (1.0 + contents.found.values["back_gap"]), 3)
    plain = "" if units.speed.name else " of the axes"
    return (
        f"A pixel is {units.speed.text(steps[0], 3)} wide and {other} high{plain}: what is narrower may lie "
        "between pixels unseen."
    )


def _intro() -> Block:
    return Text.of(
        "P-Q: in P mesh cycles the drive side is hit Q times; P-Q-R: and the back side R times. Every "
        "pixel is one motion, from the cold start: what coexists with it, and what lies between pixels, is "
        "not seen here."
    )


def _fixed(contents: Contents, name: str) -> str:
    """What the other of the two is."""
    units, values = contents.units, contents.found.values
    if name == "load":
        gap = units.length.text(values["D"] * (1.0 + values["back_gap"]))
        return f"backlash {gap}" if units.length.name else f"D = {values['D']:.4g}"
    return (
        f"torque {units.torque.text(values['load'])}" if units.torque.name else f"load = {values['load']:.4g}"
    )
