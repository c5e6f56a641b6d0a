"""Pictures of the pair with real teeth: lines of contact, frames of a motion, order spectra; and what the
centre distance does."""

from __future__ import annotations

import numpy as np

from gearlash import plots
from gearlash.article.verified import Verified, VerifiedBreathing, VerifiedLines, VerifiedPoint, VerifiedWay
from gearlash.case import Case
from gearlash.multibody.flanks import Flanks
from gearlash.plots.mesh_frames import mesh_frames
from gearlash.plots.tooth_contact import ToothLoads, tooth_contact
from gearlash.report.blocks import Block, Figure, Table, Text
from gearlash.report.numbers import fixed, minus, number
from gearlash.report.pictures import Picture
from gearlash.studies.verification import inputs_of, with_width

from .seen import NOT_COMPUTED, has_label, told

LINES, FRAMES, ORDERS = "verified-lines", "verified-frames", "verified-orders"

Drawn = tuple[list[Block], list[Picture]]


def drawn(case: Case, found: Verified) -> Drawn:
    """All of them that the kept data have."""
    blocks: list[Block] = []
    pictures: list[Picture] = []
    way = next((each for each in found.ways if each.name == found.pictured), None)
    parts = [_orders(found)]
    if way is not None and found.lines is not None:
        flanks = Flanks(with_width(inputs_of(case, (1.0,)), way.face_width * 1e-3).pair)
        parts += [_frames(flanks, way), _lines(flanks, way, found.lines)]
    for more, drawings in parts:
        blocks += more
        pictures += drawings
    return [*blocks, *_breathing(found)], pictures


def _orders(found: Verified) -> Drawn:
    if not all(point.orders for way in found.ways for point in way.points):
        return [], []
    panels = [[_panel(way, point) for point in way.points] for way in found.ways]
    figure = Figure(
        "fig-verified-orders",
        Text.of(
            "Order spectrum of the contact force of both models, in dB; 0 dB is the mean force. Lines at "
            "halves of the mesh frequency are those of a doubled period. The lumped model has lines where "
            "its motion has a period; a motion of real teeth without one is read over whole cycles all the "
            "same."
        ),
        "Order spectra of contact forces, a row for every way to hold the inputs, a column for each speed.",
        ORDERS,
    )
    return [figure], [Picture(ORDERS, plots.orders_beside, (panels,))]


def _panel(way: VerifiedWay, point: VerifiedPoint) -> plots.OrderPanel:
    halves = np.arange(1, len(point.orders) + 1) / 2.0
    return plots.OrderPanel(
        f"{way.name}, {point.speed:.0f} rpm",
        halves,
        np.array(point.orders),
        np.array(point.lumped_orders),
        np.array(point.lumped_amplitudes),
    )


def _frames(flanks: Flanks, way: VerifiedWay) -> Drawn:
    """The motion of this way that is apart for the longest."""
    point = max(way.points, key=lambda each: each.apart)
    if not point.frames:
        return [], []
    frames = np.array(point.frames)
    poses = np.zeros((len(frames), 12))
    poses[:, [5, 11]] = frames[:, 1:3]
    figure = Figure(
        "fig-verified-frames",
        Text.of(
            f"One mesh cycle at {point.speed:.0f} rpm with the inputs “{way.name}”: the teeth at mid face, "
            "pinion left and gear right. Arrows are the push on the gear; without one no tooth carries, "
            "or less than 1 % of the longest."
        ),
        "Teeth in mesh at times of a mesh cycle, side by side.",
        FRAMES,
    )
    return [figure], [Picture(FRAMES, mesh_frames, (flanks, poses, frames[:, 3:5], frames[:, 0].tolist()))]


def _lines(flanks: Flanks, way: VerifiedWay, kept: VerifiedLines) -> Drawn:
    rolls, loads = (np.array(each).reshape(kept.shape) for each in (kept.rolls, kept.loads))
    found = ToothLoads(flanks, np.array(kept.slices), np.array(kept.phase), rolls, loads)
    figure = Figure(
        "fig-verified-lines",
        Text.of(
            f"Lines of contact on a tooth of the pinion, {number(way.face_width, 3)} mm wide, turned slowly "
            f"under {number(kept.torque, 3)} N·m; flanks without error. The load at the ends of the face is "
            "that of the last slice, and greater on a narrower one."
        ),
        "A map of the flank with the greatest load, and the lines of contact at one time.",
        LINES,
    )
    return [figure], [Picture(LINES, tooth_contact, (found,))]


def _breathing(found: Verified) -> list[Block]:
    """What the motion of the centre distance does at the speeds of every way."""
    rows = tuple(
        (way.name, f"{point.speed:.0f} rpm", *_row(moved, point))
        for way in found.ways
        for moved, point in zip(way.breathing, way.points, strict=False)
    )
    if not rows:
        return []
    return [
        Table(
            "table-verified-breathing",
            "The centre distance breathes, and contact ratio and backlash with it: least and greatest values "
            "over the motion of real teeth, at mid face; by how much the greatest force is above (+) or "
            "below (−) that with the centre distance held; and the label with that held.",
            (
                "inputs",
                "speed",
                "change of centre distance",
                "contact ratio",
                "backlash",
                "greatest force",
                "label when held",
            ),
            rows,
            widths=(14, 12, 18, 16, 16, 12, 12),
        )
    ]


def _row(moved: VerifiedBreathing, point: VerifiedPoint) -> tuple[str, ...]:
    change, ratio, play = moved.centre_distance, moved.contact_ratio, moved.backlash
    share = moved.peak_share
    return (
        f"{fixed(change[0], 1)} to {fixed(change[1], 1)} µm",
        f"{ratio[0]:.4f} to {ratio[1]:.4f}",
        f"{play[0]:.1f} to {play[1]:.1f} µm",
        NOT_COMPUTED if share is None else f"{minus(f'{100.0 * share:+.1f}')} %",
        _when_held(moved.label_held, point.label),
    )


def _when_held(held: str, label: str) -> str:
    """Two motions with one label are the same in that; two without one need not be."""
    if held != label:
        return told(held)
    return "the same" if has_label(label) else f"{told(held)}, either"
