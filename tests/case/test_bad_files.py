"""Bad input, one kind a row: each is named with its path, its value, what is expected, the nearest name."""

import datetime
import tomllib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearlash.case import CaseError, bundled, load, loads, schema
from gearlash.case.case import from_tables
from gearlash.case.quantities import GEAR_KINDS, KINDS, choices, quantities
from gearlash.case.read import source_text

HELICAL = """
kind = "helical-pair"
[pinion]
teeth = 28
mass = "5.98 kg"
bearing_stiffness_y = "8.0e8 N/m"
bearing_stiffness_z = "6.8e8 N/m"
[gear]
teeth = 70
mass = "34.72 kg"
bearing_stiffness_y = "4.0e8 N/m"
bearing_stiffness_z = "3.2e8 N/m"
[bearings]
damping_ratio = 0.02
[mesh]
normal_module = "4 mm"
pressure_angle = "20 deg"
helix_angle = "18 deg"
mean_stiffness = "3.2e8 N/m"
damping_ratio = 0.07
backlash = "100 um"
ripple = 0.3
error = "13 um"
[operation]
pinion_speed = "4000 rpm"
torque = "95 N·m"
"""
SPUR = """
kind = "spur-1dof"
[pinion]
teeth = 16
base_radius = "50 mm"
inertia = "0.00115 kg·m²"
[gear]
base_radius = "50 mm"
inertia = "0.00115 kg·m²"
[mesh]
mean_stiffness = "3.8e8 N/m"
damping_ratio = 0.05
backlash = "200 um"
[dimensionless]
omega = 0.5
load = 0.1
"""


def problems_of(text, overrides=None):
    with pytest.raises(CaseError) as caught:
        loads(text, overrides)
    assert caught.value.exit_code == 2
    for problem in caught.value.problems:
        assert str(problem) in str(caught.value)
        assert problem.path
        assert problem.expected
    return caught.value.problems


def test_the_two_texts_that_the_rows_start_from_are_right():
    assert loads(HELICAL).kind == "helical-pair"
    assert loads(SPUR).kind == "spur-1dof"


