"""Forces between the teeth: they have a potential, they only push, and they are those of the statics."""

from __future__ import annotations

import pickle
from math import cos

import numpy as np
import pytest

from gearlash.gears.materials import named
from gearlash.gears.tooth_pair import ToothLoad, contact_compliance
from gearlash.multibody.contact import WHY, MeshContact, RimModes, contact_forces, new_memory
from gearlash.multibody.topography import Topography
from gearlash.system import GearlashError
from multibody.meshes import contact, helical, jolted, plain, pose, spur
from multibody.standin import Standin

STILL = np.zeros(12)
STEPS = np.tile([1e-8, 1e-8, 1e-8, 1e-7, 1e-7, 1e-7], 2)
DRIVING, BACK = 12e-6, -12e-6


def approach(mesh: MeshContact, pressed: float) -> float:
    """From rest until one side is pressed by so much."""
    return np.sign(pressed) * (0.5 * mesh.flanks.play + abs(pressed))


@pytest.mark.parametrize("name", ["helical", "spur"])
@pytest.mark.parametrize("pressed", [DRIVING, BACK])
def test_the_forces_are_the_gradient_of_the_elastic_energy(name: str, pressed: float):
    mesh = plain(name)
    for seed, turn in enumerate((0.01, 0.11, 0.2, -0.35, 1e3)):
        q = jolted(mesh, turn, approach(mesh, pressed), seed)
        steps = np.diag(STEPS)
        slope = [mesh.details(q - d, STILL).energy - mesh.details(q + d, STILL).energy for d in steps]
        found = mesh.details(q, STILL)
        assert found.normal[0 if pressed > 0 else 1] > 100.0
        assert found.normal[1 if pressed > 0 else 0] == 0.0
        assert np.allclose(
            np.array(slope) / (2.0 * STEPS),
            found.forces,
            rtol=0.0,
            atol=2e-5 * found.normal[0 if pressed > 0 else 1],
        )


@pytest.mark.parametrize("name", ["helical", "spur"])
def test_stiffness_is_reciprocal(name: str):
    mesh = plain(name)
    q = jolted(mesh, 0.07, approach(mesh, DRIVING), 3)
    columns = [(mesh.forces(q + d, STILL) - mesh.forces(q - d, STILL)) for d in np.diag(STEPS)]
    stiffness = -np.array(columns).T / (2.0 * STEPS)
    scale = np.sqrt(np.abs(np.outer(np.diag(stiffness), np.diag(stiffness))))
    assert np.abs(stiffness - stiffness.T).max() / scale.max() < 1e-5
    assert (np.abs(stiffness - stiffness.T) < 1e-3 * scale).all()


@pytest.mark.parametrize("name", ["helical", "spur"])
def test_a_closed_loop_does_no_work(name: str):
    """Half a mesh cycle of the pinion is in the loop, both sides of the teeth, tilts and shifts."""
    mesh = plain(name)
    play, pitch = 0.5 * mesh.flanks.play, mesh.flanks.phase_pitch
    amplitude = np.tile([4e-6, 4e-6, 4e-6, 4e-5, 4e-5, 0.0], 2)
    phase = np.random.default_rng(5).uniform(0.0, 6.0, 12)
    angles = 2.0 * np.pi * np.arange(400) / 400

    def at(angle: float):
        q = pose(mesh, 0.25 * pitch * np.sin(angle), (play + 15e-6) * np.cos(angle + 0.4))
        return q + amplitude * np.sin(angle + phase)

    eps = 1e-6
    power = []
    for angle in angles:
        rate = (at(angle + eps) - at(angle - eps)) / (2.0 * eps)
        power.append(float(mesh.forces(at(angle), STILL) @ rate))
    done = np.array(power)
    assert np.abs(done).max() > 0.01
    assert abs(done.sum()) < 1e-4 * np.abs(done).sum()


@pytest.mark.jit_and_nojit
def test_side_by_side_and_turned_over_are_the_same():
    """Half a turn of the whole pair about the line of centres changes sides and nothing else."""
    mesh = plain("helical")
    turned = np.tile([1.0, -1.0, -1.0, 1.0, -1.0, -1.0], 2)
    q = jolted(mesh, 0.09, approach(mesh, DRIVING), 8)
    here, there = mesh.details(q, STILL), mesh.details(turned * q, STILL)
    assert here.normal == there.normal[::-1]
    assert here.pushing == there.pushing[::-1]
    assert np.allclose(turned * here.forces, there.forces, rtol=1e-12, atol=1e-12)


def test_a_whole_turn_is_where_it_began():
    mesh = plain("helical")
    teeth = mesh.flanks.pair.pinion.teeth
    reference = mesh.forces(pose(mesh, 0.013, approach(mesh, DRIVING)), STILL)
    for cycles in (1, -1, teeth, 70 * teeth):
        turn = 0.013 + cycles * mesh.flanks.phase_pitch
        assert np.allclose(
            mesh.forces(pose(mesh, turn, approach(mesh, DRIVING)), STILL), reference, rtol=1e-7
        )


