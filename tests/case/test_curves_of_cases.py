"""Stiffness and error as they come: points, files, rectangles, harmonics by the dozen, turns of shafts."""

from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from gearlash.case import loads
from gearlash.case.columns import parse_columns, read_columns
from gearlash.case.errors import CaseError
from gearlash.case.files import UnreadableError
from gearlash.system import evaluate

PHYSICAL = """
kind = "spur-1dof"
[pinion]
teeth = 20
inertia = "0.01 kg m^2"
{pinion}
[gear]
teeth = 30
inertia = "0.03 kg m^2"
[mesh]
module = "4 mm"
pressure_angle = "20 deg"
damping_ratio = 0.05
backlash = "100 um"
{mesh}
[operation]
pinion_speed = "2000 rpm"
torque = "200 N m"
{curves}
"""
NUMBERS = """
kind = "spur-1dof"
[dimensionless]
omega = 0.7
D = 1
load = 0.2
mesh_damping = 0.05
"""


def physical(curves: str, mesh: str = "", pinion: str = "") -> str:
    return PHYSICAL.format(curves=curves, mesh=mesh, pinion=pinion)


def stiffness(case: gl.Case) -> np.ndarray:
    """η at 12 phases of the base period."""
    series = case.family()[0].system().clearances[0].stiffness_plus
    return evaluate(series, 2.0 * np.pi * np.arange(12) / 12)


def refused(text: str) -> str:
    with pytest.raises(CaseError) as error:
        loads(text)
    return str(error.value)


def test_one_curve_in_every_form():
    """A cosine of 20 %: as harmonics, as points in the unit of the column, over degrees of a pitch."""
    turn = np.linspace(0.0, 1.0, 257)
    wave = 300.0 + 60.0 * np.cos(2.0 * np.pi * turn)
    pairs = [[float(a), float(b)] for a, b in zip(turn, wave, strict=True)]
    degrees = [[18.0 * a, b] for a, b in pairs]
    forms = [
        '[curves.stiffness]\nmean = 300\namplitudes = [60]\nunit = "N/um"',
        f'[curves.stiffness]\npoints = {pairs}\nunit = "N/um"\nharmonics = 3',
        f'[curves.stiffness]\npoints = {degrees}\nangle = "pinion deg"\nunit = "N/µm"',
    ]
    wanted = 1.0 + 0.2 * np.cos(2.0 * np.pi * np.arange(12) / 12)
    for form in forms:
        case = loads(physical(form))
        assert case.entries["mesh.mean_stiffness"].number == pytest.approx(3e8, rel=1e-9)
        assert stiffness(case) == pytest.approx(wanted, abs=2e-5)
        assert gl.Case.from_json(case.to_json()) == case


def test_a_curve_without_unit_is_over_its_mean():
    case = loads(NUMBERS + "[curves.stiffness]\nlow = 1\nhigh = 2\ncontact_ratio = 1.5\nharmonics = 40\n")
    assert stiffness(case)[[1, 4, 8, 11]] == pytest.approx([4 / 3, 4 / 3, 2 / 3, 2 / 3], abs=0.03)
    scaled = case.with_overrides({"ripple_scale": 0.5})
    assert stiffness(scaled) - 1.0 == pytest.approx(0.5 * (stiffness(case) - 1.0), abs=1e-12)


def test_harmonics_by_the_dozen():
    heights = [0.5 / n for n in range(1, 25)]
    case = loads(NUMBERS + f"[curves.error]\namplitudes = {heights}\n")
    forcing = case.family()[0].system().forcing[1]
    orders = np.arange(1, 25)
    assert forcing[1::2] == pytest.approx(orders**2 * 0.49 * heights, rel=1e-12)


