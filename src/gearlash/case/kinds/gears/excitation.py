"""From stated curves and run-out to what excites the mesh."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash.case.scales import Scales
from gearlash.gears.drawing import Drawing
from gearlash.gears.excitation import SHAFTS, Curve, Excitation
from gearlash.gears.waveform import Waveform, unloaded_error_of, waveform
from gearlash.system import Fourier, cosines, evaluate

from .at_torque import mesh_at, relief_error
from .curves import LOADED
from .rules import EntriesByKey

SAMPLES = 360  # of the highest harmonic, where harmonics are made points
ENOUGH = 0.01  # of peak to peak: root mean square of curve less series
MOST_OF_A_CYCLE, MOST_OF_A_TURN = 24, 4  # harmonics of a mesh cycle that are kept where none are stated
Curves = Mapping[str, Mapping[str, Any]]
Reals = NDArray[np.float64]


@dataclass(frozen=True)
class Reconstructed:
    """A stated curve and the series that stands for it.

    Parameters
    ----------
    over : str
        Its period in words.
    cycles : int
        The same in mesh cycles.
    phases, values : ndarray, shape (n,)
        The points, where points are stated, as the model takes them: over the mean, or over D_c. Empty where
        harmonics are stated.
    series : ndarray
        Of the same, [mean, c1, s1, …] over ``cycles``.
    rms_error : float
        Root mean square of curve less series.
    """

    over: str
    cycles: int
    phases: Reals
    values: Reals
    series: Fourier
    rms_error: float

    @property
    def peak_to_peak(self) -> float:
        """Of the points, or of the series where harmonics are stated."""
        values = (
            self.values if len(self.values) else evaluate(self.series, np.linspace(0.0, 2.0 * np.pi, 720))
        )
        return float(np.ptp(values))

    @property
    def harmonics(self) -> int:
        """Of its own period."""
        return (len(self.series) - 1) // 2


def teeth_of(entries: EntriesByKey) -> dict[str, int]:
    """Teeth of the shafts whose gear states them."""
    keys = {shaft: f"{shaft}.teeth" for shaft in SHAFTS}
    return {shaft: int(entries[key].number) for shaft, key in keys.items() if key in entries}


def reconstructed(
    curves: Curves, entries: EntriesByKey, scales: Scales, drawing: Drawing | None = None
) -> dict[str, Reconstructed]:
    """The series of every stated curve; of a loaded error without what stiffness and flanks make of it."""
    found: dict[str, Reconstructed] = {}
    if "stiffness" in curves:
        stated = curves["stiffness"]
        mean = mean_of(stated)
        found["stiffness"] = _reconstructed(
            stated, entries, np.array(stated.get("values", [])) / mean, 1 / mean
        )
    if "error" in curves:
        stated = curves["error"]
        if stated.get("state") == LOADED:
            stated = _as_points(stated)
        values = np.array(stated.get("values", []))
        if stated.get("state") == LOADED:
            values = _unloaded(stated, values, entries, scales, found.get("stiffness"), drawing)
        length = (scales.length or 1.0) if stated["physical"] else 1.0
        found["error"] = _reconstructed(stated, entries, values / length, 1.0 / length)
    return found


def mean_of(stated: Mapping[str, Any]) -> float:
    """The mean of a curve over its period, in SI or as a number."""
    if "amplitudes" in stated:
        return float(stated["mean"])
    return float(waveform(stated["phases"], stated["values"], 0).series[0])


def excitation(
    curves: Curves,
    entries: EntriesByKey,
    scales: Scales,
    runout_factor: float,
    drawing: Drawing | None = None,
) -> Excitation:
    """Curves, run-out and relief of a case."""
    found = reconstructed(curves, entries, scales, drawing)
    made = {name: Curve(each.series, each.cycles) for name, each in found.items()}
    relief = relief_error(drawing, entries)
    relieved = None if relief is None else Curve(relief / (scales.length or 1.0))
    teeth = teeth_of(entries)
    runout = {shaft: teeth[shaft] for shaft in SHAFTS if f"{shaft}_runout" in entries}
    return Excitation(made.get("stiffness"), made.get("error"), runout or None, runout_factor, relieved)


def _reconstructed(
    stated: Mapping[str, Any], entries: EntriesByKey, values: Reals, factor: float
) -> Reconstructed:
    shaft = str(stated["over"]).partition(" ")[0]
    cycles = teeth_of(entries).get(shaft, 1)
    if "amplitudes" in stated:
        own = cosines(factor * stated["mean"], factor * np.array(stated["amplitudes"]), stated["angles"])
        return Reconstructed(stated["over"], cycles, np.zeros(0), np.zeros(0), own, 0.0)
    asked = stated["harmonics"]
    most = MOST_OF_A_CYCLE if cycles == 1 else MOST_OF_A_TURN
    wave = waveform(stated["phases"], values, (asked or most) * cycles)
    count = (len(wave.series) - 1) // 2 if asked else _enough(wave)
    wave = waveform(stated["phases"], values, count)
    phases = np.array(stated["phases"])
    return Reconstructed(stated["over"], cycles, phases, values, wave.series, wave.rms_error)


def _enough(wave: Waveform) -> int:
    """The least number of harmonics whose root mean square error is small; all of them where none is."""
    power = 0.5 * (np.square(wave.series[1::2]) + np.square(wave.series[2::2]))
    left = wave.rms_error**2 + np.append(np.cumsum(power[::-1])[::-1], 0.0)
    small = np.sqrt(left) <= ENOUGH * float(np.ptp(wave.values))
    return int(np.argmax(small)) if small.any() else len(power)


def _as_points(stated: Mapping[str, Any]) -> Mapping[str, Any]:
    """The same curve as points, where it is stated by harmonics: what the stiffness makes has others."""
    if "amplitudes" not in stated:
        return stated
    phases = np.linspace(0.0, 1.0, 1 + SAMPLES * len(stated["amplitudes"]))
    own = cosines(stated["mean"], stated["amplitudes"], stated["angles"])
    values = evaluate(own, 2.0 * np.pi * phases)
    rest = {key: value for key, value in stated.items() if key not in ("amplitudes", "angles", "mean")}
    return {**rest, "phases": phases.tolist(), "values": values.tolist()}


def _unloaded(
    stated: Mapping[str, Any],
    values: Reals,
    entries: EntriesByKey,
    scales: Scales,
    stiffness: Reconstructed | None,
    drawing: Drawing | None,
) -> Reals:
    """The error without what stiffness and flanks make of it under this load: δ − F/K − e."""
    c_t = scales.c_t
    force = float(scales.force_N(scales.load_from_torque(stated["torque"]) / c_t**2))
    phases = 2.0 * np.pi * np.array(stated["phases"])
    cycles = teeth_of(entries).get(str(stated["over"]).partition(" ")[0], 1)
    mesh = mesh_at(entries, drawing, stated["torque"])
    shape = evaluate(mesh.shape, cycles * phases)
    if stiffness is not None:
        own = stiffness.series.copy()
        own[0] = 0.0
        shape = shape + evaluate(own, phases if stiffness.cycles == cycles else cycles * phases)
    left = values - evaluate(mesh.relief, cycles * phases)
    return unloaded_error_of(left, mesh.mean * shape, force)
