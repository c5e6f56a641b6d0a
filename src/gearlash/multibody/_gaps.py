"""Gaps of all slices of all pairs of teeth on one side, and how they change with the pose.

The pose is that of the pair turned over for side 1. First order in the tilts of the axes, exact in everything
else; the derivatives are those of what is computed, to rounding, so that the forces have a potential."""

from __future__ import annotations

from math import ceil, cos, floor, sin, sqrt

import numpy as np

from gearlash._kernel.jit import inner

from ._tables import (
    ANGLE,
    BASE_1,
    BASE_2,
    CENTRES,
    CORNER_1,
    CORNER_2,
    CURVED_1,
    CURVED_2,
    FAR_1,
    FAR_2,
    FIRST_PAIR,
    MODES,
    OBLIQUE,
    ORIGIN_1,
    ORIGIN_2,
    PATH_END,
    PATH_START,
    PITCH,
    RELIEF_START,
    RELIEF_STEP,
    TEETH,
    TIP_1,
    TIP_2,
    TWIST,
)

POSE = 12


@inner
def catmull_rom(t, weights, slopes):
    """Weights of four values at −1, 0, 1, 2 for the value at t from 0 to 1, and for its derivative."""
    square = t * t
    weights[0] = 0.5 * (-t + 2.0 * square - square * t)
    weights[1] = 0.5 * (2.0 - 5.0 * square + 3.0 * square * t)
    weights[2] = 0.5 * (t + 4.0 * square - 3.0 * square * t)
    weights[3] = 0.5 * (square * t - square)
    slopes[0] = 0.5 * (-1.0 + 4.0 * t - 3.0 * square)
    slopes[1] = 0.5 * (-10.0 * t + 9.0 * square)
    slopes[2] = 0.5 * (1.0 + 8.0 * t - 9.0 * square)
    slopes[3] = 0.5 * (3.0 * square - 2.0 * t)


@inner
def error_at(series, side, theta):
    """The error of a side and its derivative by the mesh phase θ."""
    value, slope = 0.0, 0.0
    for k in range(series.shape[1]):
        n = k + 1.0
        c, s = cos(n * theta), sin(n * theta)
        value += series[side, k, 0] * c + series[side, k, 1] * s
        slope += n * (series[side, k, 1] * c - series[side, k, 0] * s)
    return value, slope


@inner
def relief_at(relief, side, k, place, weights, slopes):
    """Relief of a slice and its derivative, at a place on the grid of roll lengths counted in its steps."""
    last = relief.shape[2] - 1
    t = min(max(place, 0.0), 1.0 * last)
    cell = min(int(t), last - 1)
    catmull_rom(t - cell, weights, slopes)
    value, slope = 0.0, 0.0
    for m in range(4):
        at = relief[side, k, min(max(cell + m - 1, 0), last)]
        value += weights[m] * at
        slope += slopes[m] * at
    return value, (slope if 0.0 < place < last else 0.0)


@inner
def mode_at(tables, side, m, k, turn_1, turn_2):
    """Outward normal displacement of a mode at a slice, and its derivative by the turn of its body."""
    body = tables.mode_body[m]
    n = 1.0 * tables.mode_order[m]
    psi = -turn_1 if body == 0 else np.pi - turn_2
    c, s = cos(n * psi), sin(n * psi)
    a, b = tables.mode_shape[side, m, k, 0], tables.mode_shape[side, m, k, 1]
    return a * c + b * s, n * (a * s - b * c)


@inner
def mode_gap(tables, side, k, q, sign):
    """How much the modes close the gaps of a slice, with the derivatives by both bodies' turns."""
    closed, by_1, by_2 = 0.0, 0.0, 0.0
    for m in range(tables.counts[MODES]):
        value, slope = mode_at(tables, side, m, k, sign * q[5], sign * q[11])
        closed += value * q[POSE + m]
        if tables.mode_body[m] == 0:
            by_1 += slope * q[POSE + m]
        else:
            by_2 += slope * q[POSE + m]
    return closed, by_1, by_2


@inner
def _frame(x, z, q, frame):
    """The centres of both gears in the plane of a slice: z from both bodies' middles, centre distance,
    direction of the line of centres, working pressure angle less its angle, tan α."""
    z1, z2 = z - q[2], z - q[8]
    ax = x[CENTRES] + q[6] + z2 * q[10] - q[0] - z1 * q[4]
    ay = q[7] - z2 * q[9] - q[1] + z1 * q[3]
    a, both = sqrt(ax * ax + ay * ay), x[BASE_1] + x[BASE_2]
    frame[0], frame[1], frame[2] = z1, z2, a
    frame[3], frame[4] = ax / a, ay / a
    frame[5] = np.arccos(both / a) - np.arctan2(ay, ax)
    frame[6] = sqrt(a * a - both * both) / both


@inner
def _beyond(e, first, second):
    """Gap of a tip corner beyond the end of its flank, and its derivative."""
    if e <= 0.0:
        return 0.0, 0.0
    return e * e * (first + e * second), e * (2.0 * first + 3.0 * e * second)