def test_a_loaded_error_is_freed_of_what_the_stiffness_makes_of_it():
    """δ = F/K + e with e and K known: e comes back, and the double count would be twice as large."""
    turn = np.linspace(0.0, 1.0, 513)
    shape = 1.0 + 0.2 * np.cos(2.0 * np.pi * turn)
    own = 2.0 * np.sin(2.0 * np.pi * turn)
    pitch_radius = 0.04
    force = 200.0 / (pitch_radius * np.cos(np.radians(20.0)))
    loaded = own + 1e6 * force / (3e8 * shape)
    pairs = [[float(a), float(b)] for a, b in zip(turn, loaded, strict=True)]
    stated = (
        '[curves.stiffness]\nmean = 300\namplitudes = [60]\nunit = "N/um"\n'
        f'[curves.error]\npoints = {pairs}\nunit = "um"\n'
    )
    freed = loads(physical(stated + 'state = "loaded"\ntorque = "200 N m"\nharmonics = 4'))
    forcing = freed.family()[0].system().forcing[1]
    omega = freed.family()[0].defaults["omega"]
    amplitudes = forcing[1:] / np.repeat(np.arange(1, 5) ** 2, 2) / omega**2 * 50.0  # µm
    assert amplitudes == pytest.approx([0.0, 2.0, 0, 0, 0, 0, 0, 0], abs=1e-3)
    lines = np.fft.rfft(loaded[:-1])[1:9] / 256.0
    by_harmonics = (
        f"[curves.error]\namplitudes = {np.abs(lines).tolist()}\nphases = {np.angle(lines).tolist()}\n"
        'unit = "um"\nstate = "loaded"\ntorque = "200 N m"\nharmonics = 4'
    )
    again = (
        loads(physical(stated.partition("[curves.error]")[0] + by_harmonics)).family()[0].system().forcing[1]
    )
    assert again == pytest.approx(forcing, abs=1e-4 * np.abs(forcing).max())


def test_files_of_points_with_decimal_commas(tmp_path: Path):
    (tmp_path / "k.csv").write_text(
        "Winkel [pinion deg];Steifigkeit [N/µm]\n0,0;400,5\n10,8;400,5\n10,8;300\n18;300\n", "latin-1"
    )
    text = physical('[curves.stiffness]\nfile = "k.csv"\nharmonics = 30')
    (tmp_path / "pair.toml").write_text(text)
    case = gl.load_case(tmp_path / "pair.toml")
    mean = 0.6 * 400.5 + 0.4 * 300.0
    assert case.entries["mesh.mean_stiffness"].number == pytest.approx(mean * 1e6, rel=1e-9)
    shown = {value.path: value for value in case.values()}["curves.stiffness"]
    assert "4 points" in shown.description
    assert shown.reason == "points of k.csv"
    (tmp_path / "pair.toml").write_text(text.replace("k.csv", "kk.csv"))
    with pytest.raises(CaseError, match=r"curves.stiffness.file = 'kk.csv': expected a text file"):
        gl.load_case(tmp_path / "pair.toml")


@pytest.mark.parametrize(
    ("head", "keys", "said"),
    [
        ("angle [deg];stiffness [N/um]", 'angle = "pinion deg"\nunit = "kN/mm"', ""),  # one size
        ("angle [°];k [N/mm]", 'angle = "pinion deg"\nunit = "N/um"', "curves.stiffness.unit"),
        ("angle [°];k [um]", 'angle = "pinion deg"\nunit = "N/um"', "curves.stiffness.unit"),
        ("angle [°];k [N/um]", 'angle = "pinion deg"\nunit = ""', "curves.stiffness.unit"),
        ("angle [rad];k [N/um]", 'angle = "pinion deg"\nunit = "N/um"', "curves.stiffness.angle"),
        ("angle [gear deg];k [N/um]", 'angle = "pinion deg"\nunit = "N/um"', "curves.stiffness.angle"),
        ("angle [counts];k [as read]", 'angle = "pinion deg"\nunit = "N/um"', ""),  # no units
        ("angle;k", 'angle = "pinion deg"\nunit = "N/um"', ""),
    ],
)
def test_a_unit_in_the_head_of_a_file_is_not_overruled_in_silence(
    head: str, keys: str, said: str, tmp_path: Path
):
    (tmp_path / "k.csv").write_text(f"{head}\n0.0;400\n10.8;400\n10.8;300\n18;300\n", "utf-8")
    (tmp_path / "pair.toml").write_text(physical(f'[curves.stiffness]\nfile = "k.csv"\n{keys}'))
    if not said:
        mean = gl.load_case(tmp_path / "pair.toml").entries["mesh.mean_stiffness"].number
        assert mean == pytest.approx(360e6, rel=1e-9)
        return
    with pytest.raises(CaseError) as refused:
        gl.load_case(tmp_path / "pair.toml")
    (problem,) = refused.value.problems
    assert problem.path == said
    assert "what the head of k.csv has" in problem.expected


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        ("1;2,5\n2;3,5", ((1, 2.5), (2, 3.5))),
        ("a,b\n1,2.5\n2,3.5\n", ((1, 2.5), (2, 3.5))),
        ("# remark\n1\t2.5\n2\t3.5", ((1, 2.5), (2, 3.5))),
        ("x y\n1 2.5\n 2   3.5", ((1, 2.5), (2, 3.5))),
        ("1,0 2,5\n2,0 3,5", ((1, 2.5), (2, 3.5))),
        ("n [1/min];F [N]\n1000,5;2,5e3", ((1000.5, 2500),)),
    ],
)
def test_columns_as_instruments_write_them(text: str, rows: tuple[tuple[float, ...], ...]):
    assert parse_columns(text).rows == rows


