"""The article's pair with real teeth, kept for its report: ``python -m tools.verified`` (minutes).

Flanks with a modification that turns the harmonics of the stiffness round are one more way to hold the
inputs.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import gearlash as gl
from gearlash.cli.answers.verify import ConfigurationCompared, MeshComputed, VerifyAnswer, verify_answer
from gearlash.cli.show.verify import spans
from gearlash.multibody import Relief
from gearlash.studies.verification import Plan, sensitivity, verification

KEPT = Path(__file__).resolve().parents[1] / "src" / "gearlash" / "article" / "verified.json"
RELIEF = Relief(pinion_tip=53e-6, gear_tip=53e-6, pinion_length=7e-3, gear_length=7e-3, crowning=41e-6)
RULE = "always"
"""The contact rule of the article, whose forces are drawn."""
DIGITS = 5


def main() -> None:
    """Computes and writes."""
    case = gl.load_case("article")
    plan = Plan(beside=sensitivity(), relief=RELIEF)
    with gl.open_workers(case, 2) as executor:
        found = verification(case, plan=plan, execution=gl.Execution(executor), tell=_tell)
    write(verify_answer(case, found))


def _tell(stage: str, progress: Any) -> None:
    done = "" if progress is None else f" {progress.done}/{progress.total}"
    print(f"{stage}{done}", file=sys.stderr)


def write(answer: VerifyAnswer) -> None:
    """Keeps what the report shows."""
    meshes = {(mesh.face_width, mesh.stiffness): mesh for mesh in answer.meshes}
    data = {
        "case": answer.case.hash,
        "gearlash": answer.case.gearlash,
        "settings": list(answer.settings),
        "ways": [_way(one, list(meshes.values())) for one in answer.configurations],
    }
    KEPT.write_text(json.dumps(data, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


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
        "ripples": list(mesh.ripples),
        "points": [_point(one, index) for index in range(len(one.points))],
        "beside": [[p.setting, p.speed, p.label, p.apart] for p in one.beside],
        "up": spans(window.speed, window.up) if window.up else "",
        "down": spans(window.speed, window.down) if window.down else "",
        "lumped_up": {rule: spans(window.speed, labels) for rule, labels in window.lumped_up.items()},
        "lumped_down": {rule: spans(window.speed, labels) for rule, labels in window.lumped_down.items()},
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
        "phase": _short(point.phase),
        "force": _short([each / mean for each in point.force]),
        "lumped_phase": _short(beside[RULE].phase),
        "lumped_force": _short(beside[RULE].force),
    }


def _short(values: Sequence[float]) -> list[float]:
    return [float(f"{value:.{DIGITS}g}") for value in values]


if __name__ == "__main__":
    main()
