"""What `gearlash verify` keeps in the folder of --out."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from gearlash.results.store import write_together

from .files import draw_if
from .folder import OutFolder
from .jsonio import text

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from gearlash.plots import ForcePanel, OrderPanel
    from gearlash.studies.verification import Verification

    from .answers.verify import ConfigurationCompared, VerifyAnswer


def write_verification(folder: OutFolder, found: Verification, answer: VerifyAnswer) -> None:
    """The answer (JSON) and, where all was computed, forces and spectra beside the lumped model under the
    contact rule of the case, lines of contact and frames, as SVG and PDF."""
    made = {"force": _force, "orders": _orders, "lines": _lines, "frames": _frames}
    older = folder.outdated("verify.json", (f"{name}.{form}" for name in made for form in ("svg", "pdf")))
    write_together({folder.file("verify.json"): text(answer).encode("utf-8")}, instead_of=older)
    for name, draw in made.items():
        draw_if(folder, name, answer.status == "ok", _drawing(draw, found, answer))


def _drawing(
    draw: Callable[[Verification, VerifyAnswer], Figure], found: Verification, answer: VerifyAnswer
) -> Callable[[object], Figure]:
    return lambda _: draw(found, answer)


def _force(found: Verification, answer: VerifyAnswer) -> Figure:
    from gearlash import plots

    return plots.force_beside([_force_panels(one, answer.stated[0].rule) for one in answer.configurations])


def _force_panels(one: ConfigurationCompared, rule: str) -> list[ForcePanel]:
    from gearlash import plots

    from .answers.verify_words import in_words

    lumped = {p.omega: p for p in one.lumped if p.rule == rule}
    return [
        plots.ForcePanel(
            f"{one.name}, {p.speed:.0f} rpm: {in_words(p.label).partition(',')[0]}",
            np.array(p.phase),
            np.array(p.force) / p.mean_force,
            np.array(lumped[p.omega].phase),
            np.array(lumped[p.omega].force),
        )
        for p in one.points
    ]


def _orders(found: Verification, answer: VerifyAnswer) -> Figure:
    from gearlash import plots

    return plots.orders_beside([_order_panels(one, answer.stated[0].rule) for one in answer.configurations])


def _order_panels(one: ConfigurationCompared, rule: str) -> list[OrderPanel]:
    from gearlash import plots

    lumped = {p.omega: p for p in one.lumped if p.rule == rule}
    return [
        plots.OrderPanel(
            f"{one.name}, {p.speed:.0f} rpm",
            np.arange(1, len(p.orders) + 1) / 2.0,
            np.array(p.orders) / p.mean_force,
            np.array(lumped[p.omega].orders),
            np.array(lumped[p.omega].amplitudes),
        )
        for p in one.points
    ]


def _lines(found: Verification, answer: VerifyAnswer) -> Figure:
    """Of the face width of the case, under its torque."""
    from gearlash.plots.tooth_contact import ToothLoads, tooth_contact

    full = found.meshes[1]
    return tooth_contact(ToothLoads.of(full.perfect, full.static))


def _frames(found: Verification, answer: VerifyAnswer) -> Figure:
    """Of the motion as planned in which teeth are apart for the longest."""
    from gearlash.multibody.flanks import Flanks
    from gearlash.plots.mesh_frames import mesh_frames
    from gearlash.studies.verification import with_width

    one, point = max(
        ((one, point) for one in found.compared for point in one.points),
        key=lambda each: each[1].reading.apart,
    )
    flanks = Flanks(with_width(found.inputs, one.configuration.width).pair)
    words = f"{one.configuration.name}, {point.rpm:.0f} rpm"
    return mesh_frames(flanks, point.frames.poses, point.frames.forces, point.frames.phase.tolist(), words)
