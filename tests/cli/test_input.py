"""Input that cannot be used: every problem at once, the nearest name, exit code 2, no traceback."""

from __future__ import annotations

from pathlib import Path

import pytest

from case.corpus import BAD_FILES, Bad
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.case import CaseError, load
from gearlash.cli.inputs import read_over
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema

CASES = Path(__file__).parents[1] / "cases"


def test_all_problems_of_file_and_overrides_at_once(gearlash: Gearlash, tmp_path: Path):
    path = tmp_path / "bad.toml"
    path.write_text(
        'kind = "spur-1dof"\n[dimensionless]\nomga = 0.5\nD = "4 kg"\nload = 0.1\nmesh_damping = 0.05\n',
        encoding="utf-8",
    )
    ran = gearlash(
        "run", str(path), "--set", "load=many", "--set", "eror=1", "--set", "ripple", "--set", "error=nan"
    )
    assert ran.code == 2
    assert ran.out == ""
    for part in (
        "omga",
        "'dimensionless.omega'",
        "D = '4 kg'",
        "'many'",
        "'error'",
        "'ripple'",
        "error = 'nan'",
    ):
        assert part in ran.complaint, part
    assert "Traceback" not in ran.err


def test_problems_as_json(gearlash: Gearlash):
    ran = gearlash("run", "article", "--set", "omga=1", "--set", "D=1 rpm", "--json")
    assert ran.code == 2
    assert problems(ran.answer, answer_schema(answer_kind("problem"))) == []
    assert {p["path"]: p["nearest"] for p in ran.answer["problems"]} == {"omga": "omega", "D": None}
    assert " ".join(ran.answer["message"].split()) in ran.complaint