@pytest.mark.parametrize("count", [9, 33, 361])
@pytest.mark.parametrize("begin", [0.0, 3.3])
def test_the_angle_that_closes_a_curve_may_be_rounded(count: int, begin: float):
    """As instruments write it: 20 teeth have cycles of 18°, 23 teeth of 15.652°, to three decimals."""
    share = np.linspace(0.0, 1.0, count)
    height = 2.0 + 1.5 * np.cos(2.0 * np.pi * share)
    rows = [[round(float(begin + 360.0 / 23.0 * x), 3), float(y)] for x, y in zip(share, height, strict=True)]
    exact = [[float(begin / (360.0 / 23.0) + x), float(y)] for x, y in zip(share, height, strict=True)]
    curves = '[curves.error]\nunit = "um"\npoints = '
    known = 'mean_stiffness = "3e8 N/m"'
    text = physical(f'{curves}{rows}\nangle = "pinion deg"', known).replace("teeth = 20", "teeth = 23")
    assert "teeth = 23" in text
    other = physical(f"{curves}{exact}", known).replace("teeth = 20", "teeth = 23")
    found, plain = (np.array(loads(one).family()[0].system().forcing)[:, 1:] for one in (text, other))
    size = np.abs(plain).max()
    assert size > 1e-3
    assert np.abs(found - plain).max() < 2e-3 * size
    assert refused(
        physical(f'{curves}{[*rows[:-1], [begin + 15.9, 1.0]]}\nangle = "pinion deg"', known).replace(
            "teeth = 20", "teeth = 23"
        )
    )


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "no line of numbers"),
        ("a;b", "names of columns"),
        ("1;2\n3;x\n4;5", "its line 2 is no row of 2 numbers: '3;x'"),
        ("1;2\n3;\n4;5", "missing"),
        ("a;b\n1;2\n3;4;5\n6;7", "its line 3 is no row of 2"),
    ],
)
def test_what_is_no_table_of_numbers_is_said(text: str, message: str):
    with pytest.raises(UnreadableError, match=message):
        _ = parse_columns(text).rows


def test_run_out_makes_a_base_period_of_many_cycles_and_says_so():
    case = loads(physical("", 'mean_stiffness = "3e8 N/m"', 'runout = "20 um"\nrunout_phase = "90 deg"'))
    system = case.family()[0].system()
    assert system.cycles == 20
    assert case.family()[0].defaults["pinion_runout"] == pytest.approx(0.4)
    assert any("20 mesh cycles" in note.text for note in case.notes())
    name, value = case.resolve("pinion_runout", "10 um")
    assert (name, value) == ("pinion_runout", pytest.approx(0.2))


PROBLEMS = {
    "two forms": ("[curves.stiffness]\namplitudes = [1]\nlow = 1", "expected one of: points; file"),
    "no form": ('[curves.stiffness]\nunit = "N/m"', "curves.stiffness is missing"),
    "wrong name": ("[curves.stifness]\namplitudes = [1]", "did you mean 'stiffness'"),
    "wrong key": ("[curves.error]\namplitude = [1]", "did you mean 'amplitudes'"),
    "wrong unit": ('[curves.error]\namplitudes = [1]\nunit = "N"', "a unit of it, such as"),
    "part of a turn": (
        '[curves.error]\npoints = [[0, 1], [3, 2], [18, 1]]\nangle = "pinion deg"\nover = "pinion turn"',
        "points all round one pinion turn",
    ),
    "backwards": ("[curves.error]\npoints = [[0, 1], [0.5, 2], [0.4, 1]]", "angles that never go back"),
    "no pair": ("[curves.error]\npoints = [[0, 1], [0.5]]", "a pair [angle, value]"),
    "angle of another shaft": (
        '[curves.error]\npoints = [[0, 1], [180, 2]]\nangle = "gear deg"\nover = "pinion turn"',
        "one of pinion deg",
    ),
    "negative": ('[curves.stiffness]\nmean = 1\namplitudes = [1.5]\nunit = "N/um"', "stay above 0"),
    "ratio": ("[curves.stiffness]\nlow = 1\nhigh = 2\ncontact_ratio = 0.9", "a number above 1"),
    "loaded without torque": ('[curves.error]\namplitudes = [1]\nstate = "loaded"', "torque is missing"),
    "torque without load": ('[curves.error]\namplitudes = [1]\ntorque = "1 N m"', "it is for state"),
    "scale of nothing": ("[dimensionless]\nerror_scale = 2", "there is no curves.error"),
    "file in a text": ('[curves.error]\nfile = "a.csv"', "points in place"),
}


