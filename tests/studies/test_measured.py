"""What is measured on a pair, against its equations of motion in SI units, integrated by DOP853."""

from __future__ import annotations

from math import pi, sqrt
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import gearlash as gl
from gearlash.orbits.signals import signals
from gearlash.results.pair_units import PairUnits
from gearlash.studies.history import CYCLES, PER_CYCLE, history, spectrum
from gearlash.studies.measured import measured, readouts_of
from gearlash.studies.point import summary

DRIVE = Path(__file__).resolve().parents[1] / "cases" / "drive.toml"
STEPS = 20_000  # of a mesh cycle, so that corners of the force are met


class Drive:
    """The pair of drive.toml in SI units: five coordinates, written from its file alone."""

    pinion, gear = (2.6, 4e8, 2e8), (8.5, 3e8, 1.5e8)  # mass, stiffness along y and z
    stiffness, ripple, error, gap = 4e8, 0.12, 8e-6, 40e-6
    module, teeth, alpha, beta = 3e-3, (25, 57), np.deg2rad(20.0), np.deg2rad(15.0)
    torque = 150.0

    def __init__(self, rpm: float):
        self.radii = [self.module * z / (2.0 * np.cos(self.beta)) for z in self.teeth]
        inertias = [m * r * r / 2.0 for m, r in zip((2.6, 8.5), self.radii, strict=True)]
        self.mass = 1.0 / sum(r * r / j for r, j in zip(self.radii, inertias, strict=True))
        self.c_t = np.cos(self.alpha) * np.cos(self.beta)
        self.c_y, self.c_z = self.c_t, np.sin(self.beta) * np.cos(self.alpha)
        self.load = self.torque / self.radii[0]
        self.frequency = 2.0 * pi * rpm / 60.0 * self.teeth[0]
        self.damping = 2.0 * 0.05 * sqrt(self.stiffness * self.mass)
        masses = [self.pinion[0]] * 2 + [self.gear[0]] * 2
        self.masses, springs = np.array(masses), np.array([*self.pinion[1:], *self.gear[1:]])
        self.springs, self.dampers = springs, 2.0 * 0.02 * np.sqrt(springs * self.masses)
        self.directions = np.array([self.c_y, self.c_z, -self.c_y, -self.c_z])

    def read(self, t: np.ndarray, z: np.ndarray):
        """Gap x and its rate, mesh force, bearing forces, transmission error c_t u; z: (10, m)."""
        q, dq, u, du = z[:4], z[4:8], z[8], z[9]
        phase = self.frequency * t
        e, de = self.error * np.cos(phase + pi / 2), -self.error * self.frequency * np.sin(phase + pi / 2)
        x = self.c_t * u + self.directions @ q - e
        dx = self.c_t * du + self.directions @ dq - de
        beyond = np.where(x > self.gap, x - self.gap, np.where(x < -self.gap, x + self.gap, 0.0))
        force = self.stiffness * (1.0 + self.ripple * np.cos(phase)) * beyond + self.damping * dx
        return x, dx, force, self.springs[:, None] * q + self.dampers[:, None] * dq, self.c_t * u

    def rate(self, t: float, z: np.ndarray) -> np.ndarray:
        read = self.read(np.array([t]), z[:, None])
        force, bearings = (part[..., 0] for part in read[2:4])
        pushed = (-self.directions * force - bearings) / self.masses
        turned = (self.load - self.c_t * force) / self.mass
        return np.concatenate([z[4:8], pushed, [z[9], turned]])


def started(drive: Drive, case: gl.Case, state: np.ndarray) -> np.ndarray:
    """A dimensionless state at phase zero in SI."""
    length, rate = float(case.scales.length_um(1.0)) * 1e-6, float(case.scales.velocity(1.0))
    q, dq, x, dx = length * state[0:8:2], rate * state[1:8:2], length * state[8], rate * state[9]
    e, de = drive.error * np.cos(pi / 2), -drive.error * drive.frequency * np.sin(pi / 2)
    u = (x + e - drive.directions @ q) / drive.c_t
    return np.concatenate([q, dq, [u, (dx + de - drive.directions @ dq) / drive.c_t]])


