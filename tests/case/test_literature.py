"""The bundled systems from the literature: their numbers against what was derived by hand."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import eigh

import gearlash as gl
from gearlash.case import Case, load, loads
from gearlash.case.kinds.piecewise.values import closed_frequencies
from gearlash.system import ContactRule, System

FOUR = ("shaw-holmes", "blankenship-kahraman", "geared-rotor", "two-stage")


def system(name: str, **values: float) -> System:
    return load(name).family()[0].system(values)


def rate(system: System, z: np.ndarray, theta: float) -> np.ndarray:
    """z' at a state and phase (of the base period), from the definition of the class."""

    def value(series: np.ndarray, angle: float) -> np.ndarray:
        n = np.arange(1, (series.shape[-1] - 1) // 2 + 1)
        return series[..., 0] + series[..., 1::2] @ np.cos(n * angle) + series[..., 2::2] @ np.sin(n * angle)

    out = system.matrix @ z + value(system.forcing, theta)
    for c in system.clearances:
        x, speed = c.h @ z, c.h @ system.matrix @ z
        plus, minus = max(0.0, x - c.gap_plus), min(0.0, x + c.gap_minus)
        force = value(c.stiffness_plus, theta) * plus + value(c.stiffness_minus, theta) * minus
        if c.contact is ContactRule.ALWAYS or x > c.gap_plus or x < -c.gap_minus:
            force += c.damping * speed
        out = out + c.g * force
    return out


@pytest.mark.parametrize("name", FOUR)
def test_each_names_its_source_and_gives_a_reason_for_what_it_did_not_read(name: str):
    case = load(name)
    assert str(case.source["doi"]).startswith("10.")
    assert case.source["title"]
    assert case.source["authors"]
    assert case.description
    for v in case.values():
        assert v.provenance in ("given", "derived") or v.reason, v.path
        assert v.description or v.reason, v.path


@pytest.mark.parametrize("name", FOUR)
def test_contact_forces_act_on_no_velocity_of_a_gap(name: str):
    own = system(name)
    assert [[float(c.h @ k.g) for k in own.clearances] for c in own.clearances] == [
        [0.0] * len(own.clearances)
    ] * len(own.clearances)


# ---- the bilinear oscillator


def test_bilinear_oscillator_changes_its_slope_at_the_stop():
    own = system("shaw-holmes", gap=0.4, stop_stiffness=3.0, zeta=0.1, force=0.7, omega=1.3, stop_damping=0.2)
    assert len(own.clearances) == 1
    assert own.clearances[0].contact is ContactRule.IN_CONTACT
    for x, v, theta in ((0.1, 1.0, 0.3), (-5.0, 2.0, 1.0), (0.5, -1.0, 2.0)):
        spring = x + (3.0 * (x - 0.4) + 0.2 * v if x > 0.4 else 0.0)
        expected = [v, -2 * 0.1 * v - spring + 0.7 * np.cos(theta)]
        assert rate(own, np.array([x, v]), theta) == pytest.approx(expected, abs=1e-14)


def test_bilinear_oscillator_has_its_two_frequencies():
    own = system("shaw-holmes")
    assert closed_frequencies(own) == pytest.approx([3.0], rel=1e-14)
    assert np.abs(np.linalg.eigvals(own.matrix)) == pytest.approx([1.0, 1.0], rel=1e-14)
    assert not own.clearances[0].stops(-1)


def test_bilinear_oscillator_away_from_its_stop_is_the_linear_one():
    case = load("shaw-holmes", {"gap": 50, "clearance.stop.contact": "always", "omega": 0.5})
    family, _ = case.family()
    found = gl.attractor(gl.propagators(family.system()), family.start())
    assert isinstance(found, gl.Orbit)
    assert found.signature.short == "1-0"
    response = 1.0 / (1.0 - 0.5**2 + 2j * 0.05 * 0.5)  # x = Re(response exp(iθ))
    assert found.state == pytest.approx([response.real, -0.5 * response.imag], abs=1e-11)


def test_bilinear_oscillator_scales_with_the_force_when_the_gap_is_closed():
    small, large = (load("shaw-holmes", {"force": f, "clearance.stop.contact": "always"}) for f in (1.0, 3.0))
    states = []
    for case in (small, large):
        family, _ = case.family()
        found = gl.attractor(gl.propagators(family.system()), family.start())
        assert isinstance(found, gl.Orbit)
        states.append(found.state)
    assert states[1] == pytest.approx(3.0 * states[0], abs=1e-10)


# ---- one degree of freedom, three stiffness harmonics

AS_PIECEWISE = """
kind = "piecewise-linear"
states = ["X", "X'"]
[parameters]
omega = 0.9
load = 0.1
[matrix]
X = { "X'" = 1 }
[forcing]
"X'" = "load"
[[clearance]]
name = "mesh"
h = { X = 1 }
g = { "X'" = -1 }
gap_plus = 1
gap_minus = 1
stiffness_plus = { mean = 1, amplitudes = [0.3, 0.1, 0.05] }
stiffness_minus = { mean = 1, amplitudes = [0.3, 0.1, 0.05] }
damping = 0.1
"""


def test_pair_with_three_harmonics_is_its_equation():
    own = system("blankenship-kahraman")
    assert own.clearances[0].stiffness_plus == pytest.approx([1, 0.3, 0, 0.1, 0, 0.05, 0], abs=1e-16)
    for x, v, theta in ((1.3, 0.2, 0.4), (0.2, -1.0, 2.0), (-1.5, 0.5, 5.0)):
        kappa = 1 + 0.3 * np.cos(theta) + 0.1 * np.cos(2 * theta) + 0.05 * np.cos(3 * theta)
        dead = x - 1 if x > 1 else x + 1 if x < -1 else 0.0
        expected = [v, 0.1 - 2 * 0.05 * v - kappa * dead]
        assert rate(own, np.array([x, v]), theta) == pytest.approx(expected, abs=1e-14)


def test_pair_with_three_harmonics_is_the_same_written_in_plain_arrays():
    one, other = system("blankenship-kahraman"), loads(AS_PIECEWISE).family()[0].system()
    assert np.array_equal(one.matrix, other.matrix)
    assert one.forcing[:, 0] == pytest.approx(other.forcing[:, 0], abs=1e-17)
    assert not one.forcing[:, 1:].any()
    a, b = one.clearances[0], other.clearances[0]
    assert (a.gap_plus, a.gap_minus, a.damping, a.contact) == (b.gap_plus, b.gap_minus, b.damping, b.contact)
    assert np.array_equal(a.h, b.h)
    assert np.array_equal(a.g, b.g)
    assert a.stiffness_plus == pytest.approx(b.stiffness_plus, abs=1e-16)
    start = np.array([1.1, 0.0])
    orbits = [gl.attractor(gl.propagators(each), start) for each in (one, other)]
    assert isinstance(orbits[0], gl.Orbit)
    assert isinstance(orbits[1], gl.Orbit)
    assert orbits[0].state == pytest.approx(orbits[1].state, abs=1e-11)


# ---- the geared rotor

ROTOR = {"mu_1": 0.5, "mu_2": 0.2, "kappa_1": 1.3, "kappa_2": 0.6, "mesh_damping": 0.04, "load": 0.3}


def test_geared_rotor_is_three_bodies_pulled_by_their_springs():
    """Against Newton's equations in (y1, y2, u) with u = R_p θ_p − R_g θ_g, p = u + y1 − y2 − E."""
    own = system(
        "geared-rotor", **ROTOR, zeta_1=0.03, zeta_2=0.07, force_1=0.2, force_2=-0.1, error=0.06, omega=0.8
    )
    random = np.random.default_rng(1)

    def dead(x: float, gap: float) -> float:
        return x - gap if x > gap else x + gap if x < -gap else 0.0

    for z in random.normal(size=(20, 6)) * 1.5:
        y1, v1, y2, v2, p, w = z
        theta = random.uniform(0.0, 2.0 * np.pi)
        force = (1.0 + 0.2 * np.cos(theta)) * dead(p, 1.0) + 2 * 0.04 * w
        a1 = 0.2 - 2 * 0.03 * 1.3 * v1 - 1.3**2 * dead(y1, 0.1) - 0.5 * force
        a2 = -0.1 - 2 * 0.07 * 0.6 * v2 - 0.6**2 * dead(y2, 0.1) + 0.2 * force
        relative = 0.3 - force  # u''
        error = 0.06 * 0.8**2 * np.cos(theta)  # -E'' of E = 0.06 cos θ
        expected = [v1, a1, v2, a2, w, relative + a1 - a2 + error]
        assert rate(own, z, theta) == pytest.approx(np.array(expected), abs=1e-13)


def test_geared_rotor_has_the_frequencies_of_its_masses_and_springs():
    own = system("geared-rotor", **(ROTOR | {"mesh_damping": 0.0}), zeta_1=0.0, zeta_2=0.0)
    mass = np.diag([1 / 0.5, 1 / 0.2, 1.0])  # over the equivalent mass of rotation: y1, y2, u
    mesh = np.array([1.0, -1.0, 1.0])
    stiffness = np.outer(mesh, mesh) + np.diag([1.3**2 / 0.5, 0.6**2 / 0.2, 0.0])
    expected = np.sqrt(eigh(stiffness, mass, eigvals_only=True))
    assert closed_frequencies(own) == pytest.approx(expected, rel=1e-12)


def test_geared_rotor_rests_under_its_load():
    family, _ = load("geared-rotor").family()
    still = family.complete({"ripple": 0.0, "error": 0.0})
    assert rate(family.build(still), family.cold_start(still), 1.0) == pytest.approx(np.zeros(6), abs=1e-15)


# ---- the two-stage train


def train(radii: tuple[float, ...], inertias: tuple[float, ...], torque: float) -> dict[str, float]:
    """Parameters of physical bodies, k1 = 1, unit of length 1; time over sqrt(m1/k1)."""
    (r1, r2, r3, r4), (j1, j2, j3) = radii, inertias
    m1, m2 = 1 / (r1**2 / j1 + r2**2 / j2), 1 / (r3**2 / j2 + r4**2 / j3)
    return {"gamma": m1 * r2 * r3 / j2, "mu": m1 / m2, "rho": r2 / r3, "load": torque / r1}


def test_two_stage_train_is_three_shafts_turned_by_their_teeth():
    radii, inertias, torque = (1.0, 1.8, 1.1, 2.0), (0.7, 2.5, 4.0), 0.35
    own = system(
        "two-stage", **train(radii, inertias, torque), kappa=1.3, zeta=0.04, zeta_2=0.06, error_1=0.0,
        ripple_1=0.25, ripple_2=0.15, phase=0.7,
    )  # fmt: skip
    (r1, r2, r3, r4), (j1, j2, j3) = radii, inertias
    m1 = 1 / (r1**2 / j1 + r2**2 / j2)
    t3 = torque * r2 / r1 * r4 / r3  # the torque that keeps the mean speed
    random = np.random.default_rng(2)
    for z in random.normal(size=(20, 4)) * 1.5:
        p1, v1, p2, v2 = z
        theta = random.uniform(0.0, 2.0 * np.pi)  # of the base period: three cycles of mesh 1, two of mesh 2
        eta = 1 + 0.25 * np.cos(3 * theta), 1.3 * (1 + 0.15 * np.cos(2 * theta + 0.7))
        dead = [p - 1 if p > 1 else p + 1 if p < -1 else 0.0 for p in (p1, p2)]
        f1, f2 = eta[0] * dead[0] + 0.08 * v1, eta[1] * dead[1] + 0.12 * v2
        spin1, spin2, spin3 = (torque - r1 * f1) / j1, (r2 * f1 - r3 * f2) / j2, (r4 * f2 - t3) / j3
        accelerations = m1 * (r1 * spin1 - r2 * spin2), m1 * (r3 * spin2 - r4 * spin3)
        expected = np.array([v1, accelerations[0], v2, accelerations[1]])
        assert rate(own, z, theta) == pytest.approx(expected, abs=1e-13)


def test_two_stage_train_has_two_frequencies_in_closed_form():
    own = system("two-stage", zeta=0.0, zeta_2=0.0)
    gamma, mu, kappa = 0.4, 0.8, 1.2
    mean, product = (1 + mu * kappa) / 2, kappa * (mu - gamma**2)
    expected = np.sqrt([mean - np.sqrt(mean**2 - product), mean + np.sqrt(mean**2 - product)])
    assert closed_frequencies(own) == pytest.approx(expected, rel=1e-13)


def test_two_stage_train_is_driven_at_both_tooth_passing_frequencies():
    own = system("two-stage", error_1=0.05, error_2=0.03, phase=0.4, omega=0.6)
    assert own.cycles == 3
    assert own.period == pytest.approx(3 * 2 * np.pi / 0.6, rel=1e-15)
    first, second = own.forcing[1], own.forcing[3]
    assert np.flatnonzero(first[1:]).tolist() == [4]  # cos of order 3
    assert first[5] == pytest.approx(0.05 * 0.36, rel=1e-14)
    slower = 0.03 * 0.4**2  # the second mesh at 2/3 of the frequency of the first
    assert second[3:5] == pytest.approx([slower * np.cos(0.4), -slower * np.sin(0.4)], rel=1e-14)


def test_two_stage_train_rests_under_its_load():
    family, _ = load("two-stage").family()
    still = family.complete({"ripple_1": 0.0, "ripple_2": 0.0, "error_1": 0.0})
    assert rate(family.build(still), family.cold_start(still), 1.0) == pytest.approx(np.zeros(4), abs=1e-15)


# ---- all of them move


def linear_motion(own: System, rest: np.ndarray) -> np.ndarray:
    """State at phase 0 of the motion about a state of rest that meets no boundary, by complex amplitudes."""
    step = 1e-6 * np.eye(own.size)
    still = rate(own, rest, 0.0)
    jacobian = np.array([(rate(own, rest + e, 0.0) - still) / 1e-6 for e in step]).T
    state = rest.copy()
    for order in range(1, (own.forcing.shape[1] - 1) // 2 + 1):
        amplitude = own.forcing[:, 2 * order - 1] - 1j * own.forcing[:, 2 * order]
        rotation = 1j * order * own.omega / own.cycles * np.eye(own.size)
        state += np.linalg.solve(rotation - jacobian, amplitude).real
    return state


@pytest.mark.parametrize(
    ("name", "values"),
    [
        ("geared-rotor", {"ripple": 0.0, "error": 0.02, "error_phase": 0.4}),
        ("two-stage", {"ripple_1": 0.0, "ripple_2": 0.0, "error_1": 0.01, "error_2": 0.02, "phase": 0.7}),
    ],
)
def test_with_every_contact_closed_the_motion_is_the_linear_one(name: str, values: dict[str, float]):
    family, _ = load(name).family()
    own, rest = family.system(values), family.start(values)
    found = gl.attractor(gl.propagators(own), rest)
    assert isinstance(found, gl.Orbit)
    assert found.status == "ok"
    assert found.period == own.cycles
    assert found.state == pytest.approx(linear_motion(own, rest), abs=1e-8)  # of the quotients of differences


@pytest.mark.parametrize("name", [*FOUR])
def test_each_moves_as_its_file_says(name: str):
    family, _ = load(name).family()
    found = gl.attractor(gl.propagators(family.system()), family.start())
    assert isinstance(found, gl.Orbit)
    assert found.status == "ok"
    assert found.stable


def test_a_stop_without_damping_knows_no_difference_between_two_rules():
    states = []
    for rule in ("always", "in-contact"):
        family, _ = load("shaw-holmes", {"clearance.stop.contact": rule}).family()
        found = gl.attractor(gl.propagators(family.system()), family.start())
        assert isinstance(found, gl.Orbit)
        states.append(found.state)
    assert states[0] == pytest.approx(states[1], abs=1e-11)


@pytest.mark.parametrize("name", FOUR)
def test_each_travels_as_json(name: str):
    case = load(name, {"omega": 0.77})
    again = Case.from_json(case.to_json())
    assert (again, again.hash) == (case, case.hash)
    one, other = (each.family()[0].system() for each in (case, again))
    assert np.array_equal(one.forcing, other.forcing)
    assert [c.g.tolist() for c in one.clearances] == [c.g.tolist() for c in other.clearances]
