"""A verification from a case to its answer: short motions, and a compliance without finite elements."""

from __future__ import annotations

import json
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from gearlash.case.kinds.gears.kind import GearContent
from gearlash.cli.answers.verify import VerifyAnswer, verify_answer
from gearlash.cli.show.verify import spans, stays, verify_view
from gearlash.gears import backlash
from gearlash.multibody import (
    Bearings,
    Machine,
    MeshContact,
    Modes,
    Reading,
    Relief,
    RigidBody,
    Solver,
    Topography,
    Trajectory,
    natural_frequencies,
    read_motion,
    simulate,
)
from gearlash.multibody import _tables as places
from gearlash.multibody.quasi_static import quasi_static
from gearlash.multibody.tooth_contact import ToothContact
from gearlash.studies.verification import (
    DISTANCE_HELD,
    Plan,
    Seen,
    Setting,
    Verification,
    inputs_of,
    seen_of_label,
    sensitivity,
    verification,
)
from gearlash.studies.verification.lumped import lumped_family
from gearlash.studies.verification.mesh import modified
from gearlash.studies.verification.point import _fine_enough, _to_fade, fastest, machine_of, run_point
from gearlash.studies.verification.whole import all_errors, errors_of
from multibody.standin import standins

SHORT = Setting(steps=64, finer=1, finest=1, settle=4, read=16, longest=1)
CASES = Path(__file__).parents[1] / "cases"


@pytest.fixture(scope="module")
def found() -> Verification:
    plan = Plan(
        planned=SHORT,
        everywhere=(replace(SHORT, name="rigid gear", flexible=False),),
        beside=(
            replace(SHORT, name="held", held="centre-line"),
            replace(SHORT, name=DISTANCE_HELD.name, held=DISTANCE_HELD.held),
        ),
        window=replace(SHORT, name="window", settle=2),
        window_over=(0.95, 1.0, 2),
    )
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("gearlash.multibody.compliance.pair_compliances", standins)
        return verification(gl.load_case("article"), plan=plan)


@pytest.mark.slow
def test_every_point_of_the_plan_is_there(found: Verification):
    assert found.reason == ""
    assert found.failures == ()
    assert [one.configuration.name for one in found.compared] == ["stiffness", "dimensionless", "absolute"]
    for i, one in enumerate(found.compared):
        assert [p.omega for p in one.points] == list(one.configuration.omegas)
        assert len(one.beside) == (2, 4, 6)[i]
        assert sorted(p.omega for p in one.up) == sorted(p.omega for p in one.down) == list(one.window_omegas)
        assert len(one.lumped) == 6
    assert [p.label for p in found.stated] == ["1-1-0", "1-0-0"]


def test_what_is_held_is_held(found: Verification):
    case, inputs = found.compared, found.inputs
    first, dimensionless, absolute = (one.configuration for one in case)
    numbers = [one.numbers(inputs) for one in (first, dimensionless)]
    assert first.stiffness == pytest.approx(inputs.mean_stiffness, rel=5e-3)
    for name in ("error over static deflection", "half backlash over static deflection"):
        assert numbers[0][name] == pytest.approx(numbers[1][name], rel=5e-3)
    assert (absolute.torque, absolute.error) == (inputs.torque, inputs.error)
    speeds = [p.rpm for p in case[2].points]
    assert speeds == pytest.approx([3600.0, 4000.0], rel=1e-9)


def test_the_stiffness_of_each_way_is_that_of_its_teeth_under_its_torque(found: Verification):
    """Real teeth are stiffer the more they carry: what is held over stiffness needs that at work."""
    assert found.meshes[2].stiffness > 1.01 * found.meshes[1].stiffness
    for mesh, one in zip((found.meshes[0], found.meshes[2], found.meshes[1]), found.compared, strict=True):
        turned = quasi_static(mesh.perfect, one.configuration.torque, phases=len(mesh.static.phase))
        assert one.configuration.stiffness == pytest.approx(turned.mean_stiffness, rel=1e-3)
        assert one.given.ripples == pytest.approx([turned.ripple(n)[0] for n in (1, 2, 3)], rel=1e-2)