@pytest.mark.parametrize("rpm", [4200.0, 3927.0])
def test_signals_are_those_of_the_equations_of_motion_in_si(rpm: float):
    case = gl.load_case(DRIVE, {"pinion_speed": f"{rpm} rpm"})
    family, _ = case.family()
    orbit = gl.attractor(family.system(), family.start())
    assert isinstance(orbit, gl.Orbit)
    found = signals(orbit.trace, readouts_of(case, family.complete()))
    units, drive = PairUnits.of(case), Drive(rpm)
    period = 2.0 * pi / drive.frequency
    times = np.linspace(0.0, period, STEPS + 1)
    ran = solve_ivp(
        drive.rate, (0.0, period), started(drive, case, orbit.state), "DOP853", times,
        rtol=1e-11, atol=1e-13, max_step=period / 400,
    )  # fmt: skip
    x, dx, force, bearings, error = drive.read(times, ran.y)
    assert float(abs(ran.y[:, -1] - ran.y[:, 0]).max()) < 1e-9  # it closes
    checks = [(found.force, units.force.factor, force), (found.gap, units.length.factor, 1e6 * x)]
    checks += [(one, units.force.factor, row) for one, row in zip(found.read[:4], bearings, strict=True)]
    checks.append((found.read[4], units.length.factor, 1e6 * error))
    for one, factor, row in checks:
        span, mean = float(np.ptp(row)), float(row[:-1].mean())
        rms = float(np.sqrt(((row[:-1] - mean) ** 2).mean()))
        assert factor * one.mean == pytest.approx(mean, abs=1e-5 * span)
        assert factor * one.rms == pytest.approx(rms, abs=1e-5 * span)
        assert factor * one.least == pytest.approx(row.min(), abs=2e-5 * span)
        assert factor * one.most == pytest.approx(row.max(), abs=2e-5 * span)
    free = float((x[:-1] < drive.gap).mean())
    assert found.share_without_contact == pytest.approx(free, abs=2.0 / STEPS)
    hits = np.flatnonzero((x[:-1] < drive.gap) & (x[1:] >= drive.gap))
    hit = max(abs(dx[hits]), default=0.0)
    assert units.velocity.factor * found.impact_velocity == pytest.approx(1e3 * hit, rel=2e-3)
    assert found.back_velocity == 0.0


def test_the_static_parts_are_what_equilibrium_says():
    case = gl.load_case(DRIVE)
    family, scales = case.family()
    found = signals(gl.attractor(family.system(), family.start()).trace, readouts_of(case, family.complete()))
    normal = Drive(4200.0).load / Drive(4200.0).c_t
    assert float(scales.force_N(found.force.mean)) == pytest.approx(normal, rel=1e-12)
    along_y = [abs(float(scales.force_N(found.read[i].mean))) for i in (0, 2)]
    assert along_y == pytest.approx([Drive(4200.0).load] * 2, rel=1e-12)


def test_a_motion_that_both_directions_find_is_measured_once_and_told_twice():
    case = gl.load_case("kahraman-singh")
    ways = gl.sweeps(case, gl.Axis.even("omega", 0.7, 0.9, 5), ["up", "down"])
    (up, down), whole = measured(case, ways, gl.Execution())
    assert whole
    same = [gl.same_motion(a, b) for a, b in zip(*(way.points for way in ways), strict=True)]
    assert [a is b for a, b in zip(up, down, strict=True)] == same
    assert False in same
    for way, row in zip(ways, (up, down), strict=True):
        for point, one in zip(way.points, row, strict=True):
            assert one is not None
            assert one.force.most == pytest.approx(point.force_max, abs=1e-8)
            assert one.gap.least == pytest.approx(point.minimum, abs=1e-8)


def test_a_spectrum_has_the_power_of_its_history_and_the_lines_of_a_tone():
    case = gl.load_case("kahraman-singh")
    point = gl.point(case, {"omega": 0.9}, name="omega")
    found = history(case, {}, point)
    lines = spectrum(found)
    for row, rms in zip(found.values, lines.rms, strict=True):
        assert np.sum(rms[1:] ** 2) == pytest.approx(row.var(), rel=1e-6)
    assert found.signals.read[0].rms ** 2 == pytest.approx(np.sum(lines.rms[2, 1:] ** 2), rel=1e-4)
    assert len(found.phase) == PER_CYCLE * point.period


def test_an_aperiodic_motion_is_sampled_under_a_window():
    case = gl.load_case("kahraman-singh")
    point = summary(gl.attractor(case.family()[0].system({"omega": 0.9}), case.family()[0].start()))
    lines = spectrum(history(case, {}, gl.Point(**{**vars(point), "value": 0.9, "period": 0})))
    exact = spectrum(history(case, {}, gl.Point(**{**vars(point), "value": 0.9})))
    assert lines.window == "Hann"
    assert exact.window == ""
    at = CYCLES * np.arange(1, 6)  # of a periodic motion the lines stand at whole orders
    assert lines.rms[0, at] == pytest.approx(exact.rms[0, 1:6], rel=1e-6)