# (what is replaced, by what, path of the problem, words in what is expected, nearest name)
REPLACED = [
    ('"4 mm"', '"4 mm;"', "mesh.normal_module", "'mm;' is no unit", None),
    ('"4 mm"', '"nan mm"', "mesh.normal_module", "not a finite number", None),
    ('"4 mm"', '"inf mm"', "mesh.normal_module", "not a finite number", None),
    ('"4 mm"', '"4 kg"', "mesh.normal_module", "a length with its unit", None),
    ('"4 mm"', '"4"', "mesh.normal_module", "a length with its unit", None),
    ('"4 mm"', "4", "mesh.normal_module", "a length with its unit", None),
    ('"4 mm"', "nan", "mesh.normal_module", "a length with its unit", None),
    ('"4 mm"', '""', "mesh.normal_module", "nothing stands there", None),
    ('"4 mm"', "true", "mesh.normal_module", "a length with its unit", None),
    ('"4 mm"', "[4]", "mesh.normal_module", "a length with its unit", None),
    ('"4 mm"', "1979-05-27", "mesh.normal_module", "a length with its unit", None),
    ('"4 mm"', '"4,0 mm"', "mesh.normal_module", "decimal point", None),
    ('"4 mm"', '"4 m"', "mesh.normal_module", "up to 200 mm", None),
    ('"4 mm"', '"4 Mm"', "mesh.normal_module", "up to 200 mm", None),
    ('"4 mm"', '"-4 mm"', "mesh.normal_module", "above 0 mm", None),
    ('"4 mm"', '"1e-400 mm"', "mesh.normal_module", "double precision", None),
    ('"100 um"', '"-1 um"', "mesh.backlash", "from 0 um", None),
    ('"100 um"', '"0 um"', "model.reference_length", "no backlash to take half of", None),
    ('"5.98 kg"', '"-5.98 kg"', "pinion.mass", "above 0 kg", None),
    ('"5.98 kg"', '"5.98 Kg"', "pinion.mass", "'kg' is", None),
    ('"5.98 kg"', '"5.98 mm"', "pinion.mass", "a mass with its unit", None),
    ("teeth = 28", "teeth = 28.5", "pinion.teeth", "a whole number", None),
    ("teeth = 28", "teeth = 0", "pinion.teeth", "a whole number from 5", None),
    ("teeth = 28", "teeth = true", "pinion.teeth", "a whole number", None),
    ("teeth = 28", 'teeth = "28 mm"', "pinion.teeth", "a whole number", None),
    ('"20 deg"', '"90 deg"', "mesh.pressure_angle", "up to 89.91 deg", None),
    ('"20 deg"', '"0 deg"', "mesh.pressure_angle", "above 0 deg", None),
    ('"20 deg"', "20", "mesh.pressure_angle", "an angle with its unit", None),
    ('"18 deg"', '"-95 deg"', "mesh.helix_angle", "from -89.91 deg", None),
    ('"3.2e8 N/m"\ndamp', '"3.2e8 Nm"\ndamp', "mesh.mean_stiffness", "a stiffness with its unit", None),
    ('"3.2e8 N/m"\ndamp', '"-3.2e8 N/m"\ndamp', "mesh.mean_stiffness", "above 0 N/m", None),
    ("damping_ratio = 0.07", "damping_ratio = -0.07", "mesh.damping_ratio", "from 0", None),
    ("damping_ratio = 0.07", "damping_ratio = nan", "mesh.damping_ratio", "not finite", None),
    ("damping_ratio = 0.07", 'damping_ratio = "7 mm"', "mesh.damping_ratio", "a number without unit", None),
    ('"4000 rpm"', '"60 Hz"', "operation.pinion_speed", "a rotational speed", None),
    ('"4000 rpm"', '"0 rpm"', "operation.pinion_speed", "above 0 rpm", None),
    ('"4000 rpm"', "4000", "operation.pinion_speed", "a rotational speed with its unit", None),
    ('"95 N·m"', '"95 N"', "operation.torque", "a torque with its unit", None),
    ("ripple = 0.3", "ripple = 1.2", "mesh.ripple", "stiffness positive", None),
    ("ripple = 0.3", "ripple = 3", "mesh.ripple", "up to 2", None),
    ("ripple = 0.3", "ripple_9 = 0.3", "mesh.ripple_9", "a name that exists", "mesh.ripple_8"),
    ("backlash =", "backlsh =", "mesh.backlsh", "a name that exists", "mesh.backlash"),
    ("[mesh]", "[mehs]", "mehs", "a name that exists", "mesh"),
    ("[operation]\n", "[operation]\nbacklash = '1 um'\n", "operation.backlash", "exists", "mesh.backlash"),
    ('"helical-pair"', '"helical-par"', "kind", "one of helical-pair", "helical-pair"),
    ('"helical-pair"', "3", "kind", "one of helical-pair", None),
    ('kind = "helical-pair"', "", "kind", "as the first line", None),
    ("[pinion]", "model = 0.02\n[pinion]", "model", "a table [model]", None),
    ("damping_ratio = 0.02", "damping_ratio = {}", "bearings.damping_ratio", "a table with a value", None),
    (
        "damping_ratio = 0.02",
        'damping_ratio = { value = 0.02, provenence = "assumed" }',
        "bearings.damping_ratio",
        "without 'provenence'",
        "provenance",
    ),
    (
        "damping_ratio = 0.02",
        'damping_ratio = { value = 0.02, provenance = "asumed" }',
        "bearings.damping_ratio",
        "a provenance out of given",
        "assumed",
    ),
    (
        "damping_ratio = 0.02",
        "damping_ratio = { value = 0.02, provenance = 3 }",
        "bearings.damping_ratio",
        "a provenance out of",
        None,
    ),
    (
        "damping_ratio = 0.02",
        "damping_ratio = { value = 0.02, reason = 3 }",
        "bearings.damping_ratio",
        "a reason in words",
        None,
    ),
    ("[operation]", '[model]\nprojection = "bas"\n[operation]', "model.projection", "one of pitch", "base"),
    ("[operation]", "[model]\ncontact = 1\n[operation]", "model.contact", "one of always", None),
    ("[operation]", "[source]\ndoi = 3\n[operation]", "source.doi", "a text", None),
    (
        "[operation]",
        "[dimensionless]\ny_factor = 0.9\n[operation]",
        "dimensionless.y_factor",
        "follows",
        None,
    ),
]


