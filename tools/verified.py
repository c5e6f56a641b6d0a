"""The article's pair with real teeth, kept for its report: ``python -m tools.verified [WORKERS]`` (minutes).

Flanks with a modification that turns the harmonics of the stiffness round are one more way to hold the
inputs.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import gearlash as gl
from gearlash.cli.answers.verify import (
    BreathingComputed,
    ConfigurationCompared,
    MeshComputed,
    VerifyAnswer,
    verify_answer,
)
from gearlash.cli.show.verify import spans, stays
from gearlash.multibody import Relief
from gearlash.plots.tooth_contact import ToothLoads
from gearlash.studies.verification import Plan, Verification, sensitivity, verification

KEPT = Path(__file__).resolve().parents[1] / "src" / "gearlash" / "article" / "verified.json"
RELIEF = Relief(pinion_tip=80e-6, gear_tip=80e-6, pinion_length=8e-3, gear_length=8e-3, crowning=70e-6)
COMMAND = "make verified"
RULE = "always"
"""The contact rule of the article, whose forces are drawn."""
DIGITS = 5
NUMBERS = re.compile(r"\[[^\[\]{}\"]+\]")
PICTURED = "absolute"
"""The way whose lines of contact are drawn: teeth as wide as the case says, at its own torque."""


def main(workers: int = 2) -> None:
    """Computes and writes."""
    case = gl.load_case("article")
    plan = Plan(beside=sensitivity(), relief=RELIEF)
    with gl.open_workers(case, workers) as executor:
        found = verification(case, plan=plan, execution=gl.Execution(executor), tell=_tell)
    write(verify_answer(case, found), lines_of_contact(found))


def computed() -> dict[str, str]:
    """Which state of the code computes: its commit, and the day of that."""
    asked = "git", "-C", str(KEPT.parent), "log", "-1", "--format=%h %cs"
    commit, day = subprocess.run(asked, check=True, capture_output=True, text=True).stdout.split()
    return {"commit": commit, "day": day}


def _tell(stage: str, progress: Any) -> None:
    done = "" if progress is None else f" {progress.done}/{progress.total}"
    print(f"{stage}{done}", file=sys.stderr)


def lines_of_contact(found: Verification) -> dict[str, Any]:
    """Loads over a slow mesh cycle on flanks of the case's width."""
    full = found.meshes[1]
    loads = ToothLoads.of(full.perfect, full.static)
    return {
        "torque": full.static.torque,
        "slices": _short(loads.slices),
        "phase": _short(loads.phase),
        "shape": list(loads.loads.shape),
        "rolls": _short(loads.rolls.ravel()),
        "loads": _short(loads.loads.ravel()),
    }


def write(answer: VerifyAnswer, lines: dict[str, Any]) -> None:
    """Keeps what the report shows."""
    meshes = {(mesh.face_width, mesh.stiffness): mesh for mesh in answer.meshes}
    data = {
        "case": answer.case.hash,
        "gearlash": answer.case.gearlash,
        "computed": computed(),
        "command": COMMAND,
        "settings": list(answer.settings),
        "ways": [_way(one, list(meshes.values())) for one in answer.configurations],
        "pictured": PICTURED,
        "lines": lines,
    }
    text = json.dumps(data, indent=1, ensure_ascii=False)
    KEPT.write_text(NUMBERS.sub(_on_one_line, text) + "\n", encoding="utf-8")


def _on_one_line(found: re.Match[str]) -> str:
    return " ".join(found[0].split())


def _way(one: ConfigurationCompared, meshes: list[MeshComputed]) -> dict[str, Any]:
    mesh = next(m for m in meshes if (m.face_width, m.stiffness) == (one.face_width, one.stiffness))
    window = one.window
    return {
        "name": one.name,
        "held": one.held,
        "face_width": one.face_width,
        "stiffness": mesh.stiffness,
        "torque": one.torque,
        "error": one.error,
        "numbers": one.numbers,
        "ripples": list(mesh.ripples),
        "points": [_point(one, index) for index in range(len(one.points))],
        "beside": [[p.setting, p.speed, p.label, p.apart] for p in one.beside],
        "breathing": [_breathing(each) for each in one.breathing],
        "up": spans(window.speed, window.up) if window.up else "",
        "down": spans(window.speed, window.down) if window.down else "",
        "apart_differs": {rule: _differing(one, rule) for rule in window.lumped_up},
        "lumped_up": {rule: spans(window.speed, labels) for rule, labels in window.lumped_up.items()},
        "lumped_down": {rule: spans(window.speed, labels) for rule, labels in window.lumped_down.items()},
    }


def _differing(one: ConfigurationCompared, rule: str) -> list[list[float]]:
    """Speeds of the window, rising and falling, at which one model keeps teeth in contact and the other does
    not."""
    window = one.window
    ways = (window.up, window.lumped_up[rule]), (window.down, window.lumped_down[rule])
    return [
        [
            round(speed)
            for speed, real, lumped in zip(window.speed, *labels, strict=True)
            if stays(real) != stays(lumped)
        ]
        for labels in ways
    ]


def _breathing(each: BreathingComputed) -> dict[str, Any]:
    return {
        "centre_distance": _short(each.centre_distance),
        "contact_ratio": _short(each.contact_ratio),
        "backlash": _short(each.backlash),
        "label_held": each.label_held,
        "peak_share": each.peak_share,
    }


def _point(one: ConfigurationCompared, index: int) -> dict[str, Any]:
    point = one.points[index]
    rigid = [p.label for p in one.beside if p.setting == "rigid gear" and p.omega == point.omega]
    beside = {p.rule: p for p in one.lumped if p.omega == point.omega}
    mean = point.mean_force
    return {
        "speed": point.speed,
        "omega": point.omega,
        "label": point.label,
        "rigid": rigid[0] if rigid else "",
        "apart": point.apart,
        "least": point.least_force / mean,
        "peak": point.greatest_force / mean,
        "lumped": {rule: p.label for rule, p in beside.items()},
        "lumped_apart": {rule: p.apart for rule, p in beside.items()},
        "lumped_peak": {rule: float(f"{max(p.force):.{DIGITS}g}") for rule, p in beside.items()},
        "phase": _short(point.phase),
        "force": _short([each / mean for each in point.force]),
        "lumped_phase": _short(beside[RULE].phase),
        "lumped_force": _short(beside[RULE].force),
        "orders": _short([each / mean for each in point.orders]),
        "lumped_orders": _short(beside[RULE].orders),
        "lumped_amplitudes": _short(beside[RULE].amplitudes),
        "frames": [
            [float(f"{each:.9g}") for each in (frame.phase, *frame.turns, *frame.forces)]
            for frame in point.frames
        ],
    }


def _short(values: Iterable[float]) -> list[float]:
    return [float(f"{value:.{DIGITS}g}") for value in values]


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
