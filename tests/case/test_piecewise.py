"""Cases of kind piecewise-linear: what a file means, overrides, values and what they rest on, round trips."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
import tomllib
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gearlash as gl
from case.piecewise_texts import TEXT, dense
from cli.schema_check import problems
from gearlash.case import Case, CaseError, bundled, load, loads, schema
from gearlash.case.read import source_text
from gearlash.jobs import Pool
from gearlash.system import ContactRule, GearlashError, System, UnknownNameError, evaluate

OWN = [name for name in bundled() if load(name).kind == "piecewise-linear"]


@pytest.fixture(scope="module")
def case() -> Case:
    return loads(TEXT)


def same(one: System, other: System) -> bool:
    def parts(system: System) -> list[object]:
        found: list[object] = [system.omega, system.cycles, system.matrix.tolist(), system.forcing.tolist()]
        for c in system.clearances:
            found += [c.name, c.contact, c.gap_plus, c.gap_minus, c.dampings]
            found += [a.tolist() for a in (c.h, c.g, c.stiffness_plus, c.stiffness_minus, c.offset)]
        return found

    return parts(one) == parts(other)


def test_a_file_means_what_it_says(case: Case):
    family, scales = case.family()
    assert not scales.physical
    assert family.states == ("x", "x'", "y", "y'")
    assert family.defaults == {"omega": 0.9, "zeta": 0.05, "gap": 0.3, "F": 1.5, "phase": 0.25}
    system = family.system()
    assert (system.omega, system.cycles, system.size) == (0.9, 2, 4)
    expected = [[0, 1, 0, 0], [-2, -0.1, 1, 0], [0, 0, 0, 1], [1, 0, -1, -0.05]]
    assert system.matrix == pytest.approx(np.array(expected), abs=1e-15)
    assert np.array_equal(family.start(), [1.8, 0.0, 0.0, 0.0])


def test_forcing_is_a_fourier_series_of_the_base_period(case: Case):
    forcing = case.family()[0].system().forcing
    theta = np.linspace(0.0, 2.0 * np.pi, 17)  # of the base period
    values = evaluate(forcing, theta)
    assert values.T[1] == pytest.approx(0.5 + 1.5 * np.cos(2 * theta) + 0.5 * np.sin(theta), abs=1e-14)
    assert values.T[3] == pytest.approx(1.5 * np.cos(4 * theta + 0.25), abs=1e-14)
    assert not values.T[[0, 2]].any()


def test_clearances_are_as_stated(case: Case):
    stop, wall = case.family()[0].system().clearances
    assert (stop.name, stop.contact, stop.gap_plus, stop.gap_minus) == (
        "stop",
        ContactRule.IN_CONTACT,
        0.3,
        2.0,
    )
    assert (stop.h.tolist(), stop.g.tolist()) == ([1, 0, -1, 0], [0, -1, 0, 1])
    assert stop.stiffness_plus == pytest.approx([3, 0.15, 0, 0.25, 0], abs=1e-16)
    assert stop.stiffness_minus.tolist() == [0.0]
    assert stop.dampings == (0.05, 0.0)
    assert stop.offset == pytest.approx([0, 0, 0, 0, 0.03], abs=1e-17)
    assert (wall.contact, wall.gap_plus, wall.gap_minus) == (ContactRule.NO_TENSION, 5.0, 0.6)
    assert (wall.stiffness_plus.tolist(), wall.stiffness_minus.tolist()) == ([1.0], [1.5])
    assert wall.dampings == (0.0, 0.0)
    assert wall.offset.tolist() == [0.0]


def test_arrays_and_tables_by_name_are_the_same_case(case: Case):
    other = loads(dense())
    assert same(other.family()[0].system(), case.family()[0].system())
    assert other.family()[0].start().tolist() == case.family()[0].start().tolist()


def test_what_is_not_stated_is_zero_or_always():
    text = """
        kind = "piecewise-linear"
        states = ["x", "v"]
        matrix = [[0, 1], [0, 0]]
        parameters.omega = 2
        [[clearance]]
        name = "a"
        h = [1, 0]
        g = [0, -1]
        gap_plus = 1
        gap_minus = 1
        stiffness_plus = 1
        stiffness_minus = 1
        """
    family, _ = loads(text).family()
    system = family.system()
    assert system.cycles == 1
    assert not system.forcing.any()
    assert not family.start().any()
    assert system.clearances[0].contact is ContactRule.ALWAYS
    assert system.clearances[0].dampings == (0.0, 0.0)
    assert not system.clearances[0].offset.any()


def test_a_parameter_reaches_every_number_that_names_it(case: Case):
    family, _ = case.family()
    system = family.system({"zeta": 0.2, "gap": 1.0, "omega": 3.0, "F": 4.0, "phase": 0.0})
    assert system.matrix[1, 1] == pytest.approx(-0.4, abs=1e-16)  # through a definition
    assert system.matrix[3, 0] == pytest.approx(1.0, abs=1e-15)  # through a definition of a definition
    assert system.omega == 3.0
    assert system.forcing[3, 7] == 4.0
    assert system.clearances[0].gap_plus == 1.0
    assert system.clearances[0].stiffness_plus[1] == pytest.approx(0.4, abs=1e-16)
    assert system.clearances[1].stiffness_minus.tolist() == [4.0]
    assert family.start({"gap": 1.0})[0] == 2.5
    assert family.system().clearances[0].gap_plus == 0.3  # the default is untouched


def test_ranges_hold(case: Case):
    family, _ = case.family()
    for bad in ({"zeta": 1.5}, {"zeta": -0.1}, {"omega": 0.0}, {"omega": -1.0}, {"F": np.nan}):
        with pytest.raises(GearlashError, match=next(iter(bad))):
            family.system(bad)
    with pytest.raises(UnknownNameError, match="did you mean 'zeta'"):
        family.system({"zeat": 0.1})


def test_a_number_without_value_at_a_swept_point_is_named(case: Case):
    with pytest.raises(
        GearlashError, match=r"matrix\.y'\.x = 'half/zeta': expected .* at half = 0, zeta = 0"
    ):
        case.family()[0].system({"zeta": 0.0})


def test_overrides_by_name_by_path_and_of_contact_rules(case: Case):
    changed = case.with_overrides({"zeta": "0.2", "parameters.gap": 0.5, "clearance.wall.contact": "always"})
    family, _ = changed.family()
    assert (family.defaults["zeta"], family.defaults["gap"]) == (0.2, 0.5)
    assert family.system().clearances[1].contact is ContactRule.ALWAYS
    assert changed.hash != case.hash
    assert (
        changed.with_overrides({"zeta": 0.05, "gap": 0.3, "clearance.wall.contact": "no-tension"}).hash
        == case.hash
    )
    assert list(changed.entries) == list(case.entries)
    assert changed.entries["zeta"].reason == "set by an override"
    assert case.entries["zeta"].number == 0.05


@pytest.mark.parametrize(
    ("overrides", "path", "expected", "nearest"),
    [
        ({"zeat": 0.1}, "zeat", "exists here", "zeta"),
        ({"zeta": "4 mm"}, "zeta", "a number without unit", None),
        ({"zeta": 2}, "zeta", "up to 1", None),
        ({"omega": 0}, "omega", "above 0", None),
        ({"zeta": "2*gap"}, "zeta", "a number without unit", None),
        (
            {"zeta": 0.1, "parameters.zeta": 0.2},
            "parameters.zeta",
            "zeta = 0.1 and parameters.zeta = 0.2",
            None,
        ),
        ({"clearance.wall.contact": "in contact"}, "clearance.wall.contact", "one of always", "in-contact"),
        (
            {"clearance.wal.contact": "always"},
            "clearance.wal.contact",
            "exists here",
            "clearance.wall.contact",
        ),
        ({"zeta": 0}, "matrix.y'.x", "finite real value", None),
        ({"gap": -4}, "clearance.stop.gap_minus", "0 or more", None),
        ({"clearance.stop.contact": "always"}, "clearance.stop.damping_minus", "'always'", None),
    ],
)
def test_bad_overrides_are_named(case, overrides, path, expected, nearest):
    with pytest.raises(CaseError) as caught:
        case.with_overrides(overrides)
    found = {p.path: p for p in caught.value.problems}
    assert expected in found[path].expected
    assert found[path].nearest == nearest


def test_parameters_resolve_by_name_and_path(case: Case):
    assert case.resolve("zeta", "0.25") == ("zeta", 0.25)
    assert case.resolve("parameters.omega", 3) == ("omega", 3.0)
    with pytest.raises(UnknownNameError, match="did you mean 'zeta'"):
        case.resolve("zet", 1)
    with pytest.raises(UnknownNameError):
        case.resolve("clearance.wall.contact", "always")
    with pytest.raises(CaseError, match="up to 1"):
        case.resolve("zeta", 7)
    assert case.physical("zeta", 0.1) == []


def test_values_show_provenance_and_what_they_rest_on(case: Case):
    shown = {v.path: v for v in case.values()}
    assert (shown["parameters.zeta"].short, shown["parameters.zeta"].description) == ("zeta", "damping ratio")
    assert shown["parameters.gap"].provenance == "assumed"
    assert shown["clearance.stop.contact"].value == "in-contact"
    assert shown["definitions.c"].value == pytest.approx(0.1, abs=1e-16)
    assert shown["definitions.c"].reason == "2*zeta"
    assumed = loads(TEXT.replace("upper = 1.0,", 'upper = 1.0, provenance = "assumed", reason = "usual",'))
    shown = {v.path: v for v in assumed.values()}
    assert shown["definitions.half"].rests_on == ("parameters.zeta",)
    assert shown["derived.closed_frequency_1"].rests_on == ("parameters.zeta",)
    (note,) = case.notes()
    assert note.path == "clearance.stop.stiffness_minus"


def test_json_round_trip_gives_an_identical_family(case: Case):
    again = Case.from_json(case.to_json())
    assert again == case
    assert again.hash == case.hash
    assert same(again.family()[0].system({"F": 0.7}), case.family()[0].system({"F": 0.7}))
    cut = json.loads(case.to_json())
    del cut["structure"]
    with pytest.raises(GearlashError, match="not the JSON of a case"):
        Case.from_json(json.dumps(cut))


@settings(max_examples=40)
@given(
    st.fixed_dictionaries(
        {
            "omega": st.floats(0.02, 50.0),
            "zeta": st.floats(1e-3, 1.0),
            "gap": st.floats(0.0, 10.0),
            "F": st.floats(-10.0, 10.0),
            "phase": st.floats(-7.0, 7.0),
        }
    )
)
def test_families_of_a_case_are_equal_in_every_process(values):
    case = loads(TEXT)
    family, _ = case.family()
    system = family.system(values)
    assert same(system, Case.from_json(case.to_json()).family()[0].system(values))
    assert same(system, pickle.loads(pickle.dumps(family)).system(values))
    assert same(system, case.with_overrides(values).family()[0].system())


def test_the_hash_sees_what_decides_a_result(case: Case):
    texts = (
        TEXT.replace('name = "two masses"', 'name = "other"')
        .replace("damping ratio", "ξ")
        .replace("a guess", "b")
    )
    assert loads(texts).hash == case.hash
    for old, new in (
        ("zeta = { value = 0.05", "zeta = { value = 0.06"),
        ("mean = 3", "mean = 4"),
        ("cycles = 2", ""),
    ):
        assert loads(TEXT.replace(old, new, 1)).hash != case.hash


def test_a_worker_that_reads_case_json_needs_neither_pydantic_nor_the_engine(case: Case):
    script = (
        "import sys; from gearlash.case import Case; Case.from_json(sys.stdin.read()).family()[0].system();"
        "print(sorted({'pydantic', 'numba', 'pint'} & set(sys.modules)))"
    )
    ran = subprocess.run(
        [sys.executable, "-c", script], input=case.to_json(), capture_output=True, text=True, check=True
    )
    assert ran.stdout.strip() == "[]"


BOUNDS = {"minimum", "maximum", "minItems", "maxItems", "maxLength", "default"}


def plain(part: Any) -> Any:
    """A schema without its bounds, which the validator does not know and other tests hold."""
    if isinstance(part, list):
        return [plain(item) for item in part]
    if not isinstance(part, dict):
        return part
    found = {key: plain(item) for key, item in part.items() if key not in BOUNDS or isinstance(item, dict)}
    if "const" in found:
        found["enum"] = [found.pop("const")]
    return found


def schema_problems(raw: dict[str, Any]) -> list[str]:
    whole = plain(schema())
    return problems(raw, whole["$defs"]["piecewise-linear"], whole)


@pytest.mark.parametrize("text", [TEXT, dense(), *(source_text(name)[1] for name in OWN)])
def test_good_files_fit_the_json_schema(text: str):
    assert schema_problems(tomllib.loads(text)) == []


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("cycles = 2", "cyles = 2"),
        ("cycles = 2", "cycles = 2.5"),
        ("omega = 0.9", "omga = 0.9"),
        ("gap_minus = 2", "gap_mius = 2"),
        ("lower = 0.0", 'lower = "0"'),
        ("sin = [0.5]", "sine = [0.5]"),
        ("orders = [4]", "orders = 4"),
        ('"in-contact"', '"in contact"'),
        ('damping = "zeta"', "damping = true"),
        ("h = [1, 0, 0, 0]", "h = 1"),
    ],
)
def test_bad_files_do_not_fit_the_json_schema(old: str, new: str):
    assert schema_problems(tomllib.loads(TEXT.replace(old, new, 1)))


def test_workers_sweep_a_case_of_this_kind_to_the_same_points():
    case = load("shaw-holmes", {"clearance.stop.contact": "always"})
    axis = gl.Axis.even("stop_stiffness", 1.0, 9.0, 5)
    alone = gl.sweep(case, axis)
    with Pool(2) as pool:
        shared = gl.sweep(case, axis, execution=gl.Execution(pool, chunk=2))
    assert [point.status for point in alone.points] == ["ok"] * 5
    assert [point.state.tobytes() for point in shared.points] == [
        point.state.tobytes() for point in alone.points
    ]