@pytest.mark.parametrize(("old", "new", "path", "expected", "nearest"), REPLACED)
def test_every_kind_of_bad_value_is_named(old, new, path, expected, nearest):
    assert old in HELICAL
    found = {p.path: p for p in problems_of(HELICAL.replace(old, new, 1))}
    assert path in found
    assert expected in found[path].expected
    assert found[path].nearest == nearest


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [('"95 N·m"', '"95 N·m', 26), ("[operation]", "[mesh]", 24), ("[pinion]", "bearings = 1\n[pinion]", 14)],
)
def test_errors_of_toml_syntax_name_the_line(old, new, line):
    (problem,) = problems_of(HELICAL.replace(old, new, 1))
    assert problem.path.startswith(f"line {line}")
    assert "valid TOML" in problem.expected


@pytest.mark.parametrize(
    ("line", "path", "ways"),
    [
        ("teeth = 28\n", "pinion.teeth", ""),
        ('mass = "5.98 kg"\n', "pinion.mass", ""),
        ('bearing_stiffness_y = "8.0e8 N/m"\n', "pinion.bearing_stiffness_y", "bearing_frequency_yp"),
        ("damping_ratio = 0.02\n", "bearings.damping_ratio", "dimensionless.bearing_damping"),
        ("damping_ratio = 0.07\n", "mesh.damping_ratio", "dimensionless.mesh_damping"),
        ('normal_module = "4 mm"\n', "mesh.normal_module", ""),
        ('mean_stiffness = "3.2e8 N/m"\n', "mesh.mean_stiffness", ""),
        ('backlash = "100 um"\n', "mesh.backlash", "dimensionless.D"),
        (
            'pinion_speed = "4000 rpm"\n',
            "operation.pinion_speed",
            "operation.mesh_frequency, dimensionless.omega",
        ),
        ('torque = "95 N·m"\n', "operation.torque", "dimensionless.load"),
    ],
)
def test_a_missing_value_is_named_with_every_way_to_state_it(line, path, ways):
    assert line in HELICAL
    (problem,) = problems_of(HELICAL.replace(line, "", 1))
    assert (problem.path, problem.missing, problem.value) == (path, True, None)
    assert f"{path} is missing" in str(problem)
    assert ways in problem.expected


def test_spur_bodies_may_be_stated_in_three_ways_and_are_asked_for_otherwise():
    bare = SPUR.replace('inertia = "0.00115 kg·m²"\n', "")
    assert [p.path for p in problems_of(bare)] == ["pinion.inertia", "gear.inertia"]
    masses = bare.replace("[mesh]", 'mass = "1 kg"\n[mesh]').replace("[gear]", 'mass = "1 kg"\n[gear]')
    assert [p.path for p in problems_of(masses)] == [
        "pinion.inertia",
        "gear.inertia",
    ]  # discs of which radius?
    lumped = loads(bare.replace("[mesh]", '[mesh]\nequivalent_mass = "0.23 kg"'))
    assert lumped.family()[0].defaults == pytest.approx(loads(SPUR).family()[0].defaults)
    no_radii = SPUR.replace('base_radius = "50 mm"\n', "")
    assert {p.path for p in problems_of(no_radii)} == {"gear.teeth", "mesh.module", "mesh.pressure_angle"}
    twice = SPUR.replace("[mesh]", '[mesh]\nequivalent_mass = "0.23 kg"')
    assert "follows from both inertias" in problems_of(twice)[0].expected
    mixed = SPUR.replace("[mesh]", '[mesh]\nmodule = "6 mm"')
    assert {p.path for p in problems_of(mixed)} == {"pinion.base_radius", "gear.base_radius"}