BAD = {
    ("run", "artcle"): "'article'",
    ("run", "article", "--set", "omega"): "NAME=VALUE",
    ("run", "article", "--set", "omega=1", "--set", "omega=2"): "omega = '1' and omega = '2'",
    (
        "run",
        "article",
        "--set",
        "omega=1",
        "--set",
        "pinion_speed=3600rpm",
    ): "one of two that name the same quantity",
    ("run", "article", "--initial", "Xp=1"): "'X'",
    ("run", "article", "--initial", "X=inf"): "a finite number",
    ("run", "article", "--initial", "no-such-file.json"): "the JSON of an earlier run",
    ("run", "article", "--periods", "0"): "--periods",
    ("sweep", "article", "--over", "omega=0.5:1.4"): "NAME=FROM:TO:COUNT",
    ("sweep", "article", "--over", "omega=1.4:0.5:9"): "--down",
    ("sweep", "article", "--over", "omega=0.5:1.4:1"): "number of points",
    ("sweep", "article", "--over", "omega=0.5:1.4:²"): "number of points",
    ("sweep", "article", "--over", "omgea=0.5:1.4:9"): "'omega'",
    ("sweep", "article", "--over", "pinion_speed=1000rpm:6000:9"): "a rotational speed with its unit",
    ("sweep", "article", "--over", "D=1:2um:9"): "D = '2um'",  # what was typed, not the unit lent to 1
    ("map", "article", "--over", "omega=1:2:1e3", "--over", "D=1:2:0"): "--over D = '0'",
    (
        "sweep",
        "article",
        "--over",
        "omega=0.5:1:9",
        "--set",
        "pinion_speed=3600rpm",
    ): "--set pinion_speed=3600rpm",
    ("sweep", "article", "--over", "teeth=20:30:9"): "pinion.teeth",
    ("branch", "article"): "--over: expected NAME=FROM:TO",
    ("branch", "article", "--over", "omega=0.5:1.4:90"): "without a number of points",
    ("branch", "article", "--over", "omega=1.4:0.5"): "a rising interval",
    ("branch", "article", "--over", "omgea=0.5:1.4"): "'omega'",
    ("branch", "article", "--over", "pinion_speed=3000:3800rpm"): "the value to begin at, 4000 rpm",
    ("branch", "article", "--over", "omega=1:1.1", "--switch", "some"): "--switch = 'some'",
    ("branch", "article", "--over", "omega=1:1.1", "--at", "2"): "--resume FILE",
    ("branch", "article", "--resume", "no-such-file.json"): "No such file",
    ("branch", "article", "--resume", "none.json", "--near", "1", "--initial", "X=1"): "--initial",
    ("graze", "article", "--over", "speed"): "'pinion_speed'",
    ("graze", "article", "--over", "backlash", "--near", "1 kg"): "a length with its unit",
    ("graze", "article", "--near", "1.1", "--set", "omega=1"): "--set omega=1",
    ("zones", "article", "--over", "omega=0.5:1.4:9", "--kind", "quiet"): "impact-free",
    ("reproduce", "kahraman-sing"): "'kahraman-singh'",
    ("check", "ARTICLE"): "'article'",
    ("check", "."): "directory",
    ("check", ""): "directory",
    ("check", "bad\0name"): "a case file that can be read",
    ("check", "n" * 4000): "a case file that can be read",
    ("check", "../../../etc/no-such-file"): "No such file",
    ("check", "article", "--set", ""): "NAME=VALUE",
    ("check", "article", "--set", "=1"): "NAME=VALUE",
    ("check", "article", "--set", "omega="): "NAME=VALUE",
    ("check", "article", "--set", "omega==1"): "does not start with a number",
    ("check", "article", "--set", "omega=-1"): "above 0",
    ("check", "article", "--set", "omega=0"): "above 0",
    ("check", "article", "--set", "OMEGA=1"): "'omega'",
    ("check", "article", "--set", "ripple_1=0.1"): "'ripple'",
    ("check", "article", "--set", "D=1 mm"): "a number without unit",
    ("check", "article", "--set", "D=1e999"): "too large to be a number",
    ("check", "article", "--set", "D=0x1"): "no unit",
    ("check", "article", "--set", "D=1;"): "no unit",
    ("check", "article", "--set", "D=$(id)"): "does not start with a number",
    ("check", "article", "--set", "D=0.8", "--set", "backlash=80um"): "name the same quantity",
    ("check", "article", "--set", "mass=3kg"): "pinion.mass, gear.mass",
    ("check", "article", "--set", "torque=95mN"): "a torque with its unit",
    ("check", "article", "--set", "pinion_speed=3600"): "a rotational speed with its unit",
    ("check", "article", "--set", "reference_length=40um"): "D_c is settled",
    ("check", "article", "--set", "contact=sometimes"): "one of always",
    ("check", "article", "--set", "ripple=1.9"): "stiffness positive",
    ("check", "article", "--set", "name=x"): "exists here",
    ("check", "article", "--set", "teeth=28"): "pinion.teeth, gear.teeth",
    ("sweep", "article", "--over", ""): "NAME=FROM:TO:COUNT",
    ("sweep", "article", "--over", "omega"): "NAME=FROM:TO:COUNT",
    ("sweep", "article", "--over", "=0.5:1:9"): "exists here",
    ("sweep", "article", "--over", "omega=a:1:9"): "does not start with a number",
    ("sweep", "article", "--over", "omega=0.5:nan:9"): "not a finite number",
    ("sweep", "article", "--over", "omega=0:1:9"): "above 0",
    ("sweep", "article", "--over", "omega=1:1:9"): "a rising interval",
    ("sweep", "article", "--over", "omega=0.5:1:9.5"): "number of points",
    ("sweep", "article", "--over", "omega=0.5:1:-9"): "number of points",
    ("sweep", "article", "--over", "omega=0.5:1:10000000"): "from 2 to 1,000,000",
    ("sweep", "article", "--over", "omega=0.5:1:9:9"): "NAME=FROM:TO:COUNT",
    ("sweep", "article", "--over", "contact=0:1:9"): "unknown parameter to vary",
    ("sweep", "article", "--over", "torque=1N:2N:9"): "a torque with its unit",
    ("sweep", "article", "--over", "mesh_frequency=1rpm:2rpm:9"): "cycles per second",
    ("sweep", "article", "--over", "omega=0.5:1:9", "--workers", "-1"): "--workers",
    ("sweep", "article", "--over", "omega=0.5:1:9", "--workers", "many"): "--workers",
    ("run", "article", "--max-period", "5000"): "--max-period",
    ("run", "article", "--periods", "1.5"): "--periods",
    ("run", "article", "--initial", "X=1", "--initial", "X=2"): "X = '1' and X = '2'",
    ("run", "article", "--initial", "=1"): "NAME=VALUE",
    ("run", "article", "--initial", "."): "the JSON of an earlier run",
    ("run", "article", "--out", "/dev/null/here"): "cannot be written",
    ("run", "article", "--out", "/dev/null"): "cannot be written",
    ("schema", "--result", "swep"): "'sweep'",
    ("sweeep", "article"): "sweep",
    ("run", "article", "--jsn"): "--json",
    ("run",): "CASE",
}


