"""The whole verification: meshes, points, window, settings beside, and the lumped model beside it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest
from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.jobs import INTERRUPTED, Chain, Execution, Part, run
from gearlash.jobs.stop import interruptible
from gearlash.multibody import Modes, require_extra
from gearlash.multibody.solvers import SimulationError
from gearlash.multibody.tooth_contact import ToothContact

from .inputs import Inputs, inputs_of
from .lumped import LumpedInputs, LumpedPoint, lumped_points, lumped_window, stated_points
from .mesh import Mesh, is_close, matched_mesh, mesh_of, modified, scaled_mesh, unmodified
from .plan import Configuration, Plan, configurations, reshaped
from .point import PointFound, run_point
from .settings import Setting

Array = NDArray[np.float64]
Tell = Callable[[str, Any], object]
MOTIONS = "bodies in space"
"""The stage from which on there are results."""
SLOWER = 0.9
"""The second speed over that of the case, where none is named: 3600 rpm beside 4000 rpm."""


@dataclass(frozen=True)
class Compared:
    """One configuration with all that was found in it.

    Attributes
    ----------
    configuration : Configuration
    given : LumpedInputs
        What the lumped model got.
    errors : tuple of (float, float)
        What is on the flanks of real teeth: amplitude, m, and phase, rad, of the mesh orders 1, 2, …
    points : tuple of PointFound
        At the speeds asked for.
    beside : tuple of PointFound
        With other settings, at the same speeds.
    window_omegas : ndarray
    up, down : tuple of PointFound
        Over the window, each in the order in which they were computed.
    lumped : tuple of LumpedPoint
        At the speeds asked for, under every rule; empty where the work was stopped before.
    lumped_window : dict
        Labels over the window, going up and down, by rule.
    """

    configuration: Configuration
    given: LumpedInputs
    errors: tuple[tuple[float, float], ...]
    points: tuple[PointFound, ...]
    beside: tuple[PointFound, ...]
    window_omegas: Array
    up: tuple[PointFound, ...]
    down: tuple[PointFound, ...]
    lumped: tuple[LumpedPoint, ...]
    lumped_window: dict[Any, tuple[tuple[str, ...], tuple[str, ...]]]


@dataclass(frozen=True)
class Verification:
    """What was compared, with every input and setting.

    Attributes
    ----------
    inputs : Inputs
    plan : Plan
    meshes : tuple of Mesh
        Of the matched width; of the width of the case, under its torque and under one that grows with the
        stiffness; of other flanks.
    stated : tuple of LumpedPoint
        The case as it is, at its own ω.
    compared : tuple of Compared
    failures : tuple of str
        Points that could not be integrated, and why.
    reason : str
        Empty where nothing stopped it.
    """

    inputs: Inputs
    plan: Plan
    meshes: tuple[Mesh, ...]
    stated: tuple[LumpedPoint, ...]
    compared: tuple[Compared, ...]
    failures: tuple[str, ...]
    reason: str


@dataclass(frozen=True)
class _Task:
    """One point for a worker; the way in which its inputs are held."""

    way: str
    inputs: Inputs
    contact: ToothContact
    setting: Setting
    omega: float
    stiffness: float
    torque: float
    modes: Modes | None
    stiffer: float


def verification(
    case: Case,
    *,
    speeds: Sequence[float] = (),
    plan: Plan | None = None,
    execution: Execution | None = None,
    tell: Tell = lambda stage, progress: None,
) -> Verification:
    """Compare a case with a model of bodies in space with real teeth.

    Parameters
    ----------
    case : Case
        Of a helical or spur pair with teeth, masses and backlash.
    speeds : sequence of float
        ω of the case; its own and nine tenths of it where none is named.
    plan : Plan, optional
        What is computed; fixed before anything is.
    execution : Execution, optional
        Who does the work.
    tell : callable
        Hears the stage and how far it is.

    Returns
    -------
    Verification

    Raises
    ------
    MissingExtraError
        Without Exudyn and scikit-fem.
    NotVerifiableError
        For a case that says too little, or has what real teeth cannot have.
    """
    require_extra()
    own = case.family()[0].complete()["omega"]
    inputs = inputs_of(case, tuple(speeds) or (SLOWER * own, own))
    chosen = Plan() if plan is None else plan
    if inputs.bearing_y is None:  # nothing moves but rotations: what would be held is held
        chosen = replace(chosen, everywhere=tuple(s for s in chosen.everywhere if not s.held))
    work = Execution() if execution is None else execution
    tell("compliance of the teeth (finite elements)", None)
    full = mesh_of(inputs, inputs.pair.face_width, inputs.torque)
    meshes: tuple[Mesh, ...] = (matched_mesh(inputs, full), full, scaled_mesh(inputs, full))
    matched, wide, scaled = ((mesh.width, mesh.stiffness) for mesh in meshes)
    held = configurations(inputs, matched, wide, scaled, is_close(inputs, meshes[0]))
    others = {
        "modified": None if chosen.relief is None else modified(full, chosen.relief),
        "unmodified": unmodified(full) if chosen.unmodified and inputs.modification.modified else None,
    }
    for name, mesh in others.items():
        if mesh is not None:
            meshes = (*meshes, mesh)
            held = (*held, reshaped(name, inputs, full.width, mesh.stiffness))
    chains = _chains(inputs, chosen, held, meshes)
    tell(MOTIONS, None)
    progress = replace(work, progress=lambda each: tell(MOTIONS, each))
    outcome = run(_work, chains, progress)
    compared = tuple(_compared(inputs, chosen, one, _mesh(meshes, one), outcome.results) for one in held)
    stated, reason = (), outcome.reason
    if not reason:
        tell("lumped model", None)
        stated, compared, reason = _beside(case, inputs, compared)
    failures = tuple(each for found in outcome.results.values() for each in found if isinstance(each, str))
    return Verification(inputs, chosen, meshes, stated, compared, failures, reason)


def _beside(
    case: Case, inputs: Inputs, compared: tuple[Compared, ...]
) -> tuple[tuple[LumpedPoint, ...], tuple[Compared, ...], str]:
    """The case as it is, and the lumped model at the inputs of each configuration. Where Ctrl-C ends that,
    what was found of real teeth stays."""
    stated: tuple[LumpedPoint, ...] = ()
    found = list(compared)
    try:
        with interruptible():
            stated = stated_points(case, inputs.speeds)
            for i, one in enumerate(compared):
                omegas = one.window_omegas
                found[i] = replace(
                    one,
                    lumped=lumped_points(case, one.given, one.configuration.omegas),
                    lumped_window=lumped_window(case, one.given, omegas) if len(omegas) else {},
                )
    except KeyboardInterrupt:
        return stated, tuple(found), INTERRUPTED
    return stated, tuple(found), ""


def _mesh(meshes: tuple[Mesh, ...], one: Configuration) -> Mesh:
    return next(mesh for mesh in meshes if (mesh.width, mesh.stiffness) == (one.width, one.stiffness))


def _chains(
    inputs: Inputs, plan: Plan, held: tuple[Configuration, ...], meshes: tuple[Mesh, ...]
) -> list[Chain]:
    """The window first: its chains are the longest."""
    chains = []
    for one in held:
        mesh = _mesh(meshes, one)
        tasks = [
            _task(inputs, one, mesh, replace(plan.window, name="window"), omega)
            for omega in plan.window_omegas(one)
        ]
        if tasks:
            sizes = (1,) * len(tasks)
            chains.append(Chain((one.name, "up"), tuple(tasks), sizes))
            chains.append(Chain((one.name, "down"), tuple(reversed(tasks)), sizes))
    for one in held:
        for setting in plan.settings_of(one):
            for omega in one.omegas:
                task = _task(inputs, one, _mesh(meshes, one), setting, omega)
                chains.append(Chain((one.name, setting.name, omega), (task,), (1,)))
    return chains


def _task(inputs: Inputs, one: Configuration, mesh: Mesh, setting: Setting, omega: float) -> _Task:
    contact = mesh.contact(
        inputs,
        errors=tuple((setting.error * a, phase) for a, phase in errors_of(inputs, mesh, setting.error_turn)),
        damping=setting.contact_damping,
        flexible=setting.flexible,
        flexible_pinion=setting.flexible_pinion,
    )
    modes = mesh.modes(setting.flexible, setting.flexible_pinion)
    teeth = ToothContact(contact.tables)
    torque = one.torque * setting.torque
    return _Task(one.name, inputs, teeth, setting, omega, one.stiffness, torque, modes, one.bearings)


def errors_of(inputs: Inputs, mesh: Mesh, turn: float = 0.0) -> tuple[tuple[float, float], ...]:
    """The error on the flanks, as far from the mesh's stiffness as in the case.

    Parameters
    ----------
    inputs : Inputs
    mesh : Mesh
    turn : float
        Of the mesh cycle, by which it is moved further, rad.

    Returns
    -------
    tuple of (float, float)
        Of the mesh orders 1, 2, …: amplitude, m, and phase, rad; moved with the mesh order of the stiffness
        that is the largest in the case.
    """
    order = inputs.ripple_order
    moved = (mesh.ripple_phases[order - 1] - inputs.ripple_phase) / order + turn
    return tuple(
        (amplitude, (phase + n * moved) % (2.0 * pi))
        for n, (amplitude, phase) in enumerate(inputs.errors, start=1)
    )


def all_errors(inputs: Inputs, mesh: Mesh) -> tuple[complex, ...]:
    """What stands for both excitations of real teeth by an error: that on the flanks, and what these make
    under the torque at which their stiffness was found.

    Parameters
    ----------
    inputs : Inputs
    mesh : Mesh

    Returns
    -------
    tuple of complex
        Of the mesh orders 1, 2, …, m.
    """
    stated = [amplitude * np.exp(1j * phase) for amplitude, phase in errors_of(inputs, mesh)]
    made = zip_longest(stated, mesh.static_errors, fillvalue=0j)
    return tuple(complex(one + other) for one, other in made)


def _work(task: _Task, carry: tuple[Array, Array] | None) -> Part:
    """One point; the next of its chain begins from its motion. One that cannot be integrated is left out."""
    try:
        found = run_point(
            task.inputs,
            task.contact,
            task.setting,
            omega=task.omega,
            stiffness=task.stiffness,
            torque=task.torque,
            start=carry,
            modes=task.modes,
            stiffer=task.stiffer,
        )
    except SimulationError as error:
        speed = task.inputs.rpm(task.omega, task.stiffness)
        return Part((f"{task.way}, {task.setting.name}, {speed:.4g} rpm: {error}",), None)
    return Part((found,), (found.q, found.v))


def _compared(
    inputs: Inputs,
    plan: Plan,
    one: Configuration,
    mesh: Mesh,
    results: dict[Any, tuple[Any, ...]],
) -> Compared:
    """Without the lumped model."""
    given = LumpedInputs(
        one.stiffness, mesh.ripples, mesh.ripple_phases, one.torque, all_errors(inputs, mesh), one.bearings
    )
    omegas = plan.window_omegas(one)
    alone = [found for key, found in results.items() if key[0] == one.name and len(key) == 3]
    points = [each for found in alone for each in found if isinstance(each, PointFound)]
    return Compared(
        configuration=one,
        given=given,
        errors=errors_of(inputs, mesh),
        points=tuple(p for p in points if p.setting == plan.planned.name),
        beside=tuple(p for p in points if p.setting != plan.planned.name),
        window_omegas=omegas,
        up=_points(results.get((one.name, "up"), ())),
        down=_points(results.get((one.name, "down"), ())),
        lumped=(),
        lumped_window={},
    )


def _points(found: tuple[Any, ...]) -> tuple[PointFound, ...]:
    return tuple(each for each in found if isinstance(each, PointFound))