def test_a_torque_on_an_equivalent_mass_needs_a_radius():
    lumped = """
        kind = "spur-1dof"
        pinion.teeth = 20
        [mesh]
        mean_stiffness = "1e8 N/m"
        equivalent_mass = "1 kg"
        backlash = "50 um"
        damping_ratio = 0.05
        [operation]
        mesh_frequency = "500 Hz"
        torque = "10 N m"
        """
    assert "mesh.module" in [p.path for p in problems_of(lumped)]
    radii = 'pinion.base_radius = "3 cm"\n gear.base_radius = "6 cm"\n pinion.teeth'
    assert float(loads(lumped.replace("pinion.teeth", radii)).scales.torque(1.0)) == pytest.approx(
        2500 * 0.03
    )


def test_a_dimensionless_case_that_lacks_numbers_is_told_which():
    found = {p.path for p in problems_of('kind = "helical-pair"\n[dimensionless]\nomega = 1.0')}
    assert {"dimensionless.rotation_factor", "dimensionless.mass_ratio_g"} <= found
    assert not any(path.startswith("gear.t") for path in found)


def test_an_empty_case_is_asked_for_a_drawing():
    assert "mesh.mean_stiffness" in {p.path for p in problems_of('kind = "helical-pair"')}


@pytest.mark.parametrize(
    ("old", "new", "places"),
    [
        (
            "[operation]\n",
            '[operation]\nmesh_frequency = "1680 Hz"\n',
            ["operation.mesh_frequency = '1680 Hz'", "operation.pinion_speed = '4000 rpm'"],
        ),
        (
            "[operation]",
            "[dimensionless]\nD = 0.8\n[operation]",
            ["dimensionless.D = '0.8'", "mesh.backlash = '100 um'"],
        ),
        ("[operation]", "[dimensionless]\nload = 0.1\n[operation]", ["load = '0.1'", "torque = '95 N·m'"]),
        (
            "[operation]",
            "[dimensionless]\nripple = 0.1\n[operation]",
            ["dimensionless.ripple", "mesh.ripple"],
        ),
        (
            "[gear]",
            "bearing_damping_y = 0.05\n[gear]",
            ["bearings.damping_ratio", "pinion.bearing_damping_y"],
        ),
    ],
)
def test_one_quantity_named_twice_is_an_error_that_shows_both(old, new, places):
    (problem,) = problems_of(HELICAL.replace(old, new, 1))
    assert "name the same quantity" in problem.expected
    for place in places:
        assert place in problem.expected


def test_all_problems_of_a_file_come_at_once():
    text = (
        HELICAL.replace('"4 mm"', '"4 kg"')
        .replace("teeth = 28", "teeth = 2.5")
        .replace("backlash", "baklash")
    )
    text = text.replace('torque = "95 N·m"', 'mesh_frequency = "3 Hz"').replace(
        "[gear]", "[gear]\ncolour = 1"
    )
    paths = [p.path for p in problems_of(text, {"D": "x", "nothing": 1})]
    assert sorted(paths) == sorted(
        [
            "mesh.normal_module",
            "pinion.teeth",
            "mesh.baklash",  # not also as a missing backlash: the nearest name says what was meant
            "gear.colour",
            "operation.torque",
            "operation.pinion_speed",
            "D",
            "nothing",
        ]
    )


@pytest.mark.parametrize(
    ("overrides", "path", "expected"),
    [
        ({"baklash": "1 um"}, "baklash", "exists here"),
        ({"mass": "3 kg"}, "mass", "one of pinion.mass, gear.mass"),
        ({"D": "0.8 mm"}, "D", "a number without unit"),
        ({"D": True}, "D", "a number without unit"),
        ({"D": -0.5}, "D", "from 0"),
        ({"omega": "0"}, "omega", "above 0"),
        ({"pinion_speed": 3600}, "pinion_speed", "with its unit"),
        ({"D": 0.8, "backlash": "80 um"}, "dimensionless.D", "name the same quantity"),
        ({"D": 0.8, "dimensionless.D": 0.7}, "dimensionless.D", "D = 0.8 and dimensionless.D = 0.7"),
        ({"reference_length": "40 um"}, "reference_length", "no override"),
        ({"projection": "pich"}, "projection", "one of pitch"),
        ({"ripple": 1.9}, "dimensionless.ripple", "stiffness positive"),
    ],
)
def test_bad_overrides_are_named(overrides, path, expected):
    found = {p.path: p for p in problems_of(HELICAL, overrides)}
    assert expected in found[path].expected


