"""The dimensionless families against the physical equations of motion, written out separately here in SI."""

from math import copysign, cos, radians, sin, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gearlash.gears import (
    HelicalPair,
    Projection,
    ToothGeometry,
    YAxis,
    equivalent_mass,
    helical,
    line_of_action,
    solid_disc,
    spur,
)
from gearlash.system import GearlashError, UnknownNameError, evaluate

GEOMETRY = ToothGeometry((28, 70), 4e-3, radians(20.0), radians(18.0))
MASSES = (5.98, 34.72)
BEARINGS = (8.0e8, 6.8e8, 4.0e8, 3.2e8)
K_MESH = 3.2e8
D_C = 50e-6
DEFAULTS = {
    "omega": 0.83,
    "D": 0.7,
    "load": 0.09,
    "ripple": 0.3,
    "ripple_phase": 0.4,
    "ripple_2": -0.11,
    "ripple_phase_2": 1.3,
    "error": 0.27,
    "error_phase": -0.7,
    "error_3": 0.02,
    "error_phase_3": 2.1,
    "mesh_damping": 0.07,
    "bearing_damping_yp": 0.01,
    "bearing_damping_zp": 0.02,
    "bearing_damping_yg": 0.03,
    "bearing_damping_zg": 0.04,
    "back_stiffness": 0.6,
    "back_gap": 1.4,
}


def pair_of(projection=Projection.PITCH, y_axis=YAxis.PITCH_TANGENT):
    """(HelicalPair, LineOfAction, m_e, inertias) of the article's gears."""
    line = line_of_action(GEOMETRY, projection, y_axis)
    inertias = tuple(solid_disc(m, r) for m, r in zip(MASSES, GEOMETRY.pitch_radii, strict=True))
    m_e = equivalent_mass(line.radii, (inertias[0], inertias[1]))
    omega_n = sqrt(K_MESH / m_e)
    kappa = [sqrt(k / m) / omega_n for k, m in zip(BEARINGS, np.repeat(MASSES, 2), strict=True)]
    pair = HelicalPair(
        rotation_factor=line.c_t**2,
        y_factor=line.c_y,
        z_factor=line.c_z,
        mass_ratios=(m_e / MASSES[0], m_e / MASSES[1]),
        bearing_frequencies=(kappa[0], kappa[1], kappa[2], kappa[3]),
    )
    return pair, line, m_e, inertias


def rhs(system, tau, z):
    """Right-hand side of the dimensionless system, straight from the definition of the class."""
    theta = system.omega * tau
    derivative = system.matrix @ z + np.array([evaluate(row, theta) for row in system.forcing])
    for c in system.clearances:
        x, speed = c.h @ z, c.h @ derivative  # h·g = 0, so the force does not enter X′
        gap = max(x - c.gap_plus, 0.0) * evaluate(c.stiffness_plus, theta)
        gap += min(x + c.gap_minus, 0.0) * evaluate(c.stiffness_minus, theta)
        derivative = derivative + c.g * (gap + c.damping * speed)
    return derivative