def test_the_corpus_of_bad_commands_does_not_shrink():
    assert len(BAD) >= 75


@pytest.mark.parametrize("bad", BAD_FILES, ids=[bad.kind for bad in BAD_FILES])
def test_every_kind_of_bad_file_ends_with_code_2(bad: Bad, gearlash: Gearlash, tmp_path: Path):
    path = tmp_path / "bad.toml"
    path.write_text(bad.text, encoding="utf-8")
    ran = gearlash("check", str(path))
    assert (ran.code, ran.out) == (2, "")
    assert " ".join(bad.expected.split()) in ran.complaint
    assert "Traceback" not in ran.err
    assert "\x1b" not in ran.err


@pytest.mark.parametrize("arguments", BAD, ids=lambda arguments: " ".join(arguments)[:80])
def test_each_is_refused_with_what_to_type_instead(arguments: tuple[str, ...], gearlash: Gearlash):
    ran = gearlash(*arguments)
    assert ran.code == 2
    assert ran.out == ""
    assert BAD[arguments] in ran.complaint
    assert "Traceback" not in ran.err


def test_a_state_of_another_model_is_refused(gearlash: Gearlash, tmp_path: Path):
    path = tmp_path / "run.json"
    path.write_text('{"state": {"X": 1.0, "X\'": 0.0}}', encoding="utf-8")
    assert gearlash("run", "kahraman-singh", "--initial", str(path)).code == 0
    ran = gearlash("run", "article", "--initial", str(path))
    assert ran.code == 2
    assert "Y_p" in ran.err


def test_a_falling_interval_is_advised_on_only_where_it_can_be_followed(gearlash: Gearlash):
    for command in ("zones", "report"):
        ran = gearlash(command, "article", "--over", "omega=1.4:0.5:9")
        assert ran.code == 2
        assert "a rising interval FROM < TO" in ran.err
        assert "--down" not in ran.err


@pytest.mark.parametrize(
    ("over", "example"),
    [
        ("backlash=20um:60um", "backlash=50:150um:500"),
        ("D=1", "D=0.5:1.5:500"),
        ("torque=100", "torque=48.5:145N*m:500"),
        ("pinion_speed", "pinion_speed=2000:6000rpm:500"),
        ("nothing=1", "omega=0.5:1.4:900"),
    ],
)
def test_an_interval_in_a_wrong_form_is_shown_one_of_the_quantity_that_was_named(over: str, example: str):
    """Not one of speed, whatever was asked; what is shown can be typed."""
    case = load("article")
    with pytest.raises(CaseError) as refused:
        read_over(case, over)
    (problem,) = refused.value.problems
    assert f"such as {example}" in problem.expected
    assert len(read_over(case, example.partition(" ")[0]).values) in (500, 900)


