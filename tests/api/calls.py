"""Public callables with arguments that fit, and values that fit nowhere."""

from __future__ import annotations

import dataclasses
import datetime
import random
import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

import gearlash as gl
from gearlash import case, flow, jobs, orbits, plots, results, studies
from gearlash.studies.motion import motion
from gearlash.system import constant


@dataclass(frozen=True)
class Call:
    """A callable with arguments that fit, by name."""

    name: str
    function: Callable[..., Any]
    arguments: dict[str, Any]


def build(values: Mapping[str, float]) -> gl.System:
    """An oscillator that hits a stop."""
    stop = gl.Clearance(
        np.array([1.0, 0.0]), np.array([0.0, -1.0]), 1.0, 5.0, np.array([4.0]), np.array([0.0])
    )
    matrix = np.array([[0.0, 1.0], [-1.0, -0.2]])
    return gl.System(values["omega"], matrix, np.array([[0.0] * 3, [0.0, values["f"], 0.0]]), (stop,))


def rest(values: Mapping[str, float]) -> np.ndarray:
    """At rest."""
    return np.zeros(2)


PLACES = ("system", "flow", "orbits", "branches", "studies", "results", "case", "plots")
QUICK = gl.Settings(max_period=8, budget=300, patience=200, exponent_periods=50)