@pytest.mark.parametrize("name", PROBLEMS)
def test_what_cannot_be_used_is_named(name: str):
    curves, message = PROBLEMS[name]
    mesh = "" if "curves.stiffness" in curves and "N/um" in curves else 'mean_stiffness = "3e8 N/m"'
    assert message in " ".join(refused(physical(curves, mesh)).split())


def test_harmonics_beside_a_curve_are_refused():
    message = refused(
        physical("[curves.error]\namplitudes = [1]", 'mean_stiffness = "3e8 N/m"\nerror = "5 um"')
    )
    assert "nothing here: curves.error states the whole of it" in " ".join(message.split())
    message = refused(physical('[curves.stiffness]\nlow = 1\nhigh = 2\ncontact_ratio = 1.5\nunit = "N/um"',
                               'mean_stiffness = "3e8 N/m"'))  # fmt: skip
    assert "curves.stiffness has a unit, and with it a mean" in " ".join(message.split())


@pytest.mark.parametrize(
    ("text", "names", "units", "first"),
    [
        ("Drehzahl;Kraft\nrpm;N\n1000;2,5\n2000;3,5", ("Drehzahl", "Kraft"), ("rpm", "N"), (1000, 2.5)),
        ("n;F\n[rpm];[kN]\n1000;2,5\n2000;3,5", ("n", "F"), ("rpm", "kN"), (1000, 2.5)),
        ("n / min⁻¹;F in N\n1000;2,5\n2000;3,5", ("n", "F"), ("min⁻¹", "N"), (1000, 2.5)),
        ("Run 12\nDate;2026-01-02\nn;F\nrpm;N\n1000;2,5\n2000;3", ("n", "F"), ("rpm", "N"), (1000, 2.5)),
        ("rpm;1;2\n1000;2;3\n2000;2;3", ("rpm", "1", "2"), ("", "", ""), (1000, 2, 3)),
        ("t\tn\tx\ns\trpm\tum\n0,0\t1000,0\t1,5\n0,1\t1001,0\t1,6", ("t", "n", "x"), ("s", "rpm", "um"),
         (0, 1000, 1.5)),
        ("n [rpm];F [N];\n1.000,5;2.500,0;\n2.000,5;3.500,0;", ("n", "F"), ("rpm", "N"), (1000.5, 2500)),
        ('"n [rpm]","F, max [N]"\n"1,000.5","2,500.0"\n"2,000.5","3,500.0"', ("n", "F, max"), ("rpm", "N"),
         (1000.5, 2500)),
        ("sep=;\nn [rpm];F [N]\n1;2\n3;4", ("n", "F"), ("rpm", "N"), (1, 2)),
        ("\ufeffn [rpm]  F [N]\r\n1 2\r\n3 4\r\n", ("n", "F"), ("rpm", "N"), (1, 2)),
        ("speed_rpm,mesh_force_N\n1000,2.5\n2000,3.5", ("speed", "mesh_force"), ("rpm", "N"), (1000, 2.5)),
        ("rpm;um\n1;2\n3;4", ("rpm", "um"), ("rpm", "um"), (1, 2)),
    ],
)  # fmt: skip
def test_heads_of_columns(
    text: str, names: tuple[str, ...], units: tuple[str, ...], first: tuple[float, ...]
):
    found = parse_columns(text)
    assert (found.names, found.units, found.rows[0]) == (names, units, first)


def test_columns_of_text_and_empty_cells_are_told_when_they_are_asked_for(tmp_path: Path):
    found = parse_columns("way;n;F\nup;1000;\ndown;2000;3\ndown;3000;n/a")
    assert np.isnan(found.column(2)).tolist() == [True, False, True]
    with pytest.raises(UnreadableError, match=r"its line 2 has no number in column 'way': 'up'"):
        found.column(0)
    (tmp_path / "unicode.txt").write_bytes("n [rpm]\tx [µm]\n1\t2\n".encode("utf-16"))
    assert read_columns(tmp_path / "unicode.txt").units == ("rpm", "µm")
