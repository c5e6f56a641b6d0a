"""A verification of the article's pair as its report takes it: what `article/verified.json` keeps."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from .answers.verify import BreathingComputed, ConfigurationCompared, MeshComputed, VerifyAnswer
from .show.verify import spans, stays

if TYPE_CHECKING:
    from gearlash.studies.verification import Verification

RULE = "always"
"""The contact rule of the article, whose forces are drawn."""
DIGITS = 5
PICTURED = "absolute"
"""The way whose lines of contact are drawn: teeth as wide as the case says, at its own torque."""


def verified_data(found: Verification, answer: VerifyAnswer, computed: dict[str, str]) -> dict[str, Any]:
    """All that the report shows; ``computed`` says by which state of the code and which command."""
    meshes = {(mesh.face_width, mesh.stiffness): mesh for mesh in answer.meshes}
    return {
        "case": answer.case.hash,
        "gearlash": answer.case.gearlash,
        "computed": computed,
        "settings": list(answer.settings),
        "ways": [_way(one, list(meshes.values())) for one in answer.configurations],
        "pictured": PICTURED,
        "lines": _lines_of_contact(found),
    }


def _lines_of_contact(found: Verification) -> dict[str, Any]:
    """Loads over a slow mesh cycle on flanks of the case's width."""
    from gearlash.plots.tooth_contact import ToothLoads

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
        "errors_under_load": _short(mesh.errors_under_load),
        "points": [_point(one, index) for index in range(len(one.points))],
        "beside": [[p.setting, p.speed, p.label, p.apart] for p in one.beside],
        "settled": [[p.setting, p.speed, p.settled] for p in (*one.points, *one.beside)],
        "breathing": [_breathing(each) for each in one.breathing],
        "up": spans(window.speed, window.up) if window.up else "",
        "down": spans(window.speed, window.down) if window.down else "",
        "window": {
            "speed": _short(window.speed),
            "up": list(window.up),
            "down": list(window.down),
            "lumped_up": {rule: list(labels) for rule, labels in window.lumped_up.items()},
            "lumped_down": {rule: list(labels) for rule, labels in window.lumped_down.items()},
        },
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
        "impacts": point.impacts,
        "back_impacts": point.back_impacts,
        "energy_residual": point.energy_residual,
        "returns": point.returns,
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