class PhysicalPair:
    """Newton's equations of both gears in SI: rotations, y, z one by one; nothing dimensionless inside."""

    def __init__(self, line, m_e, inertias, p):
        self.line, self.m_e, self.inertias, self.p = line, m_e, inertias, p
        self.omega_n = sqrt(K_MESH / m_e)
        self.mesh_rate = p["omega"] * self.omega_n
        self.c_mesh = 2 * p["mesh_damping"] * sqrt(K_MESH * m_e)
        # Torques that make the mean load what f_m says: f_m = c_t W / (k_m D_c).
        self.force = p["load"] * K_MESH * D_C / line.c_t

    def harmonics(self, stem):
        for n in (1, 2, 3):
            suffix = "" if n == 1 else f"_{n}"
            yield n, self.p.get(stem + suffix, 0.0), self.p.get(f"{stem}_phase{suffix}", 0.0)

    def error(self, t, order):
        """e(t), or its first derivative, m and m/s."""
        total = 0.0
        for n, amplitude, phase in self.harmonics("error"):
            angle, rate = n * self.mesh_rate * t + phase, n * self.mesh_rate
            total += D_C * amplitude * (cos(angle) if order == 0 else -rate * sin(angle))
        return total

    def mesh_force(self, t, q, v):
        """F_n of u, y, z (q = u, y_p, z_p, y_g, z_g) and velocities."""
        line = self.line
        along = np.array([line.c_t, line.c_y, line.c_z, -line.c_y, -line.c_z])
        x = along @ q - self.error(t, 0)
        speed = along @ v - self.error(t, 1)
        gap = D_C * self.p["D"]
        k = K_MESH * (1 + sum(a * cos(n * self.mesh_rate * t + f) for n, a, f in self.harmonics("ripple")))
        if x > gap:
            spring = k * (x - gap)
        elif x < -gap * self.p["back_gap"]:
            spring = k * self.p["back_stiffness"] * (x + gap * self.p["back_gap"])
        else:
            spring = 0.0
        return spring + self.c_mesh * speed, x, speed

    def accelerations(self, t, q, v):
        f, _, _ = self.mesh_force(t, q, v)
        (j_p, j_g), (r_p, r_g) = self.inertias, self.line.radii
        # Each gear turned by its own torque R W and held back by R c_t F; u = R_p θ_p − R_g θ_g.
        theta_p = (self.force * r_p - r_p * self.line.c_t * f) / j_p
        theta_g = (-self.force * r_g + r_g * self.line.c_t * f) / j_g
        result = [r_p * theta_p - r_g * theta_g]
        names = ("yp", "zp", "yg", "zg")
        for i, (name, sign) in enumerate(zip(names, (-1, -1, 1, 1), strict=True)):
            m, k = np.repeat(MASSES, 2)[i], BEARINGS[i]
            c = 2 * self.p[f"bearing_damping_{name}"] * sqrt(k * m)
            factor = self.line.c_y if name[0] == "y" else self.line.c_z
            result.append((sign * factor * f - c * v[1 + i] - k * q[1 + i]) / m)
        return np.array(result)

    def state(self, t, q, v):
        """The ten dimensionless states of a physical configuration."""
        _, x, speed = self.mesh_force(t, q, v)
        scale = self.omega_n * D_C
        lateral = np.column_stack([q[1:] / D_C, v[1:] / scale]).ravel()
        return np.append(lateral, [x / D_C, speed / scale])

    def second_error(self, t):
        return -sum(
            D_C * a * (n * self.mesh_rate) ** 2 * cos(n * self.mesh_rate * t + f)
            for n, a, f in self.harmonics("error")
        )

    def derivative(self, t, q, v):
        """d/dτ of the ten dimensionless states, from the SI accelerations."""
        a = self.accelerations(t, q, v)
        line = self.line
        along = np.array([line.c_t, line.c_y, line.c_z, -line.c_y, -line.c_z])
        x_dd = along @ a - self.second_error(t)
        rates = np.column_stack([v[1:] / (self.omega_n * D_C), a[1:] / (self.omega_n**2 * D_C)]).ravel()
        return np.append(rates, [self.state(t, q, v)[9], x_dd / (self.omega_n**2 * D_C)])


@pytest.mark.parametrize("y_axis", list(YAxis))
@pytest.mark.parametrize("projection", list(Projection))
def test_dimensionless_equations_are_newtons_in_every_region(projection, y_axis):
    pair, line, m_e, inertias = pair_of(projection, y_axis)
    family = helical.family(pair, DEFAULTS)
    physical = PhysicalPair(line, m_e, inertias, family.defaults)
    system = family.system()
    rng = np.random.default_rng(7)
    regions = set()
    for _ in range(200):
        t = rng.uniform(0, 0.02)
        q, v = D_C * rng.normal(size=5), D_C * physical.omega_n * rng.normal(size=5)
        z = physical.state(t, q, v)
        regions.add(int(z[8] > 0.7) - int(z[8] < -0.98))
        expected = physical.derivative(t, q, v)
        assert rhs(system, physical.omega_n * t, z) == pytest.approx(expected, rel=1e-11, abs=1e-11)
    assert regions == {-1, 0, 1}


def test_both_forms_integrate_to_the_same_motion():
    pair, line, m_e, inertias = pair_of()
    family = helical.family(pair, DEFAULTS)
    physical = PhysicalPair(line, m_e, inertias, family.defaults)
    system = family.system()
    end = 3 * system.period
    q0, v0 = D_C * np.array([1.1, 0.2, -0.1, 0.3, 0.1]), np.zeros(5)

    def newton(t, s):
        return np.append(s[5:], physical.accelerations(t, s[:5], s[5:]))

    si = solve_ivp(
        newton, (0, end / physical.omega_n), np.append(q0, v0), method="DOP853", rtol=1e-11, atol=1e-16
    )
    start = physical.state(0.0, q0, v0)
    own = solve_ivp(lambda t, z: rhs(system, t, z), (0, end), start, method="DOP853", rtol=1e-11, atol=1e-12)
    final = si.y[:, -1]
    assert physical.state(end / physical.omega_n, final[:5], final[5:]) == pytest.approx(
        own.y[:, -1], abs=1e-7
    )


