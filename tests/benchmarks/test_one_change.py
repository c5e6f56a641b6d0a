"""What the page on verification says of why two pairs differ is what `benchmarks.one_change` found."""

from __future__ import annotations

import json
from dataclasses import replace
from math import cos, pi, sin
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from benchmarks.one_change import CHANGES, EXPLAINED, KEPT, LUMPED, PLAIN, main, swing, table
from benchmarks.real_teeth import KEPT as BESIDE
from benchmarks.real_teeth import PAIRS, drawn
from gearlash.multibody import Modes
from gearlash.studies.verification import Inputs, Setting, inputs_of
from gearlash.studies.verification.point import AXES, machine_of
from gearlash.studies.verification.settings import PLANNED

PAGE = (Path(__file__).parents[2] / "docs" / "verification.md").read_text(encoding="utf-8")
FOUND = json.loads(KEPT.read_text(encoding="utf-8"))
K, OMEGA = 1.07e9, 0.573


@pytest.fixture(scope="module")
def inputs() -> Inputs:
    case = drawn(PAIRS["helix of 33°"])
    return inputs_of(case, (case.family()[0].complete()["omega"],))


@pytest.mark.parametrize("name", list(EXPLAINED))
def test_the_tables_of_the_page_are_those_of_the_command(name: str):
    rows = FOUND["tables"][name]
    assert table(rows) in PAGE
    assert [row[0] for row in rows] == [*EXPLAINED[name], LUMPED]
    assert f"Commit {FOUND['commit']} computed both tables" in PAGE


@pytest.mark.parametrize("name", list(EXPLAINED))
def test_with_nothing_changed_it_is_the_row_of_the_other_table(name: str):
    others = json.loads(BESIDE.read_text(encoding="utf-8"))["rows"]
    row = next(each for each in others if each[0] == name)
    first, *_, last = FOUND["tables"][name]
    assert (first[0], first[1], first[2]) == (PLAIN, row[5], row[7])
    assert (last[1], last[2]) == (row[6], row[8])


@pytest.mark.parametrize("setting", CHANGES.values(), ids=CHANGES.keys())
def test_the_force_on_one_spring_is_that_of_the_matrices_of_the_bodies(inputs: Inputs, setting: Setting):
    """Every coordinate in one system of equations, where `swing` adds directions one by one."""
    assert swing(inputs, teeth(), setting, OMEGA) == pytest.approx(_by_matrices(inputs, setting), rel=1e-6)


def test_stiff_bearings_leave_one_body_of_the_mesh(inputs: Inputs):
    """F = k E ω²/(ω² − c²), of an oscillator with the frequency c√(k/m_e), c = cos β_b cos α_wt of the pitch
    circles."""
    gear = inputs.pair.gears
    inertia = 1.0 / sum(
        (0.5 * each.base_diameter * cos(each.base_helix_angle)) ** 2 / own
        for each, own in zip(gear, inputs.axial_inertias, strict=True)
    )
    rate = OMEGA * inputs.natural_frequency(K)
    expected = K * inputs.error / inputs.mean_force / abs(1.0 - K / inertia / rate**2)
    undamped = replace(PLANNED, held="lumped", contact_damping=0.0)
    assert swing(inputs, teeth(), undamped, OMEGA) == pytest.approx(expected, rel=1e-9)


def teeth() -> Any:
    return SimpleNamespace(stiffness=K)


def _by_matrices(inputs: Inputs, setting: Setting) -> float:
    rate = OMEGA * inputs.natural_frequency(K)
    pinion = inputs.pair.pinion
    machine = machine_of(inputs, setting, inputs.torque, rate / pinion.teeth, 2.0 * pi / rate, Modes())
    machine = replace(machine, governor_time=1e9)
    lean, pressure = pinion.base_helix_angle, inputs.pair.working_pressure_angle
    push = np.array([sin(pressure) * cos(lean), cos(pressure) * cos(lean), sin(lean)])
    first, second = (0.5 * each for each in inputs.pair.working_diameters)
    line = np.concatenate(
        [push, np.cross([first, 0.0, 0.0], push), -push, np.cross([second, 0.0, 0.0], push)]
    )
    spring = K * (1.0 + 1j * rate * 2.0 * setting.contact_damping * inputs.mesh_damping / (rate / OMEGA))
    bodies = machine.stiffness() - rate**2 * machine.inertia() + 1j * rate * machine.damping()
    free = [i for i in range(12) if i not in AXES[setting.held]]
    error = setting.error * inputs.error
    whole = bodies + spring * np.outer(line, line)
    moved = np.linalg.solve(whole[np.ix_(free, free)], spring * error * line[free])
    return float(abs(spring * (line[free] @ moved - error))) / inputs.mean_force


def test_all_pairs_are_kept_or_none(capsys: pytest.CaptureFixture[str]):
    with pytest.raises(SystemExit):
        main(["--keep", "helix of 33°"])
    assert "--keep is of all pairs" in capsys.readouterr().err


def test_a_pair_that_is_not_there_is_answered_with_those_that_are(capsys: pytest.CaptureFixture[str]):
    with pytest.raises(SystemExit):
        main(["module 13"])
    assert "no such pair: module 13; there are helix of 33°" in capsys.readouterr().err
