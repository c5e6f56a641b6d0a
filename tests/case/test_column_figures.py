"""What the head of a column says of its unit and of the figure that was taken of the signal."""

from __future__ import annotations

from pathlib import Path

import pytest

import gearlash as gl
from gearlash.case.column_figures import figure_in
from gearlash.case.columns import parse_columns


@pytest.mark.parametrize(
    ("head", "unit", "figure"),
    [
        ("TE [µm]", "µm", ""),
        ("TE (um)", "um", ""),
        ("TE in µm", "µm", ""),
        ("TE [µm peak-to-peak]", "µm", "peak-to-peak"),
        ("TE [µm] pp", "µm", "peak-to-peak"),
        ("TE p-p (um)", "um", "peak-to-peak"),
        ("TE rms [um]", "um", "rms"),
        ("TE eff. [µm]", "µm", "rms"),
        ("Spitze-Spitze in µm", "µm", "peak-to-peak"),
        ("Mittelwert [µm]", "µm", "mean"),
        ("peak force [N]", "N", "peak"),
        ("TE [dB re 1 µm]", "dB re 1 µm", ""),
        ("slope [um]", "um", ""),
        ("Approach [um]", "um", ""),
    ],
)
def test_unit_and_figure(head: str, unit: str, figure: str):
    found = parse_columns(f"n [rpm];{head}\n1000;1,5\n1100;2,5\n1200;#NV\n")
    assert found.units == ("rpm", unit)
    assert figure_in(found.names[1]) == figure
    assert found.column(1)[:2] == [1.5, 2.5]


def test_a_footer_is_left_out_and_counted(tmp_path: Path):
    case, path = gl.load_case("article"), tmp_path / "run.csv"
    path.write_text("n [rpm];TE [um]\n1000;1,5\n1100;2,5\nMittelwert;2,0\nMaximum;2,5\n")
    found = gl.load_measurement(case, path, "gap")
    assert (found.omega * found.speed_factor).tolist() == pytest.approx([1000.0, 1100.0])
    assert found.left_out == 2
    path.write_text("n [rpm];TE [um]\n1000;1,5\nMittelwert;2,0\n1100;2,5\n")
    with pytest.raises(gl.CaseError, match="line 3 has no number in column 'n'"):
        gl.load_measurement(case, path, "gap")


def test_speeds_are_above_zero():
    with pytest.raises(gl.CaseError, match="above zero"):
        gl.measurement(
            gl.load_case("article"), [-1000.0, 1000.0], [1.0, 2.0], "gap", speed_unit="rpm", unit="um"
        )
