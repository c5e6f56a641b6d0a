"""Motion of two gear bodies in bearings, integrated by Exudyn.

The contact is one force function over the coordinates of both bodies, evaluated by whoever models the teeth.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from gearlash.jobs import stopping

from .bodies import Machine
from .solvers import Integration, SimulationError, Solver

Array = NDArray[np.float64]
LOOKS_EVERY = 256
"""Steps between two looks at whether the work was asked to stop."""


class Contact(Protocol):
    """What the teeth do to both bodies."""

    def forces(self, t: float, q: Array, v: Array) -> Array:
        """Generalised forces on the bodies, shape of ``q``: what is added on the right of M q″ = …."""
        ...

    def record(self, t: float, q: Array, v: Array) -> Array:
        """What is kept of a state, shape (5,), in the order of `RECORDED`."""
        ...


RECORDED = ("drive_force", "back_force", "elastic_energy", "dissipated_power", "driven_power")
"""Of `Contact.record`: normal forces of both sides of the teeth in N, J, W, and the power in W that comes
from a stiffness or an error that follows the time, and no rotation."""


@dataclass(frozen=True)
class Trajectory:
    """A motion as it was integrated, at the beginning of every ``every``-th step and at the end.

    Attributes
    ----------
    t : ndarray, shape (n,)
        s.
    q, v : ndarray, shape (n, size)
        Coordinates of pinion, gear and modes, and their rates.
    recorded : ndarray, shape (n, 5)
        In the order of `RECORDED`.
    """

    t: Array
    q: Array
    v: Array
    recorded: Array

    @property
    def drive_force(self) -> Array:
        """Normal force of the driving sides of all teeth together, N."""
        return self.recorded[:, 0]

    @property
    def back_force(self) -> Array:
        """Normal force of their back sides, N."""
        return self.recorded[:, 1]


def simulate(
    machine: Machine,
    contact: Contact,
    q: Array,
    v: Array,
    *,
    step: float,
    steps: int,
    start: float = 0.0,
    every: int = 1,
    solver: Solver = Solver.RK44,
    tolerance: float = 1e-10,
) -> Trajectory:
    """Integrate from a state.

    Parameters
    ----------
    machine : Machine
    contact : Contact
    q, v : ndarray, shape (size,)
        Coordinates and rates at the time ``start``.
    step : float
        s; of `Solver.DOPRI5` the longest that it takes.
    steps : int
        How many.
    start : float
        s.
    every : int
        Steps from one state that is kept to the next; ``steps`` is a multiple of it.
    solver : Solver
    tolerance : float
        Of `Solver.DOPRI5` alone: how much a step may miss the state by, over the state; 1e-4 of that in m,
        rad, m/s and rad/s where the state is small.

    Returns
    -------
    Trajectory

    Raises
    ------
    SimulationError
        Where a step fails or a coordinate becomes no number.
    KeyboardInterrupt
        Where the work was asked to stop.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash.multibody import Bearings, LineContact, Machine, RigidBody, simulate
    >>> disc = RigidBody.solid_disc(6.0, 0.06, 0.07)
    >>> bearings = Bearings.from_ratio((8e8, 8e8, 6.8e8, 1e6, 1e6), disc, 0.04)
    >>> machine = Machine((disc, disc), (bearings, bearings), (28, 28), 0.0)
    >>> apart = LineContact(np.zeros(12), stiffness=(1e8,), error=(0.0,), gap=1.0, damping=0.0, rate=1.0)
    >>> rolling = np.zeros(12)
    >>> rolling[5] = 100.0
    >>> motion = simulate(machine, apart, np.zeros(12), rolling, step=1e-5, steps=10)
    >>> round(float(motion.q[-1, 5]), 12)
    0.01
    """
    kept = _Kept(machine, contact, start, step, every)
    with _quiet() as exu:
        container = exu.SystemContainer()
        mbs = container.AddSystem()
        try:
            _assemble(mbs, machine, kept)
            integration = Integration(exu, mbs, kept, solver, tolerance)
            integration.begin(np.array(q), np.array(v))
            integration.to(steps)
        finally:
            container.Reset()
    return kept.motion()


def natural_frequencies(machine: Machine, contact: Contact, q: Array, t: float = 0.0) -> Array:
    """Undamped natural frequencies about a place, of the matrices that Exudyn makes.

    Parameters
    ----------
    machine : Machine
    contact : Contact
    q : ndarray, shape (size,)
        Where the contact is made linear, by differences.
    t : float
        s.

    Returns
    -------
    ndarray, shape (size,)
        rad/s, ascending; the common rotation of the shafts has none, so the first is 0 within rounding.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash.multibody import Bearings, LineContact, Machine, RigidBody, natural_frequencies
    >>> body = RigidBody(4.0, 1.0, 1.0)
    >>> bearings = Bearings((16.0, 36.0, 64.0, 1.0, 1.0), (0.0,) * 5)
    >>> machine = Machine((body, body), (bearings, bearings), (28, 28), 0.0)
    >>> apart = LineContact(np.zeros(12), stiffness=(1e8,), error=(0.0,), gap=1.0, damping=0.0, rate=1.0)
    >>> natural_frequencies(machine, apart, np.zeros(12)).round(9)[-6:].tolist()
    [2.0, 2.0, 3.0, 3.0, 4.0, 4.0]
    """
    kept = _Kept(machine, contact, t, 1.0, 1)
    with _quiet() as exu:
        container = exu.SystemContainer()
        mbs = container.AddSystem()
        try:
            _assemble(mbs, machine, kept)
            mbs.systemData.SetODE2Coordinates(np.array(q), configuration=exu.ConfigurationType.Initial)
            squares, _ = mbs.ComputeODE2Eigenvalues()
        finally:
            container.Reset()
    return np.sqrt(np.sort(squares))


class _Kept:
    """What Exudyn calls: the contact's forces, and between two steps what keeps states and hears a stop."""

    def __init__(self, machine: Machine, contact: Contact, start: float, step: float, every: int):
        self.machine, self.contact = machine, contact
        self.start, self.step, self.every = start, step, every
        self.count, self.looks = 0, 0
        self.interrupted = False
        self.load = machine.constant_load()
        self.direction, self.aim = machine.governor()
        self.rows: list[tuple[float, Array, Array, Array]] = []

    def force(self, mbs: Any, t: float, itemNumber: int, q: Any, q_t: Any) -> Any:
        try:
            place, rate = np.array(q), np.array(q_t)
            held = self.direction * (self.aim - float(self.direction @ rate))
            return self.load + held + self.contact.forces(t, place, rate)
        except KeyboardInterrupt:  # an exception of Python would reach the caller as one of Exudyn's
            self.interrupted = True
            return np.zeros(len(q))

    def before_step(self, mbs: Any, t: float) -> bool:
        try:
            self.keep(self.count, mbs)
            self.count += 1
        except KeyboardInterrupt:
            self.interrupted = True
        return self.go_on(mbs, t)

    def go_on(self, mbs: Any, t: float) -> bool:
        """Before a step whose state is not kept."""
        if self.looks % LOOKS_EVERY == 0 and stopping():
            self.interrupted = True
        self.looks += 1
        return not self.interrupted

    def keep(self, count: int, mbs: Any) -> None:
        if self.interrupted:
            raise KeyboardInterrupt
        if count % self.every:
            return
        t = self.start + count * self.step
        q, v = mbs.systemData.GetODE2Coordinates(), mbs.systemData.GetODE2Coordinates_t()
        if not np.all(np.isfinite(v)):
            raise SimulationError(
                f"the multibody model left all bounds at {t:.6g} s with a step of {self.step:.3g} s"
            )
        self.rows.append((t, q, v, self.contact.record(t, q, v)))

    def motion(self) -> Trajectory:
        t, q, v, recorded = zip(*self.rows, strict=True)
        arrays = (np.array(t), np.array(q), np.array(v), np.array(recorded))
        for array in arrays:
            array.setflags(write=False)
        return Trajectory(*arrays)


