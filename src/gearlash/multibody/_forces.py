"""Forces of the contacts on both bodies: what the dynamics call at every step."""

from __future__ import annotations

from math import floor, log

import numpy as np

from gearlash._kernel.jit import array_of, float64, inner, int64, kernel

from ._gaps import POSE, catmull_rom, gaps, mode_at
from ._load_sharing import flattening, share, solve
from ._tables import (
    BASE_1,
    BASE_2,
    CENTRES,
    DAMPING_TIME,
    HERTZ,
    HERTZ_DEPTH,
    LENGTH,
    MODES,
    OBLIQUE,
    PAIRS,
    PATH_END,
    PATH_START,
    PHASES,
    REACH,
    READ_1,
    TABLES,
    TANGENT,
    TEETH,
)

REPORT = 8
NO_MESH, TOO_DEEP, NO_FORCES = 1, 2, 3
WRITE_1, MATRIX = array_of(float64, 1), array_of(float64, 2)


@inner
def _meshes(x, q):
    """Whether all of it is numbers, and the axes are far enough from each other for a line of action."""
    for value in q:
        if not abs(value) < 1e12:
            return False
    tilt = abs(q[3]) + abs(q[4]) + abs(q[9]) + abs(q[10])
    nearer = abs(q[0]) + abs(q[6]) + x[CENTRES] * tilt
    return x[CENTRES] - nearer > 1.0001 * (x[BASE_1] + x[BASE_2])


@inner
def _lost(out, report, why):
    out[:] = np.nan
    report[:] = np.nan
    return why


@inner
def _turned(i):
    """Whether a coordinate changes its sign when the pair is turned over about the line of centres."""
    c = i % 6
    return c in (1, 2, 4, 5)


@inner
def _hertz(x, roll):
    """B − ½A ln R of the flattening at a roll length, and its derivative."""
    at = min(max(roll, x[PATH_START]), x[PATH_END])
    mate = x[TANGENT] - at
    curvature = at * mate / x[TANGENT] / x[OBLIQUE]
    slope = 0.0
    if x[PATH_START] < roll < x[PATH_END]:
        slope = -0.5 * x[HERTZ] * (1.0 / at - 1.0 / mate)
    return x[HERTZ_DEPTH] - 0.5 * x[HERTZ] * log(2.0 * x[HERTZ] * curvature), slope


@inner
def _phase(tables, turn, weights, slopes):
    """The first of four phases of the compliance around a turn of the pinion; their weights, and by how many
    phases one radian is."""
    cycles = turn * tables.counts[TEETH] / (2.0 * np.pi)
    at = (cycles - floor(cycles)) * tables.counts[PHASES]
    cell = min(int(at), tables.counts[PHASES] - 1)
    catmull_rom(at - cell, weights, slopes)
    return cell, tables.counts[PHASES] * tables.counts[TEETH] / (2.0 * np.pi)


@inner
def _gather(table, n, place, cell, weights, slopes, compliance, changing):
    """Compliance of n places on each other between two phases, and its derivative (lower triangle)."""
    for a in range(n):
        for b in range(a + 1):
            entry = table[place[a], place[b]]
            total, change = 0.0, 0.0
            for p in range(4):
                value = entry[cell + p]
                total += weights[p] * value
                change += slopes[p] * value
            compliance[a, b] = compliance[b, a] = total
            changing[a, b] = change


@inner
def _elastic(x, m, pushing, roll, depth, f, compliance, changing, rate):
    """Elastic energy, and the moment on the pinion by which the compliance changes with its turn."""
    energy, moment = 0.0, 0.0
    for i in range(m):
        a = pushing[i]
        w, _slope, work = flattening(x, depth[a], f[a])
        _, change = _hertz(x, roll[a])
        energy += f[a] * (w + 0.5 * compliance[a, a] * f[a]) - work
        moment += 0.5 * f[a] * f[a] * (change / x[LENGTH] * x[BASE_1] + rate * changing[a, a])
        for j in range(m):
            b = pushing[j]
            if b < a:
                energy += f[a] * compliance[a, b] * f[b]
                moment += rate * f[a] * changing[a, b] * f[b]
    return energy, moment


