"""What a stated value conflicts with, and how it is read. Notes are shown, never used in a computation."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gearlash.gears import iso6336
from gearlash.system import Clearance, ContactRule

from .quantities import PIECEWISE

if TYPE_CHECKING:
    from .case import Case

_TOLERATED = 1.5


@dataclass(frozen=True)
class Note:
    """A remark on one value: its path and a sentence."""

    path: str
    text: str


def notes(case: Case) -> list[Note]:
    """Every remark on a case."""
    found = [] if case.kind == PIECEWISE else list(_stiffness(case))
    for clearance in case.family()[0].system().clearances:
        found += _sides(clearance, case.kind)
    return found


def _sides(clearance: Clearance, kind: str) -> Iterator[Note]:
    """Sides without stiffness: whether they act, by their damping, or not."""
    series = (clearance.stiffness_plus, clearance.stiffness_minus)
    for sign, boundary, stiffness, damping in zip("+-", (1, -1), series, clearance.dampings, strict=True):
        if stiffness.any():
            continue
        if clearance.stops(boundary):
            text = f"side {sign} has no stiffness: it acts by its damping {damping:g} alone"
        elif clearance.contact == ContactRule.ALWAYS:
            text = f"side {sign} has no stiffness: it does not act" + (
                " (the damping acts everywhere)" if damping else ""
            )
        else:
            text = f"side {sign} has no stiffness and no damping stated for it: it does not act"
        side = "plus" if boundary > 0 else "minus"
        path = f"clearance.{clearance.name}.stiffness_{side}" if kind == PIECEWISE else "mesh.back_stiffness"
        yield Note(path, text)


def _stiffness(case: Case) -> Iterator[Note]:
    body, stated = case.numbers.body, case.scales.mean_stiffness
    if body.geometry is None or body.face_width is None or stated is None:
        return
    estimate = iso6336.mesh_stiffness(body.geometry, body.face_width)
    ratio = estimate / stated
    if 1.0 / _TOLERATED <= ratio <= _TOLERATED:
        return
    more, factor = ("stiffer", ratio) if ratio > 1.0 else ("softer", 1.0 / ratio)
    yield Note(
        "mesh.mean_stiffness",
        f"stated {stated:.3g} N/m; {iso6336.REFERENCE}, gives {estimate:.3g} N/m for solid steel gears with "
        f"{1e3 * body.face_width:g} mm of common face width, {factor:.1f} times {more}. "
        "The stated value is used.",
    )
