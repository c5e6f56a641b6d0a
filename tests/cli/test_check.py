"""gearlash check."""

from __future__ import annotations

from pathlib import Path

import pytest

from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.case import bundled, load, loads
from gearlash.case.rating import band_of_grades, method_b
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema
from gearlash.gears.unloaded_error import unloaded_error


@pytest.mark.parametrize("name", bundled())
def test_json_holds_every_value(name: str, gearlash: Gearlash):
    ran = gearlash("check", name, "--json")
    assert ran.code == 0
    assert problems(ran.answer, answer_schema(answer_kind("check"))) == []
    case = load(name)
    assert [v["path"] for v in ran.answer["values"]] == [v.path for v in case.values()]
    assert ran.answer["hash"] == case.hash
    assert ran.answer["parameters"] == case.family()[0].defaults
    assert len(ran.answer["notes"]) == len(case.notes())


@pytest.mark.parametrize("columns", ["60", "80", "120", "200"])
def test_every_value_is_shown_once_at_any_width(
    columns: str, gearlash: Gearlash, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setenv("COLUMNS", columns)
    lines = gearlash("check", "article").out.splitlines()
    first_words = [line.split()[0] for line in lines if line.startswith("  ") and line.split()]
    for value in load("article").values():
        if "natural_frequency" not in value.path and "critical_speed" not in value.path:
            assert first_words.count(value.path) == 1, value.path
    assert all(line == line.rstrip() for line in lines)
    if int(columns) >= 80:
        assert max(map(len, lines)) <= int(columns)


def test_assumed_values_and_what_rests_on_them_are_told_apart(gearlash: Gearlash):
    lines = {line.split()[0]: line for line in gearlash("check", "article").out.splitlines() if line.split()}
    assert "†" in lines["derived.force_unit"]
    assert "†" not in lines["derived.omega_n"]
    text = " ".join(gearlash("check", "article").out.split())
    assert "assumed: not stated; a usual normal backlash" in text
    assert "4.3 times stiffer" in text
    assert "1 0.2693029 480.0737 Hz 1028.729 rpm" in text


def test_overrides_are_shown(gearlash: Gearlash):
    answer = gearlash("check", "article", "--set", "backlash=60um", "--json").answer
    assert answer["parameters"]["D"] == pytest.approx(0.6, rel=1e-14)
    by_path = {v["path"]: v for v in answer["values"]}
    assert by_path["model.reference_length"]["value"] == 50.0
    assert by_path["dimensionless.D"]["rests_on"] == ["model.reference_length"]


def test_k_v_of_the_standard_stands_beside_the_case(gearlash: Gearlash):
    """Where there are gears in physical units; why there is none where the case does not say enough."""
    drawn = Path(__file__).resolve().parents[1] / "cases" / "drawing.toml"
    case = load(drawn)
    said = gearlash("check", str(drawn), "--json").answer["dynamic_factor"]
    assert said == band_of_grades(case, case.family()[0].defaults["omega"])
    assert "for grade 7 of ISO 1328-1, assumed for the gear" in said
    assert said in " ".join(gearlash("check", str(drawn)).out.split())
    assert gearlash("check", "kahraman-singh", "--json").answer["dynamic_factor"] == ""


def test_teeth_of_both_gears_stand_side_by_side(gearlash: Gearlash):
    """Each dimension once, in one line, and the numbers of the JSON."""
    drawn = str(Path(__file__).resolve().parents[1] / "cases" / "drawing.toml")
    values = {v["path"]: v["value"] for v in gearlash("check", drawn, "--json").answer["values"]}
    lines = gearlash("check", drawn).out.splitlines()
    for leaf, told in (("tip_diameter", "tip diameter d_a, mm"), ("span", "span measurement W_k, mm"),
                       ("working_diameter", "working pitch diameter d_w, mm")):  # fmt: skip
        (line,) = [line for line in lines if line.strip().startswith(told)]
        shown = [float(cell) for cell in line.replace(told, "").replace("†", "").split()]
        pair = [values[f"derived.{leaf}_{gear}"] for gear in ("pinion", "gear")]
        assert shown == pytest.approx(pair, rel=1e-6)
        assert not any(f"derived.{leaf}_" in line for line in lines)
    assert any("N/(mm·µm)" in line for line in lines)


@pytest.mark.parametrize(
    ("stated", "assumed", "told"),
    [
        (("pinion",), ("gear",), "grade 7 of ISO 1328-1, assumed for the gear; "),
        (("gear",), ("pinion",), "grade 7 of ISO 1328-1, assumed for the pinion; "),
        ((), ("pinion", "gear"), "grade 8 of ISO 1328-1, assumed for both gears; "),
        (("pinion", "gear"), (), "grade 7 of ISO 1328-1 (K_A"),
    ],
)
def test_a_grade_that_nobody_states_is_one_assumed_value(
    stated: tuple[str, ...], assumed: tuple[str, ...], told: str
):
    """Error and K_v are those of it, and their ranges go over finer and coarser classes of that gear."""
    drawn = Path(__file__).resolve().parents[1] / "cases" / "drawing.toml"
    text = drawn.read_text(encoding="utf-8").replace("quality = 7\n", "")
    for gear in stated:
        text = text.replace(f"[{gear}]\n", f"[{gear}]\nquality = 7\n")
    case = loads(text)
    values = {v.path: v for v in case.values()}
    for gear in assumed:
        value = values[f"{gear}.quality"]
        assert (value.provenance, value.value) == ("assumed", 7 if stated else 8)
        assert f"classes {int(value.value) - 2} to {int(value.value) + 2}" in value.reason
    said = band_of_grades(case, case.family()[0].defaults["omega"])
    assert told in said
    own = int(values["pinion.quality"].value)
    ends = [(own - by * ("pinion" in assumed), own - by * ("gear" in assumed)) for by in (2, 0, -2)]
    fine, mean, coarse = (method_b(case, case.family()[0].defaults["omega"], each).value for each in ends)
    assert f"K_v = {mean:.2f} for grade {own}" in said
    if assumed:
        assert f"{fine:.2f} for grade" in said
        assert f"{coarse:.2f} for grade" in said
    limits = unloaded_error(case.numbers.body.meshing, ends[2]).mesh
    assert values["mesh.error"].greatest == pytest.approx(1e6 * limits.greatest)
    usual = unloaded_error(case.numbers.body.meshing, ends[1]).mesh
    assert values["mesh.error"].value == pytest.approx(1e6 * usual.nominal)