def test_mean_force_is_the_torque_over_the_base_radius(found: Verification):
    for one in found.compared:
        pinion = found.inputs.pair.pinion
        force = one.configuration.torque / (0.5 * pinion.base_diameter * np.cos(pinion.base_helix_angle))
        assert one.points[1].reading.mean == pytest.approx(force, rel=0.25)  # far from settled


def test_answer_lists_every_input_and_setting(found: Verification):
    answer = verify_answer(gl.load_case("article"), found)
    assert answer.status == "ok"
    assert answer.sentence.startswith("article: whether real teeth part is as the case says ")
    assert {"torque", "backlash", "errors", "pinion.thickness_allowance", "centre_distance"} <= set(
        answer.inputs
    )
    assert [setting["name"] for setting in answer.settings] == [
        "as planned",
        "window",
        "rigid gear",
        "bearings as stated",
        "held",
        "centre distance held",
    ]
    assert set(answer.settings[0]) == {each.name for each in fields(Setting)}
    assert isinstance(answer, VerifyAnswer)
    text = "\n".join(line.plain for line in verify_view(answer, 100))
    assert "There is no friction" in text
    assert "contact kept" in text
    assert json.dumps(answer.configurations[0].window.up)


@pytest.mark.parametrize(("flexible", "pinion"), [(False, False), (True, False), (True, True)])
def test_no_energy_is_lost_or_made_between_real_teeth(found: Verification, flexible: bool, pinion: bool):
    """Involute flanks that part and meet again, with the steps of a verification."""
    mesh, inputs = found.meshes[0], found.inputs
    errors = ((inputs.error, 0.0),)
    contact = mesh.contact(inputs, errors=errors, flexible=flexible, flexible_pinion=pinion)
    point = run_point(
        inputs,
        ToothContact(contact.tables),
        Setting(settle=1, read=1, longest=1, flexible=flexible, flexible_pinion=pinion),
        omega=inputs.speeds[0],
        stiffness=mesh.stiffness,
        torque=0.3 * inputs.torque,
        modes=mesh.modes(flexible, pinion),
    )
    assert 0.3 < point.reading.apart < 0.8
    assert point.reading.drive_impacts >= 1
    assert point.energy_residual < 1e-4


@pytest.mark.slow
def test_two_solvers_and_two_steps_agree_between_real_teeth_on_a_gear_that_bends(found: Verification):
    """The width of the case, apart once a mesh cycle; on its way the damping jumps and Newton fails."""
    mesh, absolute = found.meshes[1], found.compared[2].configuration
    contact = mesh.contact(found.inputs, errors=errors_of(found.inputs, mesh), flexible=True)
    explicit, implicit, coarse = (
        run_point(
            found.inputs,
            ToothContact(contact.tables),
            Setting(steps=steps, finer=1, finest=1, settle=80, read=16, solver=solver),
            omega=absolute.omegas[0],
            stiffness=mesh.stiffness,
            torque=absolute.torque,
            modes=mesh.modes(flexible=True),
        ).reading
        for solver, steps in ((Solver.RK44, 192), (Solver.GENERALIZED_ALPHA, 192), (Solver.RK44, 96))
    )
    for one in (explicit, implicit, coarse):
        assert str(one.label) == "1-1-0"
        assert one.least == 0.0
        assert one.mean == pytest.approx(found.inputs.mean_force, rel=3e-3)
    assert implicit.most == pytest.approx(explicit.most, rel=5e-3)
    assert coarse.most == pytest.approx(explicit.most, rel=0.02)


def test_real_teeth_are_damped_as_the_mesh_of_the_case_is(found: Verification):
    """Their force grows by 2 ξ_m √(k m_e) for each m/s of approach, in the mean of a mesh cycle."""
    inputs, mesh = found.inputs, found.meshes[1]
    teeth, speed, forces = ToothContact(mesh.contact(inputs).tables), 1e-4, []
    reach = 0.5 * inputs.pair.pinion.base_diameter * np.cos(inputs.pair.pinion.base_helix_angle)
    for phase, deflection in zip(mesh.static.phase, mesh.static.deflection, strict=True):
        q, v = np.zeros((2, 12))
        turn = 2.0 * np.pi * phase / inputs.pair.pinion.teeth
        q[5] = turn + (0.5 * inputs.backlash + deflection) / reach
        q[11] = -turn * inputs.pair.pinion.teeth / inputs.pair.gear.teeth
        v[5] = speed / reach
        forces.append([-teeth.forces(0.0, q, rate)[5] / reach for rate in (0.0 * v, v)])
    still, closing = np.mean(forces, axis=0)
    assert still == pytest.approx(inputs.mean_force, rel=0.01)
    expected = 2.0 * inputs.mesh_damping * np.sqrt(mesh.stiffness * inputs.mesh_mass)
    assert (closing - still) / speed == pytest.approx(expected, rel=0.01)