@inner
def _transverse(x, j, px, py, q, frame):
    """Gap of a pair of teeth in the plane of a slice, and its derivatives by the places on both flanks."""
    zeta_1 = frame[0] + q[4] * px - q[3] * py
    zeta_2 = frame[1] + q[10] * (px - x[CENTRES]) - q[9] * py
    rho_1 = x[ORIGIN_1] + j * x[PITCH] + x[BASE_1] * (q[5] + frame[5]) + x[TWIST] * zeta_1
    rho_2 = x[ORIGIN_2] - j * x[PITCH] + x[BASE_2] * (q[11] + frame[5]) - x[TWIST] * zeta_2
    g = (x[BASE_1] + x[BASE_2]) * frame[6] - rho_1 - rho_2
    more_1, slope_1 = _beyond(rho_1 - x[TIP_1], x[CORNER_1], x[CURVED_1])
    more_2, slope_2 = _beyond(rho_2 - x[TIP_2], x[CORNER_2], x[CURVED_2])
    return g + more_1 + more_2, slope_1 - 1.0, slope_2 - 1.0


@inner
def _derivatives(x, d1, d2, px, py, q, frame, row):
    """Of the gap normal to the flanks by the pose (12)."""
    b1, b2, gx, tangent = x[BASE_1], x[BASE_2], px - x[CENTRES], frame[6]
    by_angle = (b1 + b2) * (1.0 + tangent * tangent) + b1 * d1 + b2 * d2
    along, across = by_angle / (frame[2] * tangent), -(b1 * d1 + b2 * d2) / frame[2]
    tx = x[OBLIQUE] * (along * frame[3] - across * frame[4])  # by the gear's centre in this slice
    ty = x[OBLIQUE] * (along * frame[4] + across * frame[3])
    s1, s2 = x[OBLIQUE] * x[TWIST] * d1, -x[OBLIQUE] * x[TWIST] * d2  # by the axial places
    row[0], row[1], row[2] = -tx, -ty, tx * q[4] - ty * q[3] - s1
    row[3], row[4] = ty * frame[0] - s1 * py, -tx * frame[0] + s1 * px
    row[6], row[7], row[8] = tx, ty, -tx * q[10] + ty * q[9] - s2
    row[9], row[10] = -ty * frame[1] - s2 * py, tx * frame[1] + s2 * gx
    sine, cosine = sin(x[ANGLE]), cos(x[ANGLE])
    moving = s1 * (q[4] * sine - q[3] * cosine) + s2 * (q[10] * sine - q[9] * cosine)
    row[5] = b1 * (x[OBLIQUE] * d1 + moving)
    row[11] = x[OBLIQUE] * b2 * d2


@inner
def gaps(tables, side, sign, q, place, roll, gap, gradient, weights, slopes, frame):
    """Writes those that are closed (gap below 0): slot in the compliance, roll length of the pinion, gap, and
    its derivatives (12); returns how many there are, and the least gap of all.

    q (12 + modes), of the pair turned over for side 1 (``sign`` −1), modes as they are."""
    x, n_slices, count, nearest = tables.scalars, len(tables.slices), 0, 1e300
    theta = tables.counts[TEETH] * q[5]
    error, error_slope = error_at(tables.error, side, theta)
    error_slope *= tables.counts[TEETH]
    cycle = floor(theta / (2.0 * np.pi))
    sine, cosine = sin(x[ANGLE]), cos(x[ANGLE])
    low, high = max(x[PATH_START] - x[FAR_2], 0.02 * x[PITCH]), x[PATH_END] + x[FAR_1]
    for k in range(n_slices):
        z = tables.slices[k]
        _frame(x, z, q, frame)
        closed, turn_1, turn_2 = mode_gap(tables, side, k, q, sign)
        start = x[ORIGIN_1] + x[BASE_1] * (x[ANGLE] + q[5]) + x[TWIST] * z
        for j in range(ceil((low - start) / x[PITCH]), floor((high - start) / x[PITCH]) + 1):
            nominal = start + j * x[PITCH]
            px, py = x[BASE_1] * cosine + nominal * sine, -x[BASE_1] * sine + nominal * cosine
            across, d1, d2 = _transverse(x, j, px, py, q, frame)
            at = (nominal - x[RELIEF_START]) / x[RELIEF_STEP]
            relief, relief_slope = relief_at(tables.relief, side, k, at, weights, slopes)
            whole = x[OBLIQUE] * across + relief + error - closed
            nearest = min(nearest, whole)
            slot = (j + cycle - tables.counts[FIRST_PAIR]) * n_slices + k
            if whole < 0.0 and 0 <= slot < len(place):
                row = gradient[count]
                _derivatives(x, d1, d2, px, py, q, frame, row)
                row[5] += relief_slope * x[BASE_1] / x[RELIEF_STEP] + error_slope - sign * turn_1
                row[11] -= sign * turn_2
                gap[count], roll[count] = whole, nominal
                place[count] = slot
                count += 1
    return count, nearest
