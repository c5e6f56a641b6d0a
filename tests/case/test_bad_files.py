"""Bad input, one kind a row: each is named with its path, its value, what is expected, the nearest name."""

import tomllib

import pytest

from case.corpus import BAD_FILES, HELICAL, SPUR, Bad
from gearlash.case import CaseError, bundled, load, loads, schema
from gearlash.case.kinds import kind_named, kinds
from gearlash.case.read import source_text


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


def test_the_corpus_of_bad_files_does_not_shrink():
    assert len({bad.kind for bad in BAD_FILES}) == len({bad.text for bad in BAD_FILES}) == len(BAD_FILES)
    assert len(BAD_FILES) >= 143


@pytest.mark.parametrize("bad", BAD_FILES, ids=[bad.kind for bad in BAD_FILES])
def test_every_kind_is_named_with_path_value_expectation_and_nearest_name(bad: Bad):
    found = {p.path.partition(",")[0]: p for p in problems_of(bad.text)}
    assert bad.path in found
    problem = found[bad.path]
    assert (problem.value is None) == (bad.value is None)
    assert (bad.value or "") in (problem.value or "")
    assert bad.expected in problem.expected
    assert problem.nearest == bad.nearest
    assert "\x1b" not in (problem.value or "") + problem.expected


def test_ten_errors_are_ten_problems():
    changes = [
        ('"4 mm"', '"4 kg"'),
        ('"20 deg"', "20"),
        ("teeth = 28", "teeth = 2.5"),
        ('"5.98 kg"', '"nan kg"'),
        ('"8.0e8 N/m"', '"8.0e8 Nm"'),
        ("backlash", "baklash"),
        ("ripple = 0.3", "ripple = 7"),
        ('"13 um"', '"13 uM"'),
        ("damping_ratio = 0.02", 'damping_ratio = { value = 0.02, provenance = "guessed" }'),
        ('"4000 rpm"', '"60 Hz"'),
    ]
    text = HELICAL
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    found = problems_of(text)
    assert len({p.path for p in found}) == len(found) == 10


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


def test_the_json_schema_names_every_place_and_describes_it():
    found = schema()
    definitions = found["$defs"]
    assert isinstance(definitions, dict)
    for kind in kinds():
        for path, place in kind_named(kind).places.items():
            table, _, leaf = path.partition(".")
            (model,) = (d for d in definitions.values() if d["title"] == f"{kind} {table}")
            assert model["properties"][leaf]["description"] == place.description


@pytest.mark.parametrize("name", [name for name in bundled() if load(name).content.kind.places])
def test_bundled_files_hold_only_what_the_schema_names(name):
    definitions = schema()["$defs"]
    assert isinstance(definitions, dict)
    raw = tomllib.loads(source_text(name)[1])
    for table, content in raw.items():
        if isinstance(content, dict) and table != "source":
            (model,) = (d for d in definitions.values() if d["title"] == f"{raw['kind']} {table}")
            assert set(content) <= set(model["properties"])


@pytest.mark.parametrize("typed", ["hoist", "hoits.toml", "Hoist.TOML"])
def test_a_file_that_is_not_there_has_a_neighbour(tmp_path, monkeypatch, typed: str):
    """By its name without its ending, or one that looks like it; a bundled case else; none out of nothing."""
    (tmp_path / "hoist.toml").write_text(HELICAL)
    monkeypatch.chdir(tmp_path)
    for name in (typed, str(tmp_path / typed)):
        with pytest.raises(CaseError) as caught:
            load(name)
        assert caught.value.problems[0].nearest == "hoist.toml"
    for name, nearest in (("artcle", "article"), ("nowhere/hoist", None), ("..", None)):
        with pytest.raises(CaseError) as caught:
            load(name)
        assert caught.value.problems[0].nearest == nearest