@pytest.mark.parametrize(
    ("typed", "instead"),
    [
        (("run", "article", "--set", "pinion_speed", "3600rpm"), "--set pinion_speed=3600rpm"),
        (("run", "article", "--set", "pinion_speed=3600", "rpm"), "--set 'pinion_speed=3600 rpm'"),
        (("run", "article", "--set", "D", "=", "0.7", "--json"), "--set D=0.7"),
        (("run", "article", "--set", "torque", "150", "N", "m"), "--set 'torque=150 N m'"),
        (("run", "article", "--set", "torque", "150", "Nm", "b.toml"), "--set 'torque=150 Nm'"),
        (
            ("sweep", "article", "--over", "pinion_speed", "1000:6000rpm:5"),
            "--over pinion_speed=1000:6000rpm:5",
        ),
        (("run", "article", "--set", "gear.material", "cast", "iron"), "--set 'gear.material=cast iron'"),
        (("new", "x.toml", "--helix-angle", "15°", "LH"), "--helix-angle '15° LH'"),
        (("new", "x.toml", "--material", "cast", "iron", "--teeth", "9/9"), "--material 'cast iron'"),
        (("run", "article", "--set", "torque=150", "Nm", "more"), "--set 'torque=150 Nm'"),
        (("new", "x.toml", "--teeth", "25", "57"), "--teeth 25/57"),
        (("new", "--teeth", "25", "/", "57", "x.toml"), "--teeth '25 / 57'"),
        (("new", "--teeth", "25/57", "--torque", "150", "Nm"), "--torque '150 Nm'"),
        (("new", "x.toml", "--profile-shift", "0.3", "/", "-0.1"), "--profile-shift '0.3 / -0.1'"),
        (("new", "x.toml", "--bore", "30", "mm", "/", "50", "mm"), "--bore '30 mm / 50 mm'"),
        (("new", "--helix-angle", "15", "deg", "LH", "x.toml"), "--helix-angle '15 deg LH'"),
        (("run", "--set", "torque", "150", "Nm", "b.toml"), "--set 'torque=150 Nm'"),
        (("run", "--set", "torque=150", "Nm", "b.toml"), "--set 'torque=150 Nm'"),
        (
            ("sweep", "--over", "pinion_speed", "2100", "6300rpm", "21", "b.toml"),
            "--over pinion_speed=2100:6300rpm:21",
        ),
        (("new", "x.toml", "--torque", "150", "N", "m", "more"), "--torque '150 N m'"),
        (("new", "x.toml", "--bore", "1", "1/4", "in"), "--bore '1 1/4 in'"),
        (("new", "x.toml", "--fit", "25", "cd"), "--fit '25 cd'"),
        (("graze", "article", "--near", "3600", "rpm"), "--near '3600 rpm'"),
        (("new", "x.toml", "--torque", "150", "N", "m", "--speed", "900rpm"), "--torque '150 N m'"),
        (("new", "x.toml", "--backlash", "0.06", "to", "0.14", "mm"), "--backlash '0.06 to 0.14 mm'"),
        (("new", "x.toml", "--backlash", "0.06", "-", "0.14", "mm"), "--backlash '0.06 - 0.14 mm'"),
        (("new", "x.toml", "--backlash", "0.1", "mm", "+0.04/-0.04"), "--backlash '0.1 mm +0.04/-0.04'"),
        (("new", "x.toml", "--span", "32.83", "-0.05/-0.08", "mm"), "--span '32.83 -0.05/-0.08 mm'"),
    ],
)
def test_words_left_over_are_given_back_to_their_option(
    gearlash: Gearlash, typed: tuple[str, ...], instead: str
):
    ran = gearlash(*typed)
    assert ran.code == 2
    between = "=" in instead and not any("=" in word for word in typed)
    how = "takes a name, a = and a value in one word" if between else "takes one word"
    assert f"{how}: {instead}" in " ".join(ran.err.split())


def test_names_that_begin_as_negative_numbers_stand_behind_two_dashes(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    Path("-5.toml").write_text((CASES / "drive.toml").read_text())
    assert gearlash("check", "--", "-5.toml").code == 0
    assert gearlash("check", "-5.toml").code == 2


@pytest.mark.parametrize(
    "typed",
    [
        ("run", "article", "more"),
        ("run", "--json", "article", "more"),
        ("run", "article", "--set", "D=0.7", "more"),
        ("run", "article", "--set", "D=0.7", "more.toml"),
        ("run", "article", "--set", "torque=150 Nm", "two-stage"),
        ("run", "article", "--set", "pinion", "material", "steel"),
        ("run", "article", "--max-period", "4", "more"),
        ("new", "x.toml", "--torque", "150Nm", "more"),
        ("new", "x.toml", "--torque", "150Nm", "160Nm"),
    ],
)
def test_other_words_left_over_are_refused_alone(gearlash: Gearlash, typed: tuple[str, ...]):
    ran = gearlash(*typed)
    assert ran.code == 2
    assert f"{typed[-1]})" in ran.err
    assert "unexpected extra argument(s) (" in " ".join(ran.err.split())
    assert "one word" not in ran.err