@contextmanager
def _quiet() -> Iterator[Any]:
    """Exudyn without its words on the console, which it keeps on for all later callers otherwise."""
    import exudyn as exu

    before = exu.config.printToConsole
    exu.config.printToConsole = False
    try:
        yield exu
    finally:
        exu.config.printToConsole = before


def _assemble(mbs: Any, machine: Machine, kept: _Kept) -> None:
    from exudyn.itemInterface import (
        NodeGenericODE2,
        NodeRigidBodyRxyz,
        ObjectGenericODE2,
        ObjectRigidBody,
    )

    nodes = []
    for body in machine.bodies:
        node = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[0.0] * 6))
        across, along = body.transverse_inertia, body.axial_inertia
        inertia = [across, across, along, 0.0, 0.0, 0.0]
        mbs.AddObject(ObjectRigidBody(mass=body.mass, inertia=inertia, nodeNumber=node))
        nodes.append(node)
    modes = machine.size - 12
    mass = np.zeros((machine.size, machine.size))
    if modes:
        zeros = [0.0] * modes
        node = NodeGenericODE2(
            referenceCoordinates=zeros,
            initialCoordinates=zeros,
            initialCoordinates_t=zeros,
            numberOfODE2Coordinates=modes,
        )
        nodes.append(mbs.AddNode(node))
        mass[12:, 12:] = np.eye(modes)
    mbs.AddObject(
        ObjectGenericODE2(
            nodeNumbers=nodes,
            massMatrix=mass,
            stiffnessMatrix=machine.stiffness(),
            dampingMatrix=machine.damping(),
            forceUserFunction=kept.force,
        )
    )
    mbs.Assemble()
