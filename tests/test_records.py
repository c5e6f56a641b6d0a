"""What is handed out travels between processes, copies, and prints in a few lines."""

from __future__ import annotations

import copy
import dataclasses
import pickle
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np
import pytest

import gearlash as gl
from gearlash import flow, orbits, plots
from gearlash.case import loads
from gearlash.orbits import Certificate
from gearlash.studies.motion import motion
from gearlash.system import Record

MODELS = ["article-first-harmonic", "kahraman-singh", "shaw-holmes", "two-stage"]


@cache
def records(name: str) -> dict[str, Any]:
    """One of every kind that a person comes to hold."""
    case = gl.load_case(name)
    family, scales = case.family()
    system = family.system()
    props = gl.propagators(system)
    found = gl.attractor(props, family.start())
    speeds = gl.Axis.even("omega", 0.99 * system.omega, 1.01 * system.omega, 3)
    zones = gl.zones(case, speeds, "drive-side-only")
    checks = gl.grazing_checks(found)
    values = family.defaults
    made = {
        "case": case, "scales": scales, "system": system, "clearance": system.clearances[0],
        "propagators": props, "attractor": found, "trace": found.trace, "events": found.events,
        "extrema": found.extrema, "samples": found.trace.samples(9), "certificate": found.certificate,
        "sections": gl.sections(found), "statistics": gl.motion_statistics(found), "check": checks[0],
        "strobes": gl.march(props, family.start(), 5), "carried": gl.variational(props, family.start(), 1.0),
        "many": gl.march_many(props, [family.start()] * 2, 3), "axis": speeds, "settings": gl.Settings(),
        "exponents": gl.lyapunov(props, found.final_state, 40), "point": zones.sweeps[0].points[0],
        "sweep": zones.sweeps[0], "zones": zones, "motion": motion(found),
        "parameter": family.parameters[0],
    }  # fmt: skip
    if isinstance(found, gl.Orbit):
        made |= {"shot": found.shot, "signature": found.signature}
        made["grazing"] = gl.locate_grazing(family, "omega", found, checks[0], values=values)
        made["doubling"] = gl.locate_multiplier(family, "omega", found, -1, values=values)
    if len(family.parameters) > 1:
        other = next(p for p in family.parameters if p.name != "omega" and p.default > 0.0)
        ends = (0.99 * other.default, 1.01 * other.default)
        made["map"] = gl.map_plane(case, speeds, gl.Axis.even(other.name, *ends, 2))
    return made


def same(one: Any, other: Any) -> bool:
    """The same content, down to the last bit."""
    if isinstance(one, np.ndarray):
        return np.array_equal(one, other, equal_nan=one.dtype.kind in "fc")
    if isinstance(one, flow.Propagators):
        return same(one.system, other.system) and one.cells == other.cells
    if dataclasses.is_dataclass(one):
        return type(one) is type(other) and all(
            same(getattr(one, f.name), getattr(other, f.name)) for f in dataclasses.fields(one)
        )
    if isinstance(one, Mapping):
        return one.keys() == other.keys() and all(same(one[key], other[key]) for key in one)
    if isinstance(one, (tuple, list)):
        return len(one) == len(other) and all(map(same, one, other))
    return one == other or (one != one and other != other)


@pytest.mark.parametrize("name", MODELS)
def test_everything_travels_and_copies(name: str):
    for what, record in records(name).items():
        for again in (pickle.loads(pickle.dumps(record)), copy.copy(record), copy.deepcopy(record)):
            assert same(record, again), what
            assert repr(again) == repr(record), what


@pytest.mark.parametrize("name", MODELS)
def test_everything_prints_in_a_few_lines(name: str):
    for what, record in records(name).items():
        assert len(repr(record)) <= 400, what
        assert repr(record).count("\n") <= 5, what
        begins = str(record) if isinstance(record, gl.Signature) else type(record).__name__
        assert repr(record).startswith(begins), what


@pytest.mark.parametrize("name", MODELS)
def test_notebooks_get_a_table(name: str):
    for what, record in records(name).items():
        if isinstance(record, Record):
            shown = record._repr_html_()
            assert shown.startswith("<table>"), what
            assert len(shown) < 4000, what


def test_texts_in_a_table_are_escaped():
    text = 'kind = "spur-1dof"\nname = "<script>"\n[dimensionless]\nomega = 1.0\nD = 1.0\nload = 0.1\n'
    shown = loads(text + "mesh_damping = 0.05\n")._repr_html_()
    assert "<script>" not in shown
    assert "&lt;script&gt;" in shown


def test_an_orbit_that_travelled_is_the_same_orbit():
    orbit = records("article-first-harmonic")["attractor"]
    again = pickle.loads(pickle.dumps(orbit))
    assert (again.label, again.leading) == (orbit.label, orbit.leading)
    assert np.array_equal(again.multipliers, orbit.multipliers)
    assert same(again.trace, orbit.trace)
    assert isinstance(again.certificate, Certificate)
    assert orbits.sections(again).time.state.tolist() == orbits.sections(orbit).time.state.tolist()


def test_arrays_of_models_stay_read_only_on_the_way():
    clearance = pickle.loads(pickle.dumps(records("shaw-holmes")["clearance"]))
    assert not clearance.h.flags.writeable


@pytest.mark.parametrize("what", ["attractor", "motion", "sweep", "zones", "map"])
def test_a_figure_on_request(what: str):
    found = records("kahraman-singh")
    figure = plots.draw(found[what], found["case"])
    assert figure._repr_svg_().startswith("<?xml")  # pyright: ignore[reportAttributeAccessIssue]
    assert plots.draw(found["sweep"], found["case"].family()[0])
    with pytest.raises(gl.GearlashError, match="expected an attractor"):
        plots.draw(found["axis"], found["case"])
    if what in ("sweep", "zones", "map"):
        with pytest.raises(gl.GearlashError, match="with its case or family"):
            plots.draw(found[what])