@pytest.mark.slow
def test_the_moment_of_moving_teeth_is_the_torque_in_the_mean(found: Verification):
    """Their mean force misses T/(r_b cos β_b): it does work on the error and on the compliance, too."""
    inputs, mesh, absolute = found.inputs, found.meshes[1], found.compared[2].configuration
    teeth, cycles = ToothContact(mesh.contact(inputs, errors=errors_of(inputs, mesh)).tables), 16
    pressed = run_point(
        inputs,
        teeth,
        Setting(steps=192, finer=1, finest=1, settle=80, read=cycles, flexible=False),
        omega=absolute.omegas[1],
        stiffness=mesh.stiffness,
        torque=absolute.torque,
    )
    speed = absolute.omegas[1] * inputs.natural_frequency(mesh.stiffness) / inputs.pair.pinion.teeth
    period = 2.0 * np.pi / (inputs.pair.pinion.teeth * speed)
    machine = machine_of(inputs, Setting(), absolute.torque, speed, period, Modes())
    motion = simulate(machine, teeth, pressed.q, pressed.v, step=period / 192, steps=192 * cycles)
    moments = [-teeth.forces(*state)[5] for state in zip(motion.t, motion.q, motion.v, strict=True)]
    assert np.trapezoid(moments, motion.t) / np.ptp(motion.t) == pytest.approx(absolute.torque, rel=1e-3)
    assert pressed.reading.mean == pytest.approx(inputs.mean_force, rel=3e-3)


def test_breathing_is_that_of_the_motion(found: Verification):
    """Backlash grows by 2 Δa sin α_wt cos β_b; where the centre distance is held it does not change."""
    one = found.compared[2]
    told = verify_answer(gl.load_case("article"), found).configurations[2].breathing
    pair = found.inputs.pair
    gain = 2.0 * np.sin(pair.working_pressure_angle) * np.cos(pair.pinion.base_helix_angle)
    for point, moved in zip(one.points, told, strict=True):
        change, play = np.diff(moved.centre_distance)[0], np.diff(moved.backlash)[0]
        assert change > 1.0
        assert play == pytest.approx(gain * change, rel=1e-3)
        assert moved.contact_ratio[1] > moved.contact_ratio[0]
        held = next(p for p in one.beside if p.setting == DISTANCE_HELD.name and p.omega == point.omega)
        assert held.centre_change == (0.0, 0.0)
        assert moved.peak_share == pytest.approx(point.reading.most / held.reading.most - 1.0)


def test_frames_are_poses_of_the_last_cycle(found: Verification):
    """The way by which the gear is ahead is that of the motion, whatever number of pitches went by."""
    pair = found.inputs.pair
    first, second = (0.5 * gear.base_diameter for gear in pair.gears)
    for point in found.compared[2].points:
        frames = point.frames
        assert np.diff(frames.phase) == pytest.approx(1.0 / 6.0, abs=0.02)
        assert np.all(np.abs(frames.turns) < 0.3)
        ahead = first * frames.turns[:, 0] + second * frames.turns[:, 1]
        assert np.all(np.abs(ahead) < 300e-6)
        shown = np.interp(1.0 + frames.phase, point.reading.phase, point.reading.force)
        assert frames.forces[:, 0] - frames.forces[:, 1] == pytest.approx(shown, abs=0.1 * shown.max())


def test_lumped_orders_are_those_of_its_force(found: Verification):
    for point in found.compared[2].lumped:
        if point.label == "1-0-0":
            assert point.order == pytest.approx(np.arange(1.0, 9.0))
            half_range = 0.5 * np.ptp(point.force)
            assert 0.7 * half_range < point.amplitude[0] < 1.3 * half_range
        if point.label == "aperiodic":
            assert len(point.order) == 0


