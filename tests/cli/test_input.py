"""Input that cannot be used: every problem at once, the nearest name, exit code 2, no traceback."""

from __future__ import annotations

from pathlib import Path

import pytest

from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema


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
    ("sweep", "article", "--over", "pinion_speed=1000:6000rpm:9"): "a rotational speed with its unit",
    (
        "sweep",
        "article",
        "--over",
        "omega=0.5:1:9",
        "--set",
        "pinion_speed=3600rpm",
    ): "--set pinion_speed=3600rpm",
    ("sweep", "article", "--over", "teeth=20:30:9"): "pinion.teeth",
    ("graze", "article", "--over", "speed"): "'pinion_speed'",
    ("graze", "article", "--over", "backlash", "--near", "1 kg"): "a length with its unit",
    ("graze", "article", "--near", "1.1", "--set", "omega=1"): "--set omega=1",
    ("zones", "article", "--over", "omega=0.5:1.4:9", "--kind", "quiet"): "impact-free",
    ("reproduce", "kahraman-sing"): "'kahraman-singh'",
}


@pytest.mark.parametrize("arguments", BAD, ids=" ".join)
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
