"""`gearlash check --out`: the answer and, of known teeth, their drawing."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from cli.conftest import Gearlash
from gearlash.case import load
from gearlash.plots.stated_curves import curves_of, notice, stated_curves
from gearlash.system import evaluate

CASES = Path(__file__).parents[1] / "cases"


@pytest.mark.parametrize(
    ("case", "drawn"), [(str(CASES / "drawing.toml"), True), ("article", True), ("kahraman-singh", False)]
)
def test_teeth_that_are_known_are_drawn(gearlash: Gearlash, tmp_path: Path, case: str, drawn: bool):
    ran = gearlash("check", case, "--out", str(tmp_path / "out"), "--json")
    assert ran.code == 0
    kept = json.loads((tmp_path / "out" / "check.json").read_text(encoding="utf-8"))
    assert kept == ran.answer
    for name in ("teeth.svg", "teeth.pdf"):
        assert (tmp_path / "out" / name).exists() == drawn


def test_a_foreign_file_is_not_written_over(gearlash: Gearlash, tmp_path: Path):
    (tmp_path / "teeth.svg").write_text("mine", encoding="utf-8")
    ran = gearlash("check", "article", "--out", str(tmp_path))
    assert ran.code == 2
    assert (tmp_path / "teeth.svg").read_text(encoding="utf-8") == "mine"


def test_stated_curves_are_drawn_over_their_points(gearlash: Gearlash, tmp_path: Path):
    text = (CASES / "drawing.toml").read_text(encoding="utf-8")
    stated = '\n[curves.error]\npoints = [[0, -3.2], [0.25, 1.1], [0.5, 3.0], [0.75, 0.4]]\nunit = "um"\n'
    (tmp_path / "own.toml").write_text(text + stated, encoding="utf-8")
    ran = gearlash("check", str(tmp_path / "own.toml"), "--out", str(tmp_path / "out"))
    assert ran.code == 0
    assert "<svg" in (tmp_path / "out" / "curves.svg").read_text(encoding="utf-8")
    (curve,) = curves_of(load(tmp_path / "own.toml"))
    assert curve.values == pytest.approx([-3.2, 1.1, 3.0, 0.4])
    at = evaluate(curve.series, 2.0 * np.pi * curve.phases)
    assert np.abs(at - curve.values).max() < 0.05 * np.ptp(curve.values)  # a corner is rounded
    assert "% of peak to peak (rms) from the points" in curve.error


def test_a_loaded_error_is_drawn_as_what_is_left_of_it_about_its_mean(gearlash: Gearlash, tmp_path: Path):
    """Without the deflection under the mean load, which is many times the error; and this is said."""
    text = (CASES / "drawing.toml").read_text(encoding="utf-8")
    points = "[[0, -3.2], [0.25, 1.1], [0.5, 3.0], [0.75, 0.4]]"
    stated = f'\n[curves.error]\npoints = {points}\nunit = "um"\nstate = "loaded"\ntorque = "150 N m"\n'
    (tmp_path / "own.toml").write_text(text + stated, encoding="utf-8")
    ran = gearlash("check", str(tmp_path / "own.toml"), "--out", str(tmp_path / "out"))
    assert ran.code == 0
    assert "beside mesh.error" not in " ".join(ran.out.split())
    case = load(tmp_path / "own.toml")
    (curve,) = curves_of(case)
    assert abs(curve.series[0]) < 1e-12
    at = evaluate(curve.series, 2.0 * np.pi * curve.phases)
    assert np.abs(at - curve.values).max() < 0.05 * np.ptp(curve.values)
    assert np.ptp(evaluate(curve.series, np.linspace(0.0, 2.0 * np.pi, 720))) < 3.0 * 6.2
    panel = stated_curves([curve]).axes[0]
    assert "left of stated points" in panel.get_legend_handles_labels()[1]
    assert "and the mean, are taken off" in notice([curve])
