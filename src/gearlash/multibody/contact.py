"""Contact of a pair of gears in space: all slices of all lines of contact, both sides of the teeth.

The places of contact follow the phase of the mesh, which is the pinion's turn; the gaps follow the whole
pose: centre distance, misalignment, axial shift, errors, modifications. What the centre distance does to the
places themselves (some micrometres on a flank of millimetres) is left out of the compliance, not of the gaps.
So is what a force on one side of a tooth does to its other side, and friction.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearlash.gears import CylindricalPair
from gearlash.gears.materials import Material, named
from gearlash.system import GearlashError

from . import _tables as places
from ._forces import NO_FORCES, NO_MESH, REPORT, TOO_DEEP, contact_kernel
from ._tables import ContactTables
from .contact_tables import Compliance, RimModes, contact_tables, relief_table, roll_lengths
from .flanks import Flanks
from .topography import Topography

Reals = NDArray[np.float64]

PHASES = 32
"""Of the compliance in one mesh cycle."""
WHY = {
    NO_MESH: "the axes are so near to each other, or so far turned, that the teeth have no line of action",
    TOO_DEEP: "the flanks are deeper in each other than tip corners are followed",
    NO_FORCES: "the forces between the teeth were not found",
}
"""Why `contact_forces` has no answer."""
_NOTHING = np.empty((0, 0))


@dataclass(frozen=True)
class Details:
    """What happens between the teeth at one pose.

    Parameters
    ----------
    forces : ndarray, shape (12 + modes,)
        Generalised forces on pinion, gear and modes.
    normal : (float, float)
        Force on each side, N: the sum of all normal forces.
    pushing : (int, int)
        How many slices push.
    energy : float
        Elastic, J.
    dissipation : float
        Power, W.
    nearest : (float, float)
        Least gap of each side before anything deforms, m; below 0 it is closed.
    loads : ndarray, shape (2, pairs, slices)
        Force on every place, N.
    """

    forces: Reals
    normal: tuple[float, float]
    pushing: tuple[int, int]
    energy: float
    dissipation: float
    nearest: tuple[float, float]
    loads: Reals


@dataclass(frozen=True)
class MeshContact:
    """Both sides of the teeth of a pair, with all that their forces depend on.

    Parameters
    ----------
    flanks : Flanks
    tables : ContactTables
        As arrays, for `contact_forces`.
    topography : Topography
    """

    flanks: Flanks
    tables: ContactTables
    topography: Topography

    @classmethod
    def of(
        cls,
        pair: CylindricalPair,
        compliance: tuple[Compliance, Compliance],
        materials: tuple[Material, Material] | None = None,
        slices: int = 21,
        damping_time: float = 0.0,
        topography: Topography | None = None,
        modes: RimModes | None = None,
        phases: int = PHASES,
        reach: float = places.CORNER_REACH,
    ) -> MeshContact:
        """The contact of a pair of gears.

        Parameters
        ----------
        pair : CylindricalPair
        compliance : (Compliance, Compliance)
            Of pinion and gear.
        materials : (Material, Material), optional
            For the flattening; steel where nothing is given.
        slices : int
            Of the face, from 1.
        damping_time : float
            τ, s: forces of damping are τ times the rate of the elastic ones; 2 ξ/ω of a mode; from 0.
        topography : Topography, optional
            Perfect flanks where nothing is given.
        modes : RimModes, optional
            Rigid bodies where nothing is given.
        phases : int
            At how many phases of the mesh cycle the compliance is made.
        reach : float
            Up to this normal approach, m, forces are found and tip corners followed.

        Returns
        -------
        MeshContact
        """
        flanks = Flanks(pair)
        shape = Topography() if topography is None else topography
        steel = named("steel")
        bodies = (steel, steel) if materials is None else materials
        tables = contact_tables(flanks, compliance, bodies, slices, damping_time, shape, modes, phases, reach)
        return cls(flanks, tables, shape)

    def with_(self, damping_time: float | None = None, topography: Topography | None = None) -> MeshContact:
        """The same gears with another damping or other errors and modifications.

        Parameters
        ----------
        damping_time : float, optional
            τ, s; as it is where nothing is given.
        topography : Topography, optional
            As it is where nothing is given.

        Returns
        -------
        MeshContact
            The compliance is not made anew.
        """
        shape = self.topography if topography is None else topography
        scalars = self.tables.scalars.copy()
        if damping_time is not None:
            scalars[places.DAMPING_TIME] = damping_time
        return replace(
            self,
            topography=shape,
            tables=self.tables._replace(
                scalars=scalars,
                error=np.array([shape.series(side) for side in range(2)]),
                relief=relief_table(self.flanks, shape, scalars, self.tables.slices),
            ),
        )

    def with_modes(self, modes: RimModes) -> MeshContact:
        """The same gears on bodies that bend.

        Parameters
        ----------
        modes : RimModes
            In place of those that there are.

        Returns
        -------
        MeshContact
        """
        counts = self.tables.counts.copy()
        counts[places.MODES] = len(modes.body)
        tables = self.tables._replace(
            counts=counts,
            mode_order=np.ascontiguousarray(modes.order, np.int64),
            mode_body=np.ascontiguousarray(modes.body, np.int64),
            mode_shape=np.ascontiguousarray(modes.shape, np.float64),
        )
        return replace(self, tables=tables)

    def rolls(self, phase: float) -> Reals:
        """Where on the pinion's flanks the places of contact are.

        Parameters
        ----------
        phase : float
            Of the mesh cycle, from 0 to 1.

        Returns
        -------
        ndarray, shape (pairs, slices)
            Roll lengths, m; also those beyond the ends of the flanks.
        """
        return roll_lengths(self.tables.scalars, self.tables.counts, self.tables.slices, phase)

    def forces(self, q: Reals, v: Reals) -> Reals:
        """Generalised forces on both bodies and the modes.

        Parameters
        ----------
        q : ndarray, shape (12 + modes,)
            Displacement from rest (m) and rotations x, y, z (rad) of the pinion, of the gear, then modes.
        v : ndarray, shape (12 + modes,)
            Its rate.

        Returns
        -------
        ndarray, shape (12 + modes,)
            N and N·m.

        Raises
        ------
        GearlashError
            Where the forces are not found.
        """
        return self.details(q, v).forces

    def details(self, q: Reals, v: Reals) -> Details:
        """All that is known of one pose; see `forces`."""
        n_slices = len(self.tables.slices)
        out, report = np.empty(len(q)), np.empty(REPORT)
        loads = np.zeros((2, int(self.tables.counts[places.PAIRS]) * n_slices))
        why = contact_kernel(self.tables, q, v, out, report, _NOTHING, loads)
        if why:
            raise GearlashError(WHY[why])
        return Details(
            out,
            (float(report[0]), float(report[1])),
            (int(report[2]), int(report[3])),
            float(report[4]),
            float(report[5]),
            (float(report[6]), float(report[7])),
            loads.reshape(2, -1, n_slices),
        )


def contact_forces(
    tables: ContactTables, q: Reals, v: Reals, out: Reals, report: Reals, memory: Reals = _NOTHING
) -> int:
    """The kernel itself, for a solver: ``out`` and ``report`` are written, nothing is made.

    Parameters
    ----------
    tables : ContactTables
    q, v : ndarray, shape (12 + modes,)
        As of `MeshContact.forces`.
    out : ndarray, shape (12 + modes,)
        Generalised forces.
    report : ndarray, shape (8,)
        Normal force of side 0 and 1, N; slices that push on each; elastic energy, J; dissipated power, W;
        least gap of each side before deformation, m.
    memory : ndarray, shape (2, P S), optional
        Of `new_memory`: the forces of the call before, to begin with at the next one, which is quicker where
        poses follow each other closely. What is found is the same to 1e-8.

    Returns
    -------
    int
        0; otherwise a key of `WHY`, and both arrays are NaN.
    """
    return contact_kernel(tables, q, v, out, report, memory, _NOTHING)


def new_memory(tables: ContactTables) -> Reals:
    """Room for what `contact_forces` remembers from call to call.

    Parameters
    ----------
    tables : ContactTables

    Returns
    -------
    ndarray, shape (2, P S)
        Zero: nothing yet.
    """
    return np.zeros((2, int(tables.counts[places.PAIRS]) * len(tables.slices)))