def test_nearest_names_are_offered_for_overrides_and_files():
    assert problems_of(HELICAL, {"baklash": "1 um"})[0].nearest == "backlash"
    with pytest.raises(CaseError, match="did you mean 'article'"):
        load("artikle")


def test_files_that_cannot_be_read_are_named(tmp_path):
    binary = tmp_path / "binary.toml"
    binary.write_bytes(b"kind = 'helical-pair'\n# \xff\xfe")
    for path, text in ((tmp_path / "none.toml", "No such file"), (tmp_path, "directory"), (binary, "UTF-8")):
        with pytest.raises(CaseError, match=text):
            load(path)
    with pytest.raises(CaseError, match="file"):
        load("bad\0name")


@pytest.mark.parametrize("text", ["a = " + "[" * 5000, "a = " + "9" * 5000, "\x00", "= 1", "kind = 1e400"])
def test_hostile_toml_is_a_case_error(text):
    problems_of(text)


def test_integers_beyond_floats_are_refused():
    assert problems_of(SPUR.replace("omega = 0.5", "omega = 1" + "0" * 400))[0].path == "dimensionless.omega"


PATHS = sorted({path for kind in GEAR_KINDS for path in (*quantities(kind), *choices(kind))})
junk = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=12)
    | st.dates()
    | st.sampled_from(["4 mm", "3 kg", "0.1", "1e8 N/m", "20 deg", "100 rpm", "nan mm", "base", 0.5, 12])
    | st.just(datetime.time(1, 2)),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from(["value", "provenance", "reason", "x"]), inner, max_size=3)
    ),
    max_leaves=6,
)


@settings(max_examples=150)
@given(
    st.sampled_from([*KINDS, "spur", 3]),
    st.dictionaries(st.sampled_from([*PATHS, "mesh.x", "foo.bar", "source.doi"]), junk, max_size=12),
    st.dictionaries(
        st.sampled_from([*PATHS, "D", "omega", "mass", "", "."]) | st.text(max_size=6), junk, max_size=3
    ),
)
def test_garbage_in_the_right_places_never_crashes_the_loader(kind, values, overrides):
    raw: dict = {"kind": kind}
    for path, value in values.items():
        table, leaf = path.split(".")
        raw.setdefault(table, {})[leaf] = value
    try:
        from_tables(raw, overrides)
    except CaseError as error:
        assert error.problems  # noqa: PT017 - either outcome is right; a refusal must say why


@settings(max_examples=100)
@given(st.text(max_size=200))
def test_any_text_at_all_never_crashes_the_loader(text):
    with pytest.raises(CaseError):
        loads(text)


@settings(max_examples=60)
@given(st.data())
def test_a_damaged_case_file_never_crashes_the_loader(data):
    start = data.draw(st.integers(0, len(HELICAL) - 1))
    length = data.draw(st.integers(0, 12))
    damaged = HELICAL[:start] + data.draw(st.text(max_size=6)) + HELICAL[start + length :]
    try:
        loads(damaged)
    except CaseError as error:
        assert error.problems  # noqa: PT017 - either outcome is right; a refusal must say why


def test_the_json_schema_names_every_place_and_describes_it():
    found = schema()
    definitions = found["$defs"]
    assert isinstance(definitions, dict)
    for kind in GEAR_KINDS:
        for path, place in {**quantities(kind), **choices(kind)}.items():
            table, _, leaf = path.partition(".")
            (model,) = (d for d in definitions.values() if d["title"] == f"{kind} {table}")
            assert model["properties"][leaf]["description"] == place.description


@pytest.mark.parametrize("name", [name for name in bundled() if load(name).kind in GEAR_KINDS])
def test_bundled_files_hold_only_what_the_schema_names(name):
    definitions = schema()["$defs"]
    assert isinstance(definitions, dict)
    raw = tomllib.loads(source_text(name)[1])
    for table, content in raw.items():
        if isinstance(content, dict) and table != "source":
            (model,) = (d for d in definitions.values() if d["title"] == f"{raw['kind']} {table}")
            assert set(content) <= set(model["properties"])