@cache
def calls() -> tuple[Call, ...]:
    """Every public callable that a person may call."""
    parameters = (gl.Parameter("omega", 0.8), gl.Parameter("f", 1.0))
    family = gl.Family(parameters, ("x", "v"), build, rest)
    spur = gl.load_case("kahraman-singh")
    system = family.system()
    stop, props = system.clearances[0], gl.propagators(system)
    orbit = gl.attractor(props, family.start())
    assert isinstance(orbit, gl.Orbit)
    check = gl.grazing_checks(orbit)[0]
    axis, other = gl.Axis.even("omega", 0.8, 0.82, 2), gl.Axis.even("f", 1.0, 1.1, 2)
    swept, plane = gl.sweep(family, axis), gl.map_plane(family, axis, other)
    dataset, mapped = gl.sweep_dataset(family, [swept]), gl.plane_dataset(family, plane)
    trace, moving, quiet = orbit.trace, motion(orbit), gl.zones(family, axis)
    scales = gl.load_case("article").scales
    point = swept.points[0]
    end, found = gl.ZoneEnd(0.8, "fold"), gl.sections(orbit)
    seen, span = (
        gl.ZoneMotion(gl.Signature(1, 0), ("up",), 0.8, 0.9, True),
        gl.Physical("speed", 1.0, 2.0, "Hz"),
    )
    statistics = gl.motion_statistics(orbit)
    branch = gl.continue_branch(spur, "omega", lower=1.4, upper=1.42, values={"omega": 1.41})
    special = branch.special[0]
    law = gl.grazing_law(spur, branch, special)
    zone = gl.plane_zone(
        spur,
        ("omega", "D"),
        lower=(0.8, 0.99),
        upper=(0.83, 1.01),
        values={"omega": 0.81},
        tolerances={"omega": 0.001, "D": 0.001},
        lines=0,
    )
    curve = gl.continue_curve(spur, ("omega", "D"), special, lower=(1.3, 0.9), upper=(1.5, 1.1))
    two = gl.CodimTwoPoint(
        gl.CodimTwoKind.CUSP, (1.4, 1.0), (0.0, 0.0), curve.points[0], special.label_before,
        special.label_after, False, "", gl.Status.OK,
    )  # fmt: skip
    execution = gl.Execution(chunk=1, progress=print, cancel=threading.Event())
    corners = gl.Axis.even("omega", 1.3, 1.5, 2), gl.Axis.even("D", 0.9, 1.1, 2)
    drawn = gl.atlas(spur, *corners, lines=1)
    study = {"values": {}, "start": [0.0, 0.0], "settings": QUICK, "execution": execution}

    def fields(record: Any) -> dict[str, Any]:
        return {field.name: getattr(record, field.name) for field in dataclasses.fields(record)}

    def whole(kind: Any, record: Any) -> Call:
        return Call(kind.__name__, kind, fields(record))

    records = (
        gl.lyapunov(props, [0.0, 0.0], 40), orbit.certificate, found, found.time,
        statistics, statistics.force,
        gl.march(props, [0.0, 0.0], 3), gl.march_many(props, [[0.0, 0.0]], 3),
        gl.variational(props, [0.0, 0.0], 1.0), trace.extrema, trace.samples(9),
        gl.Zone(end, end, "omega", gl.Quiet.IMPACT_FREE, True, (seen,), (span,)), gl.Interval(end, end),
        branch, branch.points[0], special, law, branch.ends[0], gl.ContinuationSettings(),
        curve, curve.points[0], curve.ends[0], two, drawn, drawn.curves[0], gl.AtlasPoint(two, (0,)),
        gl.LabelChange(
            ((0, 0), (0, 1)), ((1.3, 0.9), (1.5, 0.9)), (gl.Signature(1, 0), None), gl.LabelChangeKind.NONE
        ),
        gl.StraightPiece("D", 0.9, 1.1, 1.4), gl.Undone("branch", None, (1.4, 1.0), "not followed"),
        zone, zone.parts[0], zone.margins[0], zone.tolerance_margins[0],
        end, seen, span, gl.Touch(0.5, 1.0, 0.0, 1),
    )  # fmt: skip
    bifurcation = gl.locate_multiplier(family, "omega", orbit, -1)
    grazing = gl.locate_grazing(family, "f", orbit, check)
    return (
        whole(gl.Clearance, stop), whole(gl.System, system), whole(gl.Family, family),
        whole(gl.Parameter, parameters[0]), whole(gl.Settings, QUICK), whole(gl.Axis, axis),
        whole(gl.Orbit, orbit), whole(gl.Point, point), whole(gl.Sweep, swept), whole(gl.PlaneMap, plane),
        whole(gl.Signature, orbit.signature), whole(gl.Scales, scales), whole(gl.Trace, trace),
        whole(gl.GrazingPoint, grazing), whole(gl.BifurcationPoint, bifurcation), whole(gl.Case, spur),
        whole(orbits.Shot, orbit.shot), whole(flow.Events, trace.events), whole(studies.Zones, quiet),
        whole(gl.Margin, gl.Margin(0.1, 1.0, end)),
        *(whole(type(each), each) for each in records),
        Call("Aperiodic", gl.Aperiodic, {
            "propagators": props, "final_state": np.zeros(2), "largest_exponent": 0.1, "exponent_error": 0.1,
            "periods_used": 3, "status": gl.Status.OK, "message": "", "undecided": 0}),
        Call("ContactRule", gl.ContactRule, {"value": "always"}), Call("Status", gl.Status, {"value": "ok"}),
        Call("MotionKind", gl.MotionKind, {"value": "aperiodic"}),
        Call("Direction", gl.Direction, {"value": "up"}), Call("Verdict", gl.Verdict, {"value": "certified"}),
        Call("cosines", gl.cosines, {"mean": 1.0, "amplitudes": [0.1, 0.2], "phases": [0.0, 1.0]}),
        Call("constant", constant, {"value": 1.0}),
        Call("Family.complete", family.complete, {"values": {"omega": 0.9}}),
        Call("Family.system", family.system, {"values": {"omega": 0.9}}),
        Call("Family.start", family.start, {"values": {"omega": 0.9}}),
        Call("Axis.even", gl.Axis.even, {"name": "omega", "lower": 0.8, "upper": 0.9, "count": 3}),
        Call("Signature.parse", gl.Signature.parse, {"text": "1-1-0"}),
        Call("propagators", gl.propagators, {"system": system, "reuse": props}),
        Call("march", gl.march, {"system": props, "start": [0.0, 0.0], "stretches": 3, "stretch": 2}),
        Call("march_many", gl.march_many, {
            "system": props, "start": [[0.0, 0.0], [0.1, 0.0]], "stretches": 3, "stretch": 2, "threads": 1}),
        Call("trace", gl.trace, {
            "system": props, "start": [0.0, 0.0], "cycles": 2.0, "phase": 0.5,
            "hold": flow.Hold(1, 0.1, 0.2)}),
        Call("variational", gl.variational, {
            "system": system, "start": [0.0, 0.0], "cycles": 1.0, "phase": 0.0}),
        Call("carry", flow.carry, {"system": props, "start": [0.0, 0.0], "cycles": 1.0, "jacobian": True}),
        Call("growth", flow.growth, {
            "system": props, "start": [0.0, 0.0], "tangent": [1.0, 0.0], "periods": 4, "stretch": 2}),
        Call("first_grazing", gl.first_grazing, {
            "model": family, "name": "omega", "start": swept.points[0], "direction": "up",
            "values": {"f": 1.0},
            "settings": QUICK, "tell": print}),
        Call("continue_branch", gl.continue_branch, {
            "model": spur, "name": "omega", "start": branch.points[0], "lower": 1.4, "upper": 1.42,
            "values": {}, "steps": gl.ContinuationSettings(longest=0.5, first=0.1),
            "execution": execution}),
        Call("continue_curve", gl.continue_curve, {
            "model": spur, "names": ("omega", "D"), "special": special, "lower": (1.3, 0.9),
            "upper": (1.5, 1.1), "values": {}, "branch": branch, "kind": "grazing", "touch": 0,
            "doubled": False, "steps": gl.ContinuationSettings(longest=0.5, first=0.1),
            "execution": execution}),
        Call("atlas", gl.atlas, {
            "model": spur, "x": corners[0], "y": corners[1], "values": {}, "curves": 1, "lines": 0,
            "depth": 0, "longest": 2, "seconds": 60.0, "start": [0.0, 0.0], "settings": QUICK,
            "execution": execution}),
        Call("atlas_dataset", gl.atlas_dataset, {"model": spur, "atlas": drawn}),
        Call("Atlas.of_kind", drawn.of_kind, {"kind": "fold"}),
        Call("LabelChangeKind", gl.LabelChangeKind, {"value": "curve"}),
        Call("plane_zone", gl.plane_zone, {
            "model": spur, "names": ("omega", "D"), "lower": (0.79, 0.99), "upper": (0.81, 1.01),
            "quiet": "impact-free", "values": {"omega": 0.8}, "tolerances": {"omega": 0.001, "D": 0.001},
            "start": None, "lines": 0, "settings": QUICK, "execution": execution}),
        Call("PlaneZone.contains", zone.contains, {"first": 0.8, "second": 1.0}),
        Call("switch_branch", gl.switch_branch, {
            "model": spur, "branch": branch, "special": special, "steps": gl.ContinuationSettings(),
            "execution": execution}),
        Call("grazing_law", gl.grazing_law, {"model": spur, "branch": branch, "special": special}),
        Call("GrazingLaw.at", law.at, {"depth": 1e-4}),
        Call("Branch.of_kind", branch.of_kind, {"kind": "fold"}),
        Call("Curve.of_kind", curve.of_kind, {"kind": "cusp"}),
        Call("CodimTwoKind", gl.CodimTwoKind, {"value": "cusp"}),
        Call("CurveEndKind", gl.CurveEndKind, {"value": "cancelled"}),
        Call("Branch.at", branch.at, {"value": 1.4}),
        Call("SpecialKind", gl.SpecialKind, {"value": "fold"}),
        Call("DerivativeKind", gl.DerivativeKind, {"value": "exact"}),
        Call("EndKind", gl.EndKind, {"value": "cancelled"}),
        Call("impact_free_speeds", gl.impact_free_speeds, {
            "model": spur, "values": {"omega": 0.9}, "tell": print}),
        Call("tolerance", gl.tolerance, {
            "case": spur, "axis": gl.Axis.even("omega", 0.6, 0.9, 3), "limits": {"load": (0.1, 0.2)},
            "samples": 2, "replicates": 2, "execution": execution}),
        Call("measurement", gl.measurement, {
            "case": spur, "speeds": [0.7, 0.72], "values": [0.3, 0.31], "quantity": "mesh_force",
            "speed_unit": "", "unit": "", "reference": ""}),
        Call("compare", gl.compare, {
            "case": spur, "measurement": gl.measurement(spur, [0.7, 0.72], [0.3, 0.31], "mesh_force"),
            "figure": "peak", "order": 1.0, "settings": QUICK, "execution": execution}),
        Call("load_measurement", gl.load_measurement, {
            "case": spur, "path": "none.csv", "quantity": "gap", "speed": "1", "value": "2", "speed_unit": "",
            "unit": "", "reference": ""}),
        Call("Trace.at", trace.at, {"phase": [0.1, 0.2], "clearance": 0}),
        Call("Trace.samples", trace.samples, {"points": 9}),
        Call("Trace.gap_of", trace.gap_of, {"clearance": 0}),
        Call("Trace.regions_of", trace.regions_of, {"clearance": 0}),
        Call("Trace.extrema_of", trace.extrema_of, {"clearance": 0}),
        Call("Events.of", trace.events.of, {"clearance": 0}),
        Call("Events.where", trace.events.where, {"mask": np.zeros(len(trace.events), dtype=bool)}),
        Call("attractor", gl.attractor, {
            "system": props, "start": [0.0, 0.0], "settings": QUICK, "trial": ([0.0, 0.0], 1)}),
        Call("lyapunov", gl.lyapunov, {
            "system": props, "start": [0.0, 0.0], "periods": 40, "count": 2, "settle": 3}),
        Call("shoot", orbits.shoot, {
            "system": props, "start": [0.0, 0.0], "period": 1, "iterations": 5, "reach": 1.0}),
        Call("multipliers", orbits.multipliers, {"system": props, "start": orbit.state, "period": 1}),
        Call("grazing_checks", gl.grazing_checks, {"attractor": orbit, "within": 1.0, "clearance": 0}),
        Call("sections", gl.sections, {"attractor": orbit, "clearance": 0}),
        Call("motion_statistics", gl.motion_statistics, {"attractor": orbit, "clearance": 0}),
        Call("motion", motion, {"attractor": orbit, "value": 1.0, "touch": (0.5, 1), "clearance": 0}),
        Call("locate_grazing", gl.locate_grazing, {
            "model": family, "values": {}, "name": "f", "orbit": orbit, "check": check}),
        Call("locate_multiplier", gl.locate_multiplier, {
            "model": family, "values": {}, "name": "omega", "orbit": orbit, "multiplier": -1}),
        Call("point", gl.point, {
            "model": family, "values": {}, "name": "omega", "start": [0.0, 0.0], "trial": ([0.0, 0.0], 1),
            "settings": QUICK}),
        Call("Execution", gl.Execution, {
            "executor": None, "chunk": 1, "progress": print, "cancel": threading.Event()}),
        Call("orbit_at", orbits.orbit_at, {
            "system": props, "start": orbit.state, "period": 1, "iterations": 9, "least": True}),
        Call("motions_beside", gl.motions_beside, {
            "found": orbit, "start": {"x": 0.0, "v": 0.0}, "cold_start": [0.0, 0.0], "settings": QUICK,
            "tell": print}),
        Call("sweep", gl.sweep, {"model": family, "axis": axis, "direction": "up", **study}),
        Call("sweeps", gl.sweeps, {"model": family, "axis": axis, "directions": ("up",), **study}),
        Call("map_plane", gl.map_plane, {"model": family, "x": axis, "y": other, **study}),
        Call("zones", gl.zones, {
            "model": family, "axis": axis, "quiet": "impact-free", "known": quiet.sweeps, **study}),
        Call("transitions", gl.transitions, {
            "model": family, "values": {}, "name": "omega", "points": swept.points, "rising": True}),
        Call("open_workers", gl.open_workers, {"model": family, "workers": 1}),
        Call("open_executor", jobs.open_executor, {"workers": 1}),
        Call("sweep_dataset", gl.sweep_dataset, {"model": family, "sweeps": [swept]}),
        Call("curve_dataset", gl.curve_dataset, {"model": spur, "curve": curve}),
        Call("plane_dataset", gl.plane_dataset, {"model": family, "plane": plane}),
        Call("table", gl.table, {"dataset": dataset}),
        Call("content_hash", results.content_hash, {"dataset": dataset}),
        Call("same_motion", results.same_motion, {"one": point, "other": point}),
        Call("coexisting", results.coexisting, {"sweeps": [swept, swept]}),
        Call("save_dataset", gl.save_dataset, {"dataset": dataset, "path": "a.nc"}),
        Call("save_branch", gl.save_branch, {"branch": branch, "path": "a.json", "model": spur}),
        Call("save_curve", gl.save_curve, {"curve": curve, "path": "a.json", "model": spur}),
        Call("load_curve", gl.load_curve, {"path": "none.json"}),
        Call("load_branch", gl.load_branch, {"path": "none.json"}),
        Call("branch_dataset", gl.branch_dataset, {"model": spur, "branch": branch, "extremes": True}),
        Call("load_dataset", gl.load_dataset, {"path": "none.nc"}),
        Call("load_case", gl.load_case, {"path_or_name": "article", "overrides": {"error": "6um"}}),
        Call("loads", case.loads, {"text": "", "overrides": {}, "label": "case"}),
        Call("Case.from_json", gl.Case.from_json, {"text": spur.to_json()}),
        Call("Case.with_overrides", spur.with_overrides, {"overrides": {"D": 1.1}}),
        Call("Case.resolve", spur.resolve, {"name": "D", "value": "1.1"}),
        Call("Case.physical", spur.physical, {"short": "D", "value": 1.1}),
        Call("Scales.pinion_rpm", scales.pinion_rpm, {"omega": 1.0}),
        Call("Scales.length_um", scales.length_um, {"displacement": [1.0, 2.0]}),
        Call("Scales.load_from_torque", scales.load_from_torque, {"torque": 1.0}),
        Call("plots.draw", plots.draw, {"result": orbit, "model": family}),
        Call("plots.diagram", plots.diagram, {"dataset": dataset, "marks": (), "units": plots.Units()}),
        Call("plots.branch_diagram", plots.branch_diagram, {
            "datasets": [gl.branch_dataset(spur, branch)], "measure": "maximum", "cloud": dataset,
            "multipliers": True, "title": "", "span": (), "units": plots.Units(), "along": None}),
        Call("plots.curve_diagram", plots.curve_diagram, {
            "curves": [curve], "model": spur, "title": "", "behind": None, "span": (),
            "along": (None, None)}),
        Call("plots.plane", plots.plane, {"dataset": mapped, "units": plots.Units()}),
        Call("plots.portrait", plots.portrait, {"motion": moving, "units": plots.Units(), "parameter": "f"}),
        Call("plots.history", plots.history, {"motion": moving, "units": plots.Units(), "parameter": "f"}),
        Call("plots.sections", plots.sections, {"motions": [moving], "parameter": "f"}),
        Call("plots.gallery", plots.gallery, {"motions": [moving], "parameter": "f"}),
        Call("plots.Units.of", plots.Units.of, {"case": spur}),
        Call("reproduce", gl.reproduce, {"case": None}),
        Call("pair_report", gl.pair_report, {"case": None, "folder": None, "speeds": None,
            "settings": QUICK, "execution": None}),
    )  # fmt: skip