@pytest.mark.parametrize("name", ["helical", "spur"])
def test_forces_balance_and_turn_by_the_base_radii(name: str):
    """Moments of one normal force; corners off the line of action turn by a little more or less."""
    mesh = plain(name)
    oblique = cos(mesh.flanks.base_helix)
    moments = []
    for turn in np.arange(24) / 24 * mesh.flanks.phase_pitch:
        found = mesh.details(pose(mesh, float(turn), approach(mesh, DRIVING)), STILL)
        force = found.forces
        assert np.allclose(force[:2], -force[6:8], rtol=0.0, atol=1e-9 * found.normal[0])
        moments.append(force[[5, 11]] / (found.normal[0] * oblique) / mesh.flanks.base_radii)
    assert np.allclose(moments, -1.0, atol=0.03)
    assert np.allclose(np.mean(moments, axis=0), -1.0, atol=2e-3)


def test_it_only_pushes():
    damped = contact(helical(), damping_time=2e-5)
    q = pose(damped, 0.02, approach(damped, DRIVING))
    apart, together = np.zeros(12), np.zeros(12)
    apart[11], together[11] = -8.0, 0.02
    opening, closing = damped.details(q, apart), damped.details(q, together)
    assert (opening.loads >= 0.0).all()
    assert opening.normal == (0.0, 0.0)
    assert closing.normal[0] > damped.details(q, STILL).normal[0]
    assert closing.dissipation > 0.0
    power = (closing.forces - damped.details(q, STILL).forces) @ together
    assert power == pytest.approx(-closing.dissipation, rel=1e-9)


def test_far_apart_there_is_nothing():
    mesh = plain("helical")
    found = mesh.details(STILL, STILL)
    assert found.normal == (0.0, 0.0)
    assert not found.forces.any()
    assert found.nearest == pytest.approx((0.5 * mesh.flanks.play,) * 2, rel=1e-9)


def test_tables_go_to_other_processes_and_the_plain_call_is_the_same():
    mesh = plain("helical")
    tables = pickle.loads(pickle.dumps(mesh.tables))
    q = pose(mesh, 0.05, approach(mesh, DRIVING))
    out, report = np.empty(12), np.empty(8)
    assert contact_forces(tables, q, STILL, out, report) == 0
    assert np.array_equal(out, mesh.forces(q, STILL))
    assert report[0] == mesh.details(q, STILL).normal[0]


def test_another_topography_and_damping_leave_the_compliance():
    mesh = plain("helical")
    error = Topography(error=((3e-6, 0.4, 1), (1e-6, 0.0, 2)))
    changed = mesh.with_(damping_time=1e-5, topography=error)
    made = contact(helical(), damping_time=1e-5, topography=error)
    q = jolted(mesh, 0.03, approach(mesh, DRIVING), 1)
    assert changed.tables.compliance is mesh.tables.compliance
    assert np.array_equal(changed.forces(q, 1e-3 * q), made.forces(q, 1e-3 * q))
    theta = mesh.flanks.pair.pinion.teeth * q[5]
    opened = 3e-6 * np.cos(theta + 0.4) + 1e-6 * np.cos(2.0 * theta)
    before, after = mesh.details(q, STILL).nearest, changed.details(q, STILL).nearest
    assert np.subtract(after, before) == pytest.approx([opened, -opened], abs=1e-15)


def test_what_is_remembered_changes_the_time_only():
    """Into contact, on through two mesh cycles, apart, and on the other side."""
    mesh = contact(helical(), damping_time=1e-5)
    memory, one, other, report = new_memory(mesh.tables), np.empty(12), np.empty(12), np.empty(8)
    for step, pressed in enumerate(np.r_[np.linspace(-2e-6, 15e-6, 40), np.linspace(15e-6, -5e-6, 10)]):
        for sign in (1.0, -1.0):
            q = pose(mesh, 0.01 * step, sign * (0.5 * mesh.flanks.play + pressed))
            assert contact_forces(mesh.tables, q, 0.01 * q, one, report, memory) == 0
            assert contact_forces(mesh.tables, q, 0.01 * q, other, report) == 0
            assert np.allclose(one, other, rtol=1e-7, atol=1e-6)


def moving(mesh: MeshContact) -> MeshContact:
    """With modes of both bodies that bend the rims by waves, and one without waves."""
    rng = np.random.default_rng(3)
    shape = rng.normal(size=(2, 4, len(mesh.tables.slices), 2)) * 1e-2
    modes = RimModes(np.array([0, 1, 1, 1]), np.array([2, 2, 2, 0]), shape)
    return contact(mesh.flanks.pair, modes=modes, damping_time=1e-5)


