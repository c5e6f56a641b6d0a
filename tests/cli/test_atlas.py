"""gearlash atlas: its answer against its schema, its words, its units, and its files."""

from __future__ import annotations

import json
import threading
from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.cli.answers.atlas import atlas_answer
from gearlash.cli.atlas_files import write_atlas
from gearlash.cli.folder import claim
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema
from gearlash.cli.show.atlas import atlas_view

DRIVE = Path(__file__).resolve().parents[1] / "cases" / "drive.toml"
SMALL = ("--over", "omega=0.81:0.83:2", "--over", "D=0.9:1.1:2", "--lines", "1", "--workers", "1")
SPEED = ("--over", "pinion_speed=3600:3800rpm:2", "--over", "torque=140:160N*m:2")


@pytest.mark.slow
def test_the_answer_fits_its_schema_and_the_files_begin_curves_again(gearlash: Gearlash, tmp_path: Path):
    ran = gearlash("atlas", "kahraman-singh", *SMALL, "--json", "--out", str(tmp_path))
    answer = ran.answer
    assert ran.code == 0
    assert problems(answer, answer_schema(answer_kind("atlas"))) == []
    assert [curve["kind"] for curve in answer["curves"]] == ["grazing", "fold"]
    assert answer["curves"][0]["straight"][0]["value"] == pytest.approx(0.820631087712, abs=1e-10)
    assert answer["changes"]["curve"] == 2
    assert answer["not_explained"] == []
    assert json.loads((tmp_path / "atlas.json").read_text()) == answer
    kept = gl.load_curve(tmp_path / "curve-2.json")
    assert kept.kind is gl.SpecialKind.FOLD
    start, low, high = kept.points[len(kept.points) // 2], kept.lower, kept.upper
    case = gl.load_case("kahraman-singh")
    again = gl.continue_curve(
        case, kept.names, start, kind=kept.kind, values=kept.values, lower=low, upper=high
    )
    ends = [sorted((end.values for end in each.ends), key=lambda at: at[1]) for each in (kept, again)]
    assert np.abs(np.subtract(ends[0], ends[1])).max() < 1e-10
    dataset = gl.load_dataset(tmp_path / "atlas.nc")
    assert set(dataset["curve"].values.tolist()) == {1, 2}
    assert {"atlas.svg", "atlas.pdf"} <= {path.name for path in tmp_path.iterdir()}


def test_in_words(gearlash: Gearlash):
    ran = gearlash("atlas", "kahraman-singh", *SMALL)
    words = " ".join(ran.out.split())
    assert (ran.code, ran.err) == (0, "")
    assert words.startswith(
        "omega from 0.81 to 0.83 and D from 0.9 to 1.1: 2 curves found (1 of kind fold, 1 of kind grazing); "
        "0 points where two things happen at once; changes of motion between neighbouring pixels of the map "
        "unexplained: 0 of 2"
    )
    assert "straight: omega = 0.82063109 for D from 0.9 to 1.1" in words
    assert "2 a curve of these motions lies between the two pixels" in words


def test_what_is_left_undone_is_told(gearlash: Gearlash):
    words = " ".join(gearlash("atlas", "kahraman-singh", *SMALL, "--curves", "1").out.split())
    assert "the budget of 1 curve was spent" in words
    assert "omega = 0.828464, D = 1" in words


@pytest.mark.parametrize(
    ("over", "expected"),
    [
        (("omega=0.5:1.4",), "two of them"),
        (("omega=0.5:1.4", "pinion_speed=3000:4000rpm"), "do not name the same quantity"),
        (("omega=0.5:1.4:1", "D=0.2:1"), "a number of points from 2"),
        (("omega=1.4:0.5", "D=0.2:1"), "a rising interval"),
        (("omega", "D=0.2:1"), "NAME=FROM:TO"),
    ],
)
def test_axes_that_do_not_fit_are_refused(gearlash: Gearlash, over: tuple[str, ...], expected: str):
    ran = gearlash("atlas", "article", *(part for each in over for part in ("--over", each)))
    assert ran.code == 2
    assert expected in ran.complaint


def test_an_atlas_that_was_stopped_says_where_and_explains_no_change_that_was_not_looked_at(
    gearlash: Gearlash, tmp_path: Path
):
    case = gl.load_case("kahraman-singh")
    x, y = gl.Axis.even("omega", 0.65, 0.85, 5), gl.Axis.even("D", 0.5, 1.1, 3)
    stop = threading.Event()

    def hear(progress: gl.Progress) -> None:
        if progress.done == progress.total == len(x) * len(y):  # the map
            stop.set()

    found = gl.atlas(case, x, y, lines=1, execution=gl.Execution(progress=hear, cancel=stop))
    stopped = "incomplete (cancelled): stopped in motions along lines; done by then: the map"
    answer = atlas_answer(case, found.values, ("omega", "D"), ("", ""), found, 60)
    assert answer.sentence.split(": ", 1)[1] == f"{stopped}; no curve was followed to its end by then"
    assert answer.not_explained == ()
    assert "nothing that was found" not in " ".join(str(line) for line in atlas_view(answer, 100))
    folder = claim(tmp_path / "out", ["atlas.nc", "atlas.json", "atlas.svg", "atlas.pdf"])
    write_atlas(folder, case, found, answer)
    assert (tmp_path / "out" / "atlas.svg").exists()


def test_in_the_unit_that_was_asked_what_rests_on_assumed_values_has_a_mark_and_limits_have_none(
    gearlash: Gearlash,
):
    over = ("--over", "pinion_speed=3750:4150rpm:2", "--over", "backlash=60:100um:2", "--lines", "1")
    words = " ".join(gearlash("atlas", str(DRIVE), *over, "--curves", "2").out.split())
    assert "rpm † for backlash from 60 to 100 µm" in words
    assert "100 µm †" not in words
    assert "† rests on assumed values: model.body" in words
    assert "motion: P-Q-R of the orbits of a curve in order" in words