@inner
def _damp(tables, side, m, pushing, place, q, v, speed, gradient, factor, closing, damped):
    """damped ← forces of damping of the places that push: the rate at which their elastic forces would
    change, were the bodies to go on as they do, times the damping time."""
    for i in range(m):
        a = pushing[i]
        total = 0.0
        for c in range(POSE):
            total -= gradient[a, c] * speed[c]
        for mode in range(tables.counts[MODES]):
            value, _ = mode_at(tables, side, mode, place[a] % len(tables.slices), q[5], q[11])
            total += value * v[POSE + mode]
        closing[i], damped[i] = total, total
    solve(factor, m, damped)
    for i in range(m):
        damped[i] *= tables.scalars[DAMPING_TIME]


@inner
def _act(tables, side, sign, q, place, force, row, out):
    """Adds what one force does to the bodies and the modes."""
    for i in range(POSE):
        out[i] += (sign if _turned(i) else 1.0) * force * row[i]
    for mode in range(tables.counts[MODES]):
        value, _ = mode_at(tables, side, mode, place % len(tables.slices), q[5], q[11])
        out[POSE + mode] -= force * value


@kernel(int64(TABLES, READ_1, READ_1, WRITE_1, WRITE_1, MATRIX, MATRIX), allocates=True)
def contact_kernel(tables, q, v, out, report, memory, loads):
    """out (12 + modes) ← generalised forces; report (REPORT); memory (2, P S) where it has rows: elastic
    forces to begin with ← those found; loads, too: the force on every place. Not 0: why there are none."""
    x, most = tables.scalars, len(tables.slices) * tables.counts[PAIRS]
    pose, speed = np.empty(len(q)), np.empty(len(q))
    place, pushing = np.empty(most, np.int64), np.empty(most, np.int64)
    roll, gap, depth = np.empty(most), np.empty(most), np.empty(most)
    f, right, closing, column = np.empty(most), np.empty(most), np.zeros(most), np.empty(most)
    gradient = np.empty((most, POSE))
    weights, slopes, frame = np.empty(4), np.empty(4), np.empty(7)
    out[:] = 0.0
    report[:] = 0.0
    if not _meshes(x, q):
        return _lost(out, report, NO_MESH)
    for side in range(2):
        sign = 1.0 - 2.0 * side
        for i in range(len(q)):
            flip = sign if i < POSE and _turned(i) else 1.0
            pose[i], speed[i] = flip * q[i], flip * v[i]
        n, nearest = gaps(tables, side, sign, pose, place, roll, gap, gradient, weights, slopes, frame)
        report[6 + side] = nearest
        if nearest < -x[REACH]:
            return _lost(out, report, TOO_DEEP)
        if n == 0:
            continue
        cell, rate = _phase(tables, pose[5], weights, slopes)
        compliance, changing, factor = np.empty((n, n)), np.empty((n, n)), np.empty((n, n))
        _gather(tables.compliance, n, place, cell, weights, slopes, compliance, changing)
        for a in range(n):
            depth[a], _ = _hertz(x, roll[a])
        for a in range(n):
            f[a] = memory[side, place[a]] if len(memory) > 0 else 0.0
        m = share(x, n, gap, compliance, depth, f, factor, right, column, pushing)
        if m < 0:
            return _lost(out, report, NO_FORCES)
        if len(memory) > 0:
            memory[side, :] = 0.0
            for i in range(m):
                memory[side, place[pushing[i]]] = f[pushing[i]]
        energy, moment = _elastic(x, m, pushing, roll, depth, f, compliance, changing, rate)
        report[4] += energy
        out[5] += sign * moment
        right[:m] = 0.0
        if x[DAMPING_TIME] > 0.0:
            _damp(tables, side, m, pushing, place, q, v, speed, gradient, factor, closing, right)
        for i in range(m):
            a = pushing[i]
            force = max(f[a] + right[i], 0.0)  # it only pushes
            report[side] += force
            report[5] += (force - f[a]) * closing[i]
            if force > 0.0:
                report[2 + side] += 1.0
            if len(loads) > 0:
                loads[side, place[a]] = force
            _act(tables, side, sign, q, place[a], force, gradient[a], out)
    return 0