@pytest.mark.parametrize("load", [0.1, -0.1])
def test_spur_equations_are_newtons(load):
    p = {"omega": 0.5, "D": 1.0, "load": load, "ripple": 0.2, "ripple_phase": 3.0, "error": 0.01,
         "error_2": 0.004, "mesh_damping": 0.05, "back_stiffness": 0.5, "rotation_factor": 0.81}  # fmt: skip
    family = spur.family(p)
    system = family.system()
    for tau, x, speed in ((0.3, 1.4, -0.2), (1.7, 0.3, 0.5), (5.0, -1.6, 0.1)):
        theta = 0.5 * tau
        eta = 1 + 0.2 * cos(theta + 3.0)
        spring = eta * (x - 1) if x > 1 else 0.5 * eta * (x + 1) if x < -1 else 0.0
        drive = 0.5**2 * (0.01 * cos(theta) + 4 * 0.004 * cos(2 * theta))
        expected = load + drive - 0.81 * (spring + 0.1 * speed)
        assert rhs(system, tau, np.array([x, speed])) == pytest.approx([speed, expected], rel=1e-14)


PITCH_LIST = (0.269, 0.291, 0.717, 0.960, 1.336)
LITERAL_LIST = (0.269, 0.290, 0.686, 0.960, 1.315)


@pytest.mark.parametrize(
    ("projection", "listed", "digits"),
    [
        (Projection.PITCH, PITCH_LIST, 5e-4),
        (Projection.BASE, PITCH_LIST, 5e-4),
        (Projection.MIXED, LITERAL_LIST, 6e-4),  # its third, 0.68545, is listed rounded up
    ],
)
def test_natural_frequencies_over_11201_are_the_listed_ones(projection, listed, digits):
    pair, _, m_e, _ = pair_of(projection)
    own = helical.natural_frequencies(pair) * sqrt(K_MESH / m_e) / 11201
    assert own == pytest.approx(listed, abs=digits)


def test_pitch_and_base_are_one_physical_system():
    results = []
    for projection in (Projection.PITCH, Projection.BASE):
        pair, _, m_e, _ = pair_of(projection)
        results.append(helical.natural_frequencies(pair) * sqrt(K_MESH / m_e))
    assert results[0] == pytest.approx(results[1], rel=1e-13)


def test_natural_frequencies_are_those_of_the_undamped_closed_system():
    pair, _, _, _ = pair_of()
    undamped = {"omega": 1.0, "D": 1.0, "load": 0.1}
    system = helical.family(pair, undamped).system()
    c = system.clearances[0]
    closed = system.matrix + np.outer(c.g, c.h)
    moduli = np.sort(np.abs(np.linalg.eigvals(closed).imag))[::2]
    assert helical.natural_frequencies(pair) == pytest.approx(moduli, rel=1e-10)
    assert np.linalg.eigvals(closed).real == pytest.approx(np.zeros(10), abs=1e-12)


def test_spur_natural_frequency_is_the_rotation_factor():
    assert spur.natural_frequencies(0.64) == pytest.approx([0.8])


def test_rows_of_the_matrix_hold_the_bearing_accelerations():
    pair, _, _, _ = pair_of()
    system = helical.family(pair, DEFAULTS).system()
    c_y, c_z = pair.y_factor, pair.z_factor
    rows = system.matrix
    assert rows[9] == pytest.approx(c_y * (rows[1] - rows[5]) + c_z * (rows[3] - rows[7]), rel=1e-15)
    mass = sum(pair.mass_ratios)
    assert system.clearances[0].g[9] == pytest.approx(
        -pair.rotation_factor - (c_y**2 + c_z**2) * mass, rel=1e-14
    )


@pytest.mark.parametrize("load", [0.09, -0.09])
def test_cold_start_presses_the_loaded_side(load):
    pair, _, _, _ = pair_of()
    family = helical.family(pair, {"omega": 1.0, "D": 0.8, "load": load})
    start = family.start()
    assert start[8] == copysign(0.8, load) + load / pair.rotation_factor
    assert np.count_nonzero(start) == 1