class Odd:
    """An object of no use."""

    def __init__(self, *_: object) -> None:
        """Whatever it is called with, as a function that is told how far a study is."""

    def __repr__(self) -> str:
        raise RuntimeError("not even this")


WRONG: tuple[Callable[[random.Random], Any], ...] = (
    lambda r: None, lambda r: r.choice(["", "1", "always", "omega", "x" * 5000, "\x00", "∞", "ALWAYS"]),
    lambda r: r.choice([b"1", bytearray(3), memoryview(b"12")]),
    lambda r: r.choice([True, False, np.True_]), lambda r: r.choice([1j, np.complex128(2), complex("nan")]),
    lambda r: r.choice([float("nan"), float("inf"), -float("inf"), np.float64("nan")]),
    lambda r: r.choice([0, -1, -7, 0.0, -0.5, 2.5, np.int8(-3), np.uint64(2**64 - 1)]),
    lambda r: r.choice([10**400, -(10**400), 10**18, 1e308, -1e308, 5e-324]),
    lambda r: r.choice([Decimal("NaN"), Decimal("sNaN"), Decimal("1e9999"), Fraction(-1, 3)]),
    lambda r: r.choice([[], (), {}, set(), frozenset(), range(3), iter([1.0]), (i for i in range(2))]),
    lambda r: r.choice([[1.0], [1.0, 2.0, 3.0], [[1.0, 2.0]], [[[1.0]]], [[1.0], [2.0, 3.0]]]),
    lambda r: r.choice([["1", "2"], [None, 1.0], [True, False], [1j, 2.0], [float("nan"), 1.0], [object()]]),
    lambda r: r.choice([np.array(1.0), np.array(1), np.zeros(0), np.zeros((2, 0)), np.zeros((2, 2, 2))]),
    lambda r: r.choice([np.array(["a", "b"]), np.array([1, "b"], dtype=object), np.array([1j, 2])]),
    lambda r: np.ma.masked_array([1.0, 2.0], [r.random() < 0.5, True]),
    lambda r: r.choice([np.datetime64("2020-01-01"), np.timedelta64(3, "s"), datetime.date(2020, 1, 1)]),
    lambda r: r.choice([pd.Series([1.0, 2.0]), pd.DataFrame({"x": [1.0]}), pd.NA, pd.Timestamp(0)]),
    lambda r: r.choice([object(), Odd(), Odd, lambda *_: 1, print, Path("nowhere"), ..., NotImplemented]),
    lambda r: r.choice([{"omega": 1.0}, {"omega": "1"}, {"omga": 1.0}, {1: 2.0}, {"f": None}, {"f": [1.0]}]),
    lambda r: r.choice([calls()[r.randrange(len(calls()))].arguments, ValueError("x"), ValueError]),
    lambda r: r.choice(list(r.choice(calls()).arguments.values()) or [None]),  # what fits somewhere else
)  # fmt: skip


def wrong(source: random.Random) -> Any:
    """A value that fits hardly anywhere."""
    return source.choice(WRONG)(source)