def test_inputs_are_those_of_the_case():
    inputs = inputs_of(gl.load_case("article"), (1.0,))
    assert backlash.of_pair(inputs.pair).normal == pytest.approx(100e-6, rel=1e-9)
    assert inputs.rpm(1.0471283052204245, inputs.mean_stiffness) == pytest.approx(4000.0, rel=1e-9)


def test_bearings_grow_with_the_mesh_where_dimensionless_numbers_are_held(found: Verification):
    """In both models; without that, as a setting beside."""
    case, one = gl.load_case("article"), found.compared[1]
    grown = one.configuration.stiffness / found.inputs.mean_stiffness
    assert [each.configuration.bearings for each in found.compared] == [1.0, grown, 1.0]
    own, scaled = case.family()[0].system(), lumped_family(case, one.given, gl.ContactRule.ALWAYS).system()
    lateral, axial = [1, 5], [3, 7]  # κ² of each bearing in the rates of the states: over the mesh they stay
    for row in (*lateral, *axial):
        assert scaled.matrix[row, row - 1] == pytest.approx(own.matrix[row, row - 1], rel=1e-9)
    stiffness = [
        machine_of(found.inputs, setting, 1.0, 1.0, 1.0, Modes(), grown).bearings[0].stiffness
        for setting in (SHORT, replace(SHORT, bearings_as_stated=True))
    ]
    assert np.array(stiffness[0]) == pytest.approx(grown * np.array(stiffness[1]))
    assert {p.setting for p in one.beside} == {"rigid gear", "bearings as stated"}


def test_what_flanks_make_of_the_error_under_load_goes_to_the_lumped_model(found: Verification):
    """F/k + e is the static error under load, in its first three harmonics."""
    mesh = modified(found.meshes[1], Relief(40e-6, 40e-6, 6e-3, 6e-3, crowning=20e-6))
    theta = 2.0 * np.pi * mesh.static.phase
    waves = [
        r * np.cos(n * theta + p) for n, r, p in zip((1, 2, 3), mesh.ripples, mesh.ripple_phases, strict=True)
    ]
    error = sum((e * np.exp(1j * n * theta)).real for n, e in enumerate(mesh.static_errors, start=1))
    static = mesh.static.force / (mesh.stiffness * (1.0 + sum(waves))) + error
    for n in (1, 2, 3):
        amplitude, phase = mesh.static.error_harmonic(n)
        assert mesh.static.error_harmonic(n, static) == pytest.approx((amplitude, phase), rel=1e-6)
    errors = all_errors(found.inputs, mesh)
    given = replace(found.compared[2].given, errors=errors)
    values = lumped_family(gl.load_case("article"), given, gl.ContactRule.ALWAYS).complete()
    assert values["error_2"] * 50e-6 == pytest.approx(abs(mesh.static_errors[1]))
    ((amplitude, phase),) = errors_of(found.inputs, mesh)
    assert errors[0] == pytest.approx(amplitude * np.exp(1j * phase) + mesh.static_errors[0])


def test_stated_relief_materials_and_bodies_are_used():
    stated = {"pinion.tip_relief": "20 um", "pinion.tip_relief_length": "3 mm", "gear.crowning": "8 um"}
    case = gl.load_case(CASES / "drawing.toml", stated)
    inputs = inputs_of(case, (1.0,))
    assert isinstance(case.content, GearContent)
    drawing = case.content.completed.drawing
    assert drawing is not None
    assert inputs.modification == drawing.modification
    assert inputs.modification.modified
    assert inputs.materials == drawing.chosen_materials
    width = inputs.pair.face_width
    plain = MeshContact.of(inputs.pair, standins(inputs.pair, (width, width)), slices=3)
    shaped = plain.with_(topography=Topography(modification=inputs.modification))
    off = shaped.tables.relief - plain.tables.relief
    width, x = inputs.pair.face_width, plain.tables.scalars
    rolls = x[places.RELIEF_START] + x[places.RELIEF_STEP] * np.arange(off.shape[2])
    expected = inputs.modification.gap(inputs.pair, rolls, plain.tables.slices[0] / width)
    assert off[0, 0] == pytest.approx(expected, abs=1e-15)
    assert off.max() > 15e-6


