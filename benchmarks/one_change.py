"""Why real teeth and the lumped model differ: `python -m benchmarks.one_change [--keep] [PAIR]`.

Pairs of `benchmarks.real_teeth` in which they do, computed again with one thing changed at a time, and the
force that bodies which do not bend would have on one spring without a ripple, by hand. Rows of tables of
docs/verification.md, Markdown. `--keep` writes all of them beside this file, with the commit that computed
them; a test holds the page to that.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Collection, Sequence
from dataclasses import replace
from math import cos, pi, sin, sqrt
from pathlib import Path

from gearlash.case import Case
from gearlash.cli.answers.verify import label_of
from gearlash.multibody import Modes
from gearlash.multibody.tooth_contact import ToothContact
from gearlash.studies.verification import Inputs, LumpedInputs, Mesh, PointFound, Setting, inputs_of
from gearlash.studies.verification.lumped import lumped_points
from gearlash.studies.verification.mesh import mesh_of
from gearlash.studies.verification.point import AXES, machine_of, run_point
from gearlash.studies.verification.settings import PLANNED
from gearlash.studies.verification.whole import all_errors, errors_of
from tools.verified import computed

from .real_teeth import COARSE, PAIRS, drawn, forces_of, line, span

KEPT = Path(__file__).with_suffix(".json")
COMMAND = "python -m benchmarks.one_change --keep"
COLUMNS = "changed", "real teeth", "forces over their mean", "on one spring"
LUMPED = "the lumped model"
PLAIN = "nothing"
RIGID = replace(PLANNED, flexible=False)
CHANGES = {
    PLAIN: PLANNED,
    "no error on the flanks": replace(PLANNED, error=0.0),
    "gear that does not bend": RIGID,
    "centre distance held": replace(PLANNED, held="centre distance"),
    "tilts held": replace(PLANNED, held="tilts"),
    "tilts held, gear that does not bend": replace(RIGID, held="tilts"),
    "tilt stiffness / 4": replace(PLANNED, tilt=0.25),
    "tilt stiffness / 2": replace(PLANNED, tilt=0.5),
    "tilt stiffness × 2": replace(PLANNED, tilt=2.0),
}
EXPLAINED = {
    "helix of 33°": tuple(CHANGES),
    "104/131 teeth": (PLAIN, "gear that does not bend"),
}
"""What is changed of which pair."""


def swing(inputs: Inputs, mesh: Mesh, setting: Setting, omega: float) -> float:
    """Amplitude of the force over its mean at the mesh frequency: bodies that do not bend, in their bearings,
    on one spring in the middle of the face, without ripple or gap.

    F = E/(1/(k (1 + iωτ)) + H): the error E moves bodies with the receptance H along the line of action; each
    direction adds the square of its share in that line over K − Mω² + iωC.

    Parameters
    ----------
    inputs : Inputs
    mesh : Mesh
    setting : Setting
    omega : float
        Mesh frequency over √(k/m_e).

    Returns
    -------
    float
    """
    rate = omega * inputs.natural_frequency(mesh.stiffness)
    speed = rate / inputs.pair.pinion.teeth
    machine = machine_of(inputs, setting, inputs.torque, speed, 2.0 * pi / rate, Modes())
    lean, pressure = inputs.pair.pinion.base_helix_angle, inputs.pair.working_pressure_angle
    receptance, held = 0j, AXES[setting.held]
    for i, (body, bearings) in enumerate(zip(machine.bodies, machine.bearings, strict=True)):
        base = 0.5 * inputs.pair.gears[i].base_diameter
        shares = sin(pressure) * cos(lean), cos(pressure) * cos(lean), sin(lean)
        working = base / cos(pressure)
        masses = (*(body.mass,) * 3, body.transverse_inertia)
        springs, dashpots = ((*values[:3], values[4]) for values in (bearings.stiffness, bearings.damping))
        moved = (*shares, working * sin(lean))
        for axis, share, m, k, c in zip((0, 1, 2, 4), moved, masses, springs, dashpots, strict=True):
            if 6 * i + axis not in held:
                receptance += share**2 / (k - m * rate**2 + 1j * rate * c)
        receptance -= (base * cos(lean)) ** 2 / (body.axial_inertia * rate**2)
    time = 2.0 * setting.contact_damping * inputs.mesh_damping / inputs.natural_frequency(mesh.stiffness)
    spring = mesh.stiffness * (1.0 + 1j * rate * time)
    return abs(setting.error * inputs.error / (1.0 / spring + receptance)) / inputs.mean_force


def rows_of(case: Case, changes: Collection[str]) -> list[list[str]]:
    """Cells of the table of a pair."""
    inputs = inputs_of(case, (case.family()[0].complete()["omega"],))
    mesh = mesh_of(inputs, inputs.pair.face_width, inputs.torque, COARSE)
    omega = inputs.speeds[0] * sqrt(inputs.mean_stiffness / mesh.stiffness)
    rows = []
    for name in changes:
        found = run(inputs, mesh, CHANGES[name], omega)
        reading = found.reading
        forces = span(reading.least / reading.mean, reading.most / reading.mean)
        amplitude = swing(inputs, mesh, CHANGES[name], omega)
        rows.append([name, label_of(found), forces, span(1.0 - amplitude, 1.0 + amplitude)])
        print(line(rows[-1]), flush=True)
    given = LumpedInputs(
        mesh.stiffness, mesh.ripples, mesh.ripple_phases, inputs.torque, all_errors(inputs, mesh)
    )
    lumped = lumped_points(case, given, (omega,))
    told = (" / ".join(dict.fromkeys(each)) for each in ((p.label for p in lumped), map(forces_of, lumped)))
    rows.append([LUMPED, *told, ""])
    print(line(rows[-1]), flush=True)
    return rows


def run(inputs: Inputs, mesh: Mesh, setting: Setting, omega: float) -> PointFound:
    """The motion of real teeth with a setting, begun pressed together."""
    errors = tuple((setting.error * amplitude, phase) for amplitude, phase in errors_of(inputs, mesh))
    contact = mesh.contact(inputs, errors=errors, damping=setting.contact_damping, flexible=setting.flexible)
    return run_point(
        inputs,
        ToothContact(contact.tables),
        setting,
        omega=omega,
        stiffness=mesh.stiffness,
        torque=inputs.torque,
        modes=mesh.modes(flexible=setting.flexible),
    )


def table(rows: Sequence[Sequence[str]]) -> str:
    """As on the page."""
    return "\n".join([line(COLUMNS), f"|{'---|' * len(COLUMNS)}", *map(line, rows)])


def main(arguments: list[str] | None = None) -> int:
    """Prints a row as soon as it is there."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.one_change", description=__doc__)
    parser.add_argument(
        "pairs", nargs="*", metavar="PAIR", help=f"of {', '.join(EXPLAINED)}; all without any"
    )
    parser.add_argument("--keep", action="store_true", help=f"all pairs, written to {KEPT.name}")
    asked = parser.parse_args(arguments)
    unknown = [name for name in asked.pairs if name not in EXPLAINED]
    if unknown:
        parser.error(f"no such pair: {', '.join(unknown)}; there are {', '.join(EXPLAINED)}")
    if asked.keep and asked.pairs:
        parser.error("--keep is of all pairs: name none beside it")
    code, tables = computed(COMMAND), {}
    for name in asked.pairs or EXPLAINED:
        print(f"{name}\n\n{table([])}", flush=True)
        tables[name] = rows_of(drawn(PAIRS[name]), EXPLAINED[name])
    if asked.keep:
        KEPT.write_text(json.dumps({**code, "tables": tables}, indent=1, ensure_ascii=False) + "\n", "utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
