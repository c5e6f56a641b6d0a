"""Real teeth beside the lumped model: `python -m benchmarks.real_teeth [--fine | --keep] [PAIR]`.

Pairs of many kinds, each a drawing, as options of `gearlash new`; what it leaves open is estimated. Teeth are
turned slowly for their mean stiffness, and run at the speed, torque and error of the case, as by `gearlash
verify` with the inputs “absolute” (one speed, the planned setting); the lumped model gets what they give,
under every contact rule. Rows of the table of docs/verification.md, Markdown. `--keep` writes all of them
beside this file, with the commit that computed them; a test holds the page to that. Coarse elements take
seconds for a pair; with `--fine` they are those of `gearlash verify`, take minutes, and are kept as there.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from pathlib import Path

import gearlash as gl
from gearlash.case import Case
from gearlash.cli.answers.verify_words import label_of
from gearlash.multibody.compliance import SectorSettings
from gearlash.multibody.tooth_contact import ToothContact
from gearlash.multibody.tooth_section import Fineness
from gearlash.studies.verification import (
    Inputs,
    LumpedInputs,
    LumpedPoint,
    Mesh,
    PointFound,
    inputs_of,
    seen_of_label,
)
from gearlash.studies.verification.lumped import lumped_points
from gearlash.studies.verification.mesh import mesh_of
from gearlash.studies.verification.point import run_point
from gearlash.studies.verification.settings import PLANNED
from gearlash.studies.verification.whole import all_errors, errors_of
from tools.verified import computed

GEARLASH = Path(sys.executable).parent / "gearlash"
KEPT = Path(__file__).with_suffix(".json")
COMMAND = "python -m benchmarks.real_teeth --keep"
COARSE = SectorSettings(Fineness(flank=3, fillet=1, core=1, rim=2, axial=8))
MEDIUM = "--teeth 25/57 --module 3mm --helix-angle 15deg --face-width 40mm"
PAIRS = {
    "steel": f"{MEDIUM} --speed 8000rpm --torque 150N*m",
    "spur": "--teeth 25/57 --module 3mm --face-width 30mm --speed 8000rpm --torque 150N*m",
    "PA66": f"{MEDIUM} --material PA66 --speed 2000rpm --torque 30N*m",
    "helix of 33°": "--teeth 25/57 --module 3mm --helix-angle 33deg --face-width 40mm --speed 8000rpm "
    "--torque 150N*m",
    "tips relieved": f"{MEDIUM} --tip-relief 20um --speed 8000rpm --torque 150N*m",
    "rim and web": f"{MEDIUM} --rim-diameter /140mm --web-width /12mm --bore 25mm/50mm --speed 8000rpm "
    "--torque 150N*m",
    "95 °C": f"{MEDIUM} --temperature 95degC --housing-material aluminium --speed 8000rpm --torque 150N*m",
    "104/131 teeth": "--teeth 104/131 --module 2mm --helix-angle 15deg --face-width 40mm --speed 1500rpm "
    "--torque 400N*m",
    "12/14 teeth": "--teeth 12/14 --module 4mm --profile-shift 0.4/0.4 --helix-angle 10deg "
    "--face-width 40mm --speed 12000rpm --torque 100N*m",
    "module 12": "--teeth 21/64 --module 12mm --helix-angle 12deg --face-width 160mm --speed 2400rpm "
    "--torque 8000N*m",
    "module 1": "--teeth 23/61 --module 1mm --helix-angle 20deg --face-width 12mm --speed 20000rpm "
    "--torque 4N*m",
    "ratio 8": "--teeth 17/136 --module 2.5mm --helix-angle 18deg --face-width 32mm --speed 9000rpm "
    "--torque 60N*m",
    "2 N·m": f"{MEDIUM} --speed 4200rpm --torque 2N*m",
}
STIFFNESS = "mesh.mean_stiffness"
COLUMNS = (
    "pair",
    "options of `gearlash new`",
    "k of real teeth",
    "over that of `new` (its range)",
    "ω",
    "real teeth",
    "lumped",
    "forces of real teeth over their mean",
    "of the lumped model",
)


@dataclass(frozen=True)
class Both:
    """A pair with real teeth and without; the lumped model under every contact rule. ``estimate`` is the mean
    stiffness by `gearlash new`, least, itself and greatest, N/m."""

    estimate: tuple[float, float, float]
    inputs: Inputs
    mesh: Mesh
    real: PointFound
    lumped: tuple[LumpedPoint, ...]


def drawn(options: str) -> Case:
    """The case that `gearlash new` makes of a drawing."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "pair.toml"
        made = subprocess.run([GEARLASH, "new", file, *options.split()], capture_output=True, text=True)
        if made.returncode:
            raise SystemExit(f"gearlash new {options}\n{made.stderr}")
        return gl.load_case(file)


