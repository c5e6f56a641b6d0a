"""Texts that somebody else wrote reach terminals, JSON, NetCDF, figures and folders, and do nothing there."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from matplotlib.figure import Figure

import gearlash as gl
from case.corpus import SPUR
from cli.conftest import Gearlash
from gearlash.cli.terminal import harmless
from gearlash.plots.words import ANY

HOSTILE = [
    "<script>alert(1)</script>",
    '"; rm -rf ~ #',
    "$(reboot) `id` %PATH%",
    "../../../x",
    "CON",
    "a/b\\c:d*e?",
    r"$\frac{",
    "$x$ and $y$",
    "[bold red]x[/bold] [link=http://x]y[/link] :smile:",
    "{{ 7 * 7 }} {% raw %} %s {0}",
    "emoji 🦷⚙️ zero\u200bwidth עברית",
    "n" * 200,
    "-rf",
    "' OR 1=1 --",
]
STEERING = [
    "\x1b[31mred",
    "\x1b]0;title\x07",
    "\x9b2J",
    "\u202egpj.exe",
    "a\u2066b",
    "bell\x07",
    "a\x00b",
    "x\x7f",
]


def case_named(name: str) -> str:
    """A right case with this text wherever a case takes one."""
    quoted = json.dumps(name, ensure_ascii=False)
    head = f"name = {quoted}\ndescription = {quoted}\n[source]\ntitle = {quoted}\nauthors = [{quoted}]\n"
    ratio = f'damping_ratio = {{ value = 0.05, provenance = "assumed", reason = {quoted} }}'
    return SPUR.replace("[pinion]", head + "[pinion]", 1).replace("damping_ratio = 0.05", ratio)


def written(folder: Path, name: str) -> str:
    path = folder / "case.toml"
    path.write_text(case_named(name), encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("name", HOSTILE)
def test_in_a_terminal_and_in_json_it_is_what_was_written(name: str, gearlash: Gearlash, tmp_path: Path):
    path = written(tmp_path, name)
    ran = gearlash("check", path)
    assert (ran.code, ran.err) == (0, "")
    assert (
        "".join(ran.out.split()).count("".join(name.split())) == 5
    )  # name, description, title, author, reason
    assert not re.search(r"[\x00-\x09\x0b-\x1f\x7f-\x9f]", ran.out)
    answer = gearlash("check", path, "--json").answer
    assert (answer["name"], answer["description"], answer["source"]["title"]) == (name, name, name)
    assert [v["reason"] for v in answer["values"] if v["path"] == "mesh.damping_ratio"] == [name]


@pytest.mark.parametrize("text", STEERING)
@pytest.mark.parametrize(
    "place", ["name", "description", "source.title", "source.authors.0", "mesh.damping_ratio"]
)
def test_what_steers_a_terminal_is_refused_wherever_it_stands(
    place: str, text: str, gearlash: Gearlash, tmp_path: Path
):
    path = tmp_path / "case.toml"
    escaped = json.dumps(text).replace("\x7f", "\\u007F")
    path.write_text(case_named("PLAIN").replace('"PLAIN"', escaped), encoding="utf-8")
    ran = gearlash("check", str(path))
    assert (ran.code, ran.out) == (2, "")
    assert f"{place} = " in ran.complaint
    assert harmless(ran.err) == ran.err


@pytest.mark.parametrize("name", [n for n in STEERING if "\0" not in n] + ["\udcff\udcfe"])
def test_names_of_files_do_not_steer_a_terminal_either(name: str, gearlash: Gearlash, tmp_path: Path):
    path = tmp_path / f"{name}.toml"
    path.write_text(SPUR, encoding="utf-8")
    ran = gearlash("check", str(path))
    assert ran.code == 0
    assert harmless(ran.out) == ran.out
    answer = gearlash("check", str(path), "--json")
    assert answer.answer["name"].endswith(name[-1]) or "\ufffd" in answer.answer["name"]
    path.write_text(SPUR.replace("omega", "omga"), encoding="utf-8")
    refused = gearlash("check", str(path), "--json")
    assert refused.code == 2
    for text in (answer.out, refused.out, refused.err):
        assert harmless(text) == text
    assert json.loads(refused.out)["message"].startswith(str(path))


@pytest.mark.parametrize("sign", [chr(code) for code in (*range(9), *range(11, 32), *range(127, 160))])
def test_every_control_character_is_shown_as_a_sign(sign: str):
    shown = harmless(f"a{sign}b")
    assert len(shown) == 3
    assert shown.isprintable()


def test_a_folder_holds_the_names_of_the_program_and_no_other(gearlash: Gearlash, tmp_path: Path):
    name = HOSTILE[3] + HOSTILE[6] + HOSTILE[0] + "🦷"
    out = tmp_path / "deep" / "out"
    over = ("--over", "omega=0.5:0.52:3", "--cold", "--set", "load=0.1", "--set", "error=0.05")
    ran = gearlash("sweep", written(tmp_path, name), *over, "--out", str(out), "--json")
    assert ran.code == 0
    assert sorted(path.name for path in out.iterdir()) == [
        ".gearlash.json",
        "sweep.json",
        "sweep.nc",
        "sweep.pdf",
        "sweep.svg",
    ]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["case.toml", "deep"]
    dataset = gl.load_dataset(out / "sweep.nc")
    assert dataset.attrs["case_name"] == name
    assert json.loads((out / "sweep.json").read_text(encoding="utf-8"))["case"]["name"] == name
    assert "<script" not in (out / "sweep.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", [name for name in HOSTILE if name.isascii()])
def test_a_parameter_of_that_name_is_drawn_letter_by_letter(name: str):
    def width(text: str, formulas: bool) -> float:
        figure = Figure(dpi=100)
        label = figure.text(0.0, 0.0, text, parse_math=formulas, family="DejaVu Sans")
        figure.draw_without_rendering()
        return label.get_window_extent().width

    assert width(ANY.name(name), True) == width(name.replace("_", " "), False) > 0.0


def test_the_program_starts_no_shell():
    sources = (Path(gl.__file__).parent).rglob("*.py")
    found = [p.name for p in sources if re.search(r"os\.system|shell=True|popen", p.read_text("utf-8"))]
    assert found == []
