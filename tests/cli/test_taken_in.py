"""What `new` writes as a comment that holds already, computed, estimated or from a list, changes nothing when
it is stated: at work, with modified flanks and with rims as otherwise."""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import cos, radians
from pathlib import Path

import pytest

from cli.conftest import Gearlash
from gearlash.case import Case, CaseError, load, loads
from gearlash.plots.teeth_of_case import teeth_of_case

SPUR = (
    "--teeth",
    "25/57",
    "--module",
    "3mm",
    "--face-width",
    "30mm",
    "--speed",
    "1450rpm",
    "--torque",
    "100Nm",
)
TURNED = (
    "--teeth", "25/57", "--module", "3mm", "--helix-angle", "15deg", "--face-width", "40mm/38mm",
    "--speed", "4200rpm", "--torque", "150Nm",
)  # fmt: skip
HOT = ("--temperature", "80degC", "--housing-temperature", "60degC", "--housing-material", "aluminium")
PAIRS = {
    "plain": (*SPUR, "--quality", "7"),
    "tempered": (*SPUR, "--backlash", "100um", *HOT),
    "deviated": (*SPUR, "--fit", "25cd", "--centre-distance-deviation", "40um"),
    "relieved": (*SPUR, "--tip-relief", "15um/10um", "--backlash-circumferential", "100um"),
    "crowned": (*TURNED, "--crowning", "8um", "--backlash", "80um"),
    "rimmed": (*TURNED, "--bore", "30mm/50mm", "--rim-diameter", "/150mm", "--web-width", "/12mm"),
    "shifted": (
        *TURNED, "--profile-shift", "0.3/0.1", "--material", "steel/POM", "--backlash", "0.6mm", *HOT[:2],
    ),
}  # fmt: skip
RIVALS = re.compile(r"one of .*same quantity: (\S+) = .* and (\S+) =")


def taken_in(text: str) -> Iterator[tuple[str, str]]:
    """Path and file of each line that holds already, without its #."""
    lines, table = text.splitlines(), ""
    for at, line in enumerate(lines):
        table = line.strip("[]") if line.startswith("[") else table
        if line.startswith("# ") and " = " in line and not line.endswith(", for example"):
            path = f"{table}.{line.split()[1]}"
            yield path, "\n".join([*lines[:at], line.removeprefix("# "), *lines[at + 1 :]])


def read(path: str, text: str) -> Case:
    """The case; where another line says the same, without that."""
    try:
        return loads(text)
    except CaseError as error:
        told = RIVALS.search(error.problems[0].expected)
        if told is None:
            raise
    names = {*told.groups()} - {path}
    names |= {"mesh.module"} if "mesh.normal_module" in names else set()
    kept, table = [], ""
    for line in text.splitlines():
        table = line.strip("[]") if line.startswith("[") else table
        if f"{table}.{line.split(' ')[0]}" not in names:
            kept.append(line)
    return loads("\n".join(kept))


def differences(before: Case, after: Case, path: str) -> list[str]:
    """Numbers that are not the same but for the digits that a comment has. Of harmonics near nothing the
    phase says nothing."""
    old, new = ({v.path: v.value for v in case.values()} for case in (before, after))
    found = []
    for name, value in old.items():
        if name == path or name not in new or isinstance(value, str):
            continue
        off = abs(float(value) - float(new[name]))
        order = re.fullmatch(r"mesh\.ripple_phase(_\d)?", name)
        least = 1e-4 if "ripple" in name or "shift" in name else 0.0
        if order is not None:
            least = 360.0 if abs(float(old[f"mesh.ripple{order[1] or ''}"])) < 0.01 else 0.1
        if off > max(2e-4 * abs(float(value)), least):
            found.append(f"{name}: {value} → {new[name]}")
    return found


@pytest.mark.parametrize("name", PAIRS)
def test_a_comment_that_holds_already_changes_nothing_when_it_is_stated(
    name: str, gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    assert gearlash("new", "pair.toml", *PAIRS[name]).code == 0
    before, tried = load("pair.toml"), 0
    for path, text in taken_in(Path("pair.toml").read_text(encoding="utf-8")):
        after = read(path, text)
        assert path in {entry.path for entry in after.entries.values()}
        assert not differences(before, after, path), path
        tried += 1
    assert tried > 40


@pytest.mark.parametrize("more", [("--centre-distance-deviation", "40um"), HOT], ids=["deviated", "tempered"])
def test_backlash_is_that_of_the_drawing_in_comments_and_where_it_is_drawn(
    more: tuple[str, ...], gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    """j_t = j_n/cos α at 20 °C and nominal distance, by hand, whatever it is at work."""
    monkeypatch.chdir(tmp_path)
    assert gearlash("new", "pair.toml", *SPUR, "--backlash", "100um", *more).code == 0
    text = Path("pair.toml").read_text(encoding="utf-8")
    told = re.search(r'# backlash_circumferential = "([\d.]+) um"', text)
    assert told is not None
    assert float(told[1]) == pytest.approx(100 / cos(radians(20)), rel=1e-4)
    case = load("pair.toml")
    assert case.scales.backlash_m(case.family()[0].defaults["D"]) > 110e-6
    drawn = teeth_of_case(case)
    assert drawn is not None
    assert drawn[0].centre_distance == pytest.approx(0.123, rel=1e-12)
    assert drawn[2] == pytest.approx(100e-6, rel=1e-9)
    assert drawn[1].endswith("at 20 °C and nominal centre distance")
    plain = teeth_of_case(load("article"))
    assert plain is not None
    assert "20 °C" not in plain[1]


def test_the_expansion_of_a_housing_is_that_of_its_material(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    for name, more, size in (("one", (), "10.5"), ("two", HOT, "23")):
        assert gearlash("new", f"{name}.toml", *SPUR, *more).code == 0
        (line,) = [
            line
            for line in Path(f"{name}.toml").read_text(encoding="utf-8").splitlines()
            if line.startswith("# housing_thermal_expansion = ")
        ]
        assert line.startswith(f'# housing_thermal_expansion = "{size} um/(m*K)"')
        assert line.endswith(", from the list")