def both(case: Case, elements: SectorSettings | None) -> Both:
    """As planned at the speed of the case; ``elements`` as of `mesh_of`."""
    estimated = next(value for value in case.values() if value.path == STIFFNESS)
    assert estimated.least is not None  # no drawing here states it
    assert estimated.greatest is not None
    inputs = inputs_of(case, (case.family()[0].complete()["omega"],))
    mesh = mesh_of(inputs, inputs.pair.face_width, inputs.torque, elements)
    contact = mesh.contact(inputs, errors=errors_of(inputs, mesh), flexible=True)
    omega = inputs.speeds[0] * sqrt(inputs.mean_stiffness / mesh.stiffness)
    real = run_point(
        inputs,
        ToothContact(contact.tables),
        PLANNED,
        omega=omega,
        stiffness=mesh.stiffness,
        torque=inputs.torque,
        modes=mesh.modes(flexible=True),
    )
    errors = all_errors(inputs, mesh)
    given = LumpedInputs(mesh.stiffness, mesh.ripples, mesh.ripple_phases, inputs.torque, errors)
    estimate = estimated.least, float(estimated.value), estimated.greatest
    return Both(estimate, inputs, mesh, real, lumped_points(case, given, (omega,)))


def row(name: str, found: Both) -> list[str]:
    """Cells of the table."""
    reading, lumped = found.real.reading, found.lumped
    least, estimate, greatest = found.estimate
    over = f"{found.mesh.stiffness / estimate:.2f} ({least / estimate:.2f} to {greatest / estimate:.2f})"
    return [
        name,
        f"`{PAIRS[name]}`",
        f"{found.mesh.stiffness / 1e8:.3g}·10⁸ N/m",
        over,
        f"{found.real.omega:.2f}",
        label_of(found.real),
        " / ".join(dict.fromkeys(point.label for point in lumped)),
        span(reading.least / reading.mean, reading.most / reading.mean),
        " / ".join(dict.fromkeys(map(forces_of, lumped))),
    ]


def line(cells: Sequence[str]) -> str:
    """Of a table in Markdown."""
    return f"| {' | '.join(cells)} |"


def table(rows: Sequence[Sequence[str]]) -> str:
    """As on the page."""
    return "\n".join([line(COLUMNS), f"|{'---|' * len(COLUMNS)}", *map(line, rows)])


def forces_of(point: LumpedPoint) -> str:
    """Over a period; of a motion without one there is no end to look for."""
    return span(point.force.min(), point.force.max()) if seen_of_label(point.label).label else "—"


def span(least: float, most: float) -> str:
    """Without a zero below zero."""
    return " to ".join(f"{round(each, 2) + 0.0:.2f}".replace("-", "−") for each in (least, most))


def main(arguments: list[str] | None = None) -> int:
    """Prints a row as soon as it is there."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.real_teeth", description=__doc__)
    parser.add_argument("pairs", nargs="*", metavar="PAIR", help=f"of {', '.join(PAIRS)}; all without any")
    way = parser.add_mutually_exclusive_group()
    way.add_argument("--fine", action="store_true", help="elements as of `gearlash verify`")
    way.add_argument("--keep", action="store_true", help=f"all pairs, written to {KEPT.name}")
    asked = parser.parse_args(arguments)
    unknown = [name for name in asked.pairs if name not in PAIRS]
    if unknown:
        parser.error(f"no such pair: {', '.join(unknown)}; there are {', '.join(PAIRS)}")
    if asked.keep and asked.pairs:
        parser.error("--keep is of all pairs: name none beside it")
    code, rows = computed(COMMAND), []
    print(table(rows), flush=True)
    for name in asked.pairs or PAIRS:
        rows.append(row(name, both(drawn(PAIRS[name]), None if asked.fine else COARSE)))
        print(line(rows[-1]), flush=True)
    if asked.keep:
        write(code, rows)
    return 0


def write(code: dict[str, str], rows: Sequence[Sequence[str]]) -> None:
    """Keeps the table, and which code computed it."""
    KEPT.write_text(json.dumps({**code, "rows": rows}, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    raise SystemExit(main())