def test_negative_torque_mirrors_the_cold_start_and_the_motion():
    pair, _, _, _ = pair_of()
    symmetric = {**DEFAULTS, "back_stiffness": 1.0, "back_gap": 1.0}
    family = helical.family(pair, symmetric)
    flip = {"load": -0.09, "error": -0.27, "error_3": -0.02}
    assert family.start(flip) == pytest.approx(-family.start(), rel=1e-15)
    z = np.random.default_rng(3).normal(size=10)
    mirrored = rhs(family.system(flip), 2.2, -z)
    assert mirrored == pytest.approx(-rhs(family.system(), 2.2, z), rel=1e-13, abs=1e-15)


def test_cold_start_under_negative_load_uses_the_back_side():
    family = spur.family({"omega": 1.0, "D": 1.0, "load": -0.2, "back_gap": 1.5, "back_stiffness": 0.5})
    x = family.start()[0]
    assert x == -1.5 - 0.4
    mean = family.system().clearances[0]
    assert mean.stiffness_minus[0] * (x + mean.gap_minus) == pytest.approx(-0.2)  # in balance with the load
    assert family.start({"back_stiffness": 0.0})[0] == -1.5 - 0.2


def test_without_load_the_teeth_start_mid_gap():
    assert spur.family({"omega": 1.0, "D": 1.0, "load": 0.0}).start()[0] == 0.0


@pytest.mark.parametrize("D", [0.0, 0.25, 2.0])
def test_a_swept_gap_keeps_the_ratio_of_an_unequal_back_side(D):
    pair, _, _, _ = pair_of()
    clearance = helical.family(pair, DEFAULTS).system({"D": D}).clearances[0]
    assert (clearance.gap_plus, clearance.gap_minus) == (D, 1.4 * D)
    assert clearance.stiffness_minus == pytest.approx(0.6 * clearance.stiffness_plus, rel=1e-15)


def test_load_error_and_gap_leave_matrix_and_stiffness_alone():
    pair, _, _, _ = pair_of()
    family = helical.family(pair, DEFAULTS)
    one, other = family.system(), family.system({"load": 0.3, "error": 0.5, "D": 0.1})
    assert np.array_equal(one.matrix, other.matrix)
    assert np.array_equal(one.clearances[0].stiffness_plus, other.clearances[0].stiffness_plus)
    assert np.array_equal(one.clearances[0].g, other.clearances[0].g)


def test_common_bearing_damping_sets_all_four_and_one_alone_sets_one():
    pair, _, _, _ = pair_of()
    base = {"omega": 1.0, "D": 1.0, "load": 0.1, "bearing_damping": 0.02}
    family = helical.family(pair, base)
    kappa = np.array(pair.bearing_frequencies)
    diagonal = [1, 3, 5, 7]

    def ratios(**overrides):
        matrix = family.system(overrides).matrix
        return -np.diag(matrix)[diagonal] / (2 * kappa)

    assert ratios() == pytest.approx([0.02] * 4)
    assert ratios(bearing_damping=0.0) == pytest.approx([0.0] * 4)
    assert ratios(bearing_damping_yg=0.05) == pytest.approx([0.02, 0.02, 0.05, 0.02])
    with pytest.raises(GearlashError, match=r"named twice.*bearing_damping_yg"):
        family.system({"bearing_damping": 0.03, "bearing_damping_yg": 0.05})


def test_four_different_bearings_have_no_common_damping_to_vary():
    pair, _, _, _ = pair_of()
    with pytest.raises(UnknownNameError, match="bearing_damping_"):
        helical.family(pair, DEFAULTS).complete({"bearing_damping": 0.1})


def test_harmonics_follow_the_names_given():
    names = {p.name for p in spur.family({"omega": 1, "D": 1, "load": 0.1, "error_3": 0.1}).parameters}
    assert {"error", "error_2", "error_phase_2", "error_3", "ripple"} <= names
    assert "ripple_2" not in names


def test_unknown_or_missing_defaults_are_named():
    with pytest.raises(GearlashError, match="bearing_damping"):
        spur.family({"omega": 1, "D": 1, "load": 0.1, "bearing_damping": 0.1})
    with pytest.raises(GearlashError, match="load"):
        spur.family({"omega": 1, "D": 1})


def test_values_out_of_range_are_refused():
    family = spur.family({"omega": 1, "D": 1, "load": 0.1})
    for bad in (
        {"omega": 0.0},
        {"D": -0.1},
        {"mesh_damping": -0.01},
        {"ripple": 2.5},
        {"load": float("nan")},
    ):
        with pytest.raises(GearlashError, match=next(iter(bad))):
            family.complete(bad)