def test_what_is_the_same_is_said_of_each_thing(found: Verification):
    """A motion that stays in contact without repeating is the same as 1-0-0 in all but the label."""
    assert seen_of_label("1-0-0") == Seen(False, False, "1-0-0")
    assert seen_of_label("3-4-1") == Seen(True, True, "3-4-1")
    assert seen_of_label("aperiodic") == Seen(True, None, "")
    assert seen_of_label("unresolved") == Seen(None, None, "")
    only = found.compared[2]
    point = only.points[1]
    quiet = replace(
        point, reading=replace(point.reading, label=None, apart=0.0, back_impacts=0, most_back=0.0)
    )
    one = replace(only, points=(quiet,), configuration=replace(only.configuration, omegas=(quiet.omega,)))
    said = verify_answer(
        gl.load_case("article"), replace(found, compared=(one,), stated=(found.stated[1],))
    ).sentence
    assert "whether real teeth part is as the case says with these inputs" in said
    assert "whether their back sides touch with these inputs" in said
    assert "the periodic label not with these inputs" in said


def test_settings_beside_change_one_thing_each():
    planned = Setting()
    for setting in sensitivity(planned):
        changed = [f.name for f in fields(Setting) if getattr(setting, f.name) != getattr(planned, f.name)]
        assert len(changed) == 2
        assert changed[0] == "name"


@pytest.mark.parametrize("turns", [100.0, 300.0, 500.0, 600.0, 900.0, 1200.0])
def test_half_of_a_step_is_half_of_the_planned_one_also_where_that_is_shortened(turns: float):
    """Rad by which the fastest vibration turns in a mesh cycle: above 288 the planned step is shortened."""
    planned = _fine_enough(Setting(), turns)
    half = _fine_enough(next(each for each in sensitivity() if each.name == "step / 2"), turns)
    assert planned.steps == 192 * max(1, int(np.ceil(turns / 288.0)))
    assert half.steps == 2 * planned.steps
    assert (half.finer, half.finest) == (planned.finer, planned.finest)


def test_speeds_in_contact_are_told_as_runs():
    assert spans((1.0, 2.0, 3.0, 4.0), ("1-1-0", "1-0-0", "2-0-0", "1-1-0")) == "2 to 3 rpm"
    assert spans((1.0, 2.0), ("1-1-0", "none")) == "nowhere on the grid"
    assert spans((1.0, 2.0), ("1-0-0", "kept")) == "1 to 2 rpm"


@pytest.mark.parametrize(("period", "impacts"), [(1, 1), (2, 1), (3, 2)])
def test_label_counts_beginnings_of_contact_in_a_period(period: int, impacts: int):
    t = np.linspace(0.0, 24.0, 24 * 128 + 1)
    q = np.zeros((len(t), 12))
    q[:, 5] = 2.0 * np.pi * t / 28
    force = np.full(len(t), 1.0)
    for k in range(impacts):
        force[np.abs((t + 0.2 * k) % period - 0.5) < 0.05] = 0.0
    motion = Trajectory(t, q, np.zeros_like(q), np.outer(force, [100.0, 0, 0, 0, 0]))
    reading = read_motion(motion, 28)
    assert reading.label == gl.Signature(period, impacts, 0)
    assert reading.apart == pytest.approx(0.1 * impacts / period, abs=0.01)


def _read(force: np.ndarray, cycles: float = 20.5) -> Reading:
    t = np.linspace(0.0, cycles, len(force))
    q = np.zeros((len(t), 12))
    q[:, 5] = 2.0 * np.pi * t / 28
    return read_motion(Trajectory(t, q, np.zeros_like(q), np.outer(force, [1.0, 0, 0, 0, 0])), 28)


PHASE = np.linspace(0.0, 20.5, 20 * 192 + 97)


def _touching(cycles: tuple[int, ...], by: float = 0.03) -> np.ndarray:
    """A force that all but vanishes once a mesh cycle, and vanishes for a moment in some of every five."""
    cycle, near = np.round(PHASE).astype(int) % 5, np.cos(2.0 * np.pi * PHASE) > 0.5
    moved = np.where(np.isin(cycle, cycles), -by, 0.005) * near
    return np.maximum(2.0 - 2.0 * np.cos(2.0 * np.pi * PHASE) + moved, 0.0)