@pytest.mark.parametrize("pressed", [DRIVING, BACK])
def test_modes_move_the_flanks_and_are_moved(pressed: float):
    mesh = moving(plain("helical"))
    amplitude = 1e-4 * np.array([1.0, -0.6, 0.4, 0.2])
    q = np.append(jolted(mesh, 0.21, approach(mesh, pressed), 2), amplitude)
    still, steps = np.zeros(16), np.append(STEPS, [1e-7] * 4)
    slope = [mesh.details(q - d, still).energy - mesh.details(q + d, still).energy for d in np.diag(steps)]
    found = mesh.details(q, still)
    assert np.abs(found.forces[12:]).min() > 0.1
    assert np.allclose(np.array(slope) / (2.0 * steps), found.forces, rtol=0.0, atol=1e-5 * sum(found.normal))
    speed = np.zeros(16)
    speed[12:] = 0.01
    power = (mesh.forces(q, speed) - found.forces) @ speed
    assert power == pytest.approx(-mesh.details(q, speed).dissipation, rel=1e-9)


def test_an_outward_rim_closes_the_gap():
    mesh = plain("helical")
    shape = np.zeros((2, 1, len(mesh.tables.slices), 2))
    shape[:, 0, :, 0] = 1.0  # all around, both sides of the teeth
    breathing = contact(helical(), modes=RimModes(np.array([1]), np.array([0]), shape))
    q = np.append(np.zeros(12), 7e-6)
    assert np.subtract(breathing.details(q, 0.0 * q).nearest, mesh.details(STILL, STILL).nearest) == (
        pytest.approx([-7e-6, -7e-6], abs=1e-15)
    )


@pytest.mark.jit_and_nojit
@pytest.mark.parametrize("pressed", [0.5e-6, 3e-6, 20e-6])
def test_the_flattening_is_that_of_weber_and_banaschek(pressed: float):
    """Rigid teeth: what is left is the approach of one line of contact to the other."""
    pair = spur()
    depth = 0.5 * pair.pinion.normal_module
    rigid = Standin(np.array([0.0, 0.1]), np.array([-0.01, 0.01]), np.zeros((1, 4, 4)), depth)
    mesh = contact(pair, compliances=(rigid, rigid), slices=1)
    found = mesh.details(pose(mesh, 0.02, approach(mesh, pressed)), STILL)
    rolls = mesh.rolls(0.02 / mesh.flanks.phase_pitch)
    on_path = (rolls > pair.path_of_contact[0]) & (rolls < pair.path_of_contact[1])
    load, steel = ToothLoad(0.0, 0.0, depth), named("steel")
    assert on_path.any()
    for roll, force in zip(rolls[on_path], found.loads[0][on_path], strict=True):
        line_load = float(force) / pair.face_width
        curvature = mesh.flanks.relative_curvature(float(roll))
        compliance = contact_compliance((load, load), curvature, line_load, (steel, steel))
        assert compliance * line_load == pytest.approx(pressed, rel=1e-9)


def test_what_has_no_answer_says_so():
    mesh = plain("helical")
    out, report = np.empty(12), np.empty(8)
    bad, near = np.zeros(12), np.zeros(12)
    bad[4], near[6] = np.nan, -0.02
    deep = pose(mesh, 0.0, 0.5 * mesh.flanks.play + 100e-6)
    for q, word in ((bad, "line of action"), (near, "line of action"), (deep, "tip corners")):
        assert contact_forces(mesh.tables, q, STILL, out, report) in WHY
        assert np.isnan(out).all()
        assert np.isnan(report).all()
        with pytest.raises(GearlashError, match=word):
            mesh.forces(q, STILL)


@pytest.mark.parametrize("body", [0, 1])
@pytest.mark.parametrize("pressed", [DRIVING, BACK])
def test_a_mode_that_is_a_rigid_displacement_does_what_that_does(body: int, pressed: float):
    """One wave around the rim, radially cos ψ and along it −sin ψ: the body moved along its own x axis."""
    mesh = plain("helical")
    angle, oblique = mesh.flanks.pair.working_pressure_angle, cos(mesh.flanks.base_helix)
    shape = np.zeros((2, 1, len(mesh.tables.slices), 2))
    shape[:, 0, :, 0] = oblique * np.sin(angle)
    shape[0, 0, :, 1], shape[1, 0, :, 1] = -oblique * np.cos(angle), oblique * np.cos(angle)
    one = contact(helical(), modes=RimModes(np.array([body]), np.array([1]), shape))
    changes = []
    for begins in (0.4, 1.9, 3.1):
        q = pose(mesh, begins, approach(mesh, pressed))
        moved, turn = q.copy(), q[6 * body + 5]
        own = np.array([np.cos(turn), np.sin(turn)])
        moved[6 * body : 6 * body + 2] = 2e-6 * own
        rigid, bent = mesh.details(moved, STILL), one.details(np.append(q, 2e-6), np.zeros(13))
        assert bent.normal == pytest.approx(rigid.normal, rel=3e-3)
        along = rigid.forces[6 * body : 6 * body + 2] @ own
        assert bent.forces[12] == pytest.approx(along, rel=3e-3, abs=3e-3 * sum(rigid.normal))
        changes.append(abs(sum(bent.normal) / sum(mesh.details(q, STILL).normal) - 1.0))
    assert max(changes) > 0.05
