"""`gearlash.gears` and the assembly that judges the flow are two ways to the same arrays."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash import gears
from oracles.pairs import KINDS, Bodies, Mesh, helical, random_bodies, random_mesh, spur


def _values(mesh: Mesh) -> dict[str, float]:
    values = {
        "omega": mesh.omega,
        "D": mesh.gap_plus,
        "load": mesh.load,
        "mesh_damping": mesh.damping / 2,
        "back_stiffness": mesh.back_stiffness,
        "back_gap": mesh.gap_minus / mesh.gap_plus,
    }
    for stem in ("ripple", "error"):
        both = zip(getattr(mesh, stem), getattr(mesh, f"{stem}_phase"), strict=True)
        for order, (amplitude, phase) in enumerate(both, start=1):
            suffix = "" if order == 1 else f"_{order}"
            values |= {f"{stem}{suffix}": amplitude, f"{stem}_phase{suffix}": phase}
    return values


def _pair(bodies: Bodies) -> gears.HelicalPair:
    return gears.HelicalPair(
        rotation_factor=bodies.c_t**2,
        y_factor=bodies.c_y,
        z_factor=bodies.c_z,
        mass_ratios=(1 / bodies.mass[0], 1 / bodies.mass[1]),
        bearing_frequencies=bodies.kappa,
    )


def _same(one, other) -> None:
    (c,), (d,) = one.clearances, other.clearances
    assert one.omega == other.omega
    for mine, theirs in (
        (one.matrix, other.matrix),
        (one.forcing, other.forcing),
        (c.h, d.h),
        (c.g, d.g),
        (c.stiffness_plus, d.stiffness_plus),
        (c.stiffness_minus, d.stiffness_minus),
        ([c.gap_plus, c.gap_minus, c.damping], [d.gap_plus, d.gap_minus, d.damping]),
    ):
        assert np.abs(np.subtract(mine, theirs)).max() < 1e-14


@pytest.mark.parametrize("kind", KINDS)
def test_same_arrays(kind):
    rng = np.random.default_rng(KINDS.index(kind))
    for _ in range(5):
        mesh, bodies = random_mesh(rng, kind), random_bodies(rng)
        values = _values(mesh)
        damping = dict(zip(("yp", "zp", "yg", "zg"), bodies.xi, strict=True))
        each = {f"bearing_damping_{name}": ratio for name, ratio in damping.items()}
        _same(gears.helical.family(_pair(bodies), values | each).system(), helical(mesh, bodies))
        _same(gears.spur.family(values).system(), spur(mesh))