@pytest.mark.parametrize(
    ("cycles", "label"),
    [((), "1-0-0"), ((1, 3), None), ((0, 1, 2, 3), None), ((2,), None), ((0, 1, 2, 3, 4), "1-1-0")],
)
def test_a_label_needs_as_many_impacts_in_every_period(cycles: tuple[int, ...], label: str | None):
    """The mean forces come back within 1 % in all of them; no share of cycles that part is rounded away."""
    reading = _read(_touching(cycles))
    assert (reading.period, reading.returns < 0.01) == (1, True)
    assert (None if reading.label is None else str(reading.label)) == label
    assert (reading.apart > 0.0) == bool(cycles)


def test_contact_that_is_lost_in_a_cycle_before_the_periods_compared_is_no_contact():
    """Of 20 cycles the first two lie before the six periods of three."""
    slow = 2.0 + np.cos(2.0 * np.pi * PHASE / 3.0) + 0.5 * np.cos(2.0 * np.pi * PHASE)
    lost = _read(np.where(np.abs(PHASE - 0.5) < 0.05, 0.0, slow))
    assert (lost.period, lost.label) == (3, None)
    assert str(_read(slow).label) == "3-0-0"


@pytest.mark.parametrize("begins", [0.0, -1.0 / 192.0, 0.3])
def test_an_impact_that_is_now_earlier_and_now_later_is_one_a_period_wherever_it_lies(begins: float):
    """At -1/192 the first state that carries is the last of a mesh cycle, or the first of the next."""
    apart = np.arccos(1.0 - 0.015) / (2.0 * np.pi)
    off = PHASE - begins + apart
    off = off + 5e-4 * np.sin(7.0 * np.round(off))
    reading = _read(np.maximum(2.0 - 2.0 * np.cos(2.0 * np.pi * off) - 0.03, 0.0))
    assert str(reading.label) == "1-1-0"


def test_teeth_that_never_touch_have_no_period():
    reading = _read(np.zeros(20 * 192 + 97))
    assert (reading.label, reading.period, reading.apart) == (None, None, 1.0)


def test_what_parts_and_comes_back_without_as_many_impacts_is_told_so(found: Verification):
    one = found.compared[2]
    point = replace(one.points[0], reading=_read(_touching((1, 3))))
    told = replace(found, compared=(replace(one, points=(point, *one.points[1:])),))
    answer = verify_answer(gl.load_case("article"), told)
    assert answer.configurations[0].points[0].label == "uneven"
    assert "with real teeth parts, impacts not repeating (absolute)" in answer.sentence
    assert not stays("uneven")
    kept = replace(point, reading=replace(point.reading, apart=0.0, drive_impacts=0))
    answer = verify_answer(gl.load_case("article"), replace(found, compared=(replace(one, points=(kept,)),)))
    assert answer.configurations[0].points[0].label == "kept"


@pytest.mark.parametrize("steps", [128, 192.7, 576.3])
def test_a_jump_between_two_states_does_not_hide_that_the_motion_comes_back(steps: float):
    """Damping makes the force jump where a slice begins to carry: states fall before it and behind it."""
    t = np.arange(0.0, 20.5, 1.0 / steps)
    q = np.zeros((len(t), 12))
    q[:, 5] = 2.0 * np.pi * t / 28
    force = 2.0 + np.cos(2.0 * np.pi * t) + 0.05 * ((t % 1.0) >= 0.371)
    reading = read_motion(Trajectory(t, q, np.zeros_like(q), np.outer(force, [1.0, 0, 0, 0, 0])), 28)
    assert str(reading.label) == "1-0-0"
    assert reading.returns < 0.005 + 1.0 / steps
    assert reading.mean == pytest.approx(2.0 + 0.05 * (1.0 - 0.371), rel=2e-4)


def test_a_motion_that_misses_itself_by_more_than_a_hundredth_has_no_label():
    t = np.linspace(0.0, 20.5, 20 * 192 + 97)
    q = np.zeros((len(t), 12))
    q[:, 5] = 2.0 * np.pi * t / 28
    force = 2.0 + (1.0 + 0.2 * np.sin(np.sqrt(5.0) * np.pi * t)) * np.cos(2.0 * np.pi * t)
    reading = read_motion(Trajectory(t, q, np.zeros_like(q), np.outer(force, [1.0, 0, 0, 0, 0])), 28)
    assert reading.label is None
    assert reading.returns > 0.01


def test_a_light_gear_in_stiff_bearings_is_integrated_with_steps_as_short_as_it_takes(found: Verification):
    """Tilting turns by 3 rad in 1/64 of this mesh cycle: Runge-Kutta of order 4 is stable up to 2.8."""
    mesh, inputs = found.meshes[0], found.inputs
    setting = replace(SHORT, flexible=False, settle=1, read=1)
    assert inputs.bearing_y is not None
    across = inputs.masses[0] * (3.0 * inputs.radii[0] ** 2 + inputs.body_widths[0] ** 2) / 12.0
    period = 2.0 * np.pi / (inputs.speeds[0] * inputs.natural_frequency(mesh.stiffness))
    span = 2.0 * 3.0 * 64.0 / period * np.sqrt(across / inputs.bearing_y[0])
    stiff = replace(setting, tilt=(span / inputs.bearing_spans[0]) ** 2)
    soft, hard = (
        run_point(
            inputs,
            ToothContact(mesh.contact(inputs).tables),
            each,
            omega=inputs.speeds[0],
            stiffness=mesh.stiffness,
            torque=inputs.torque,
        )
        for each in (setting, stiff)
    )
    assert (soft.settle_steps, soft.read_steps) == (64, 64)
    assert hard.settle_steps == hard.read_steps
    assert hard.read_steps in (128, 192)
    assert hard.energy_residual < 1e-2
    assert hard.reading.mean == pytest.approx(inputs.mean_force, rel=0.1)


def test_the_estimate_that_sets_the_steps_is_that_of_the_fastest_vibration(found: Verification):
    """Beside the frequencies of the matrices that Exudyn makes, with the contact made linear."""
    mesh, inputs = found.meshes[1], found.inputs
    machine = machine_of(inputs, SHORT, inputs.torque, 100.0, 1e-3, mesh.gear.modes)
    contact = ToothContact(mesh.contact(inputs, flexible=True).tables)
    pressed = np.zeros(machine.size)
    turn = inputs.mean_force / mesh.stiffness + 0.5 * inputs.backlash
    pressed[5] = turn / (inputs.torque / inputs.mean_force)
    squares = natural_frequencies(machine, contact, pressed)
    assert squares[-1] <= fastest(inputs, machine, mesh.stiffness) < 2.0 * squares[-1]


def test_motions_that_cannot_be_integrated_are_told_and_not_asked_for_again(found: Verification):
    lost = "absolute, as planned, 4000 rpm: the multibody model left all bounds at 1 s"
    answer = verify_answer(gl.load_case("article"), replace(found, failures=(lost,)))
    assert (answer.status, answer.message) == ("partly-failed", lost)
    assert "--speed" in answer.advice
    none = replace(found, failures=(lost,), compared=tuple(replace(one, points=()) for one in found.compared))
    assert verify_answer(gl.load_case("article"), none).status == "failed"


@pytest.mark.parametrize(
    ("ratio", "longest", "more"),
    [(0.005, 12, 175), (0.02, 12, 0), (0.0005, 12, 880), (0.0, 12, 880), (0.005, 1, 0)],
)
def test_a_body_that_rings_long_is_given_the_time_to_fade(ratio: float, longest: int, more: int):
    """A mode of 500 Hz fades by 2π ξ f T = 0.0157 nepers in a mesh cycle of 1 ms, at ξ = 0.005."""
    disc = RigidBody.solid_disc(6.0, 0.06, 0.07)
    bearings = Bearings.from_ratio((8e8, 8e8, 6.8e8, 1e6, 1e6), disc, 0.04)
    modes = Modes((2.0 * np.pi * 500.0,), ratio)
    machine = Machine((disc, disc), (bearings, bearings), (28, 28), 100.0, modes=modes)
    assert _to_fade(machine, Setting(settle=80, longest=longest), 1e-3) == pytest.approx(more, abs=1)
