"""A mesh of modified flanks under load: which contact lines bear, how stiff they are, and the loaded error.

The contact lines are cut into pieces, each a spring of the stiffness k_j of its pair of teeth behind a gap
g_j that relief and crowning leave (`flank_modification`). All of them are deflected alike, and those that
bear carry the load,

    F = Σ_j k_j (δ − g_j)₊.

δ over the mesh cycle is the static transmission error under load. The model has two excitations in its place,

    K = Σ k_j of the pieces that bear,   e = δ − F/K,

so that F/K + e is the loaded error at this load, and K how the force grows about it. For other loads other
pieces bear, so both are made again for each.

Left out: contact before and behind the path of contact, where teeth that bend touch early; what changes of
the pieces that bear while the force swings about the load; pitch and form deviations, which are an error of
their own; and that flanks which separate meet again at the smallest gap and not at e.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import ceil, cos, pi

import numpy as np
from numpy.typing import NDArray

from gearlash.system import Fourier, GearlashError, evaluate

from .cylindrical_pair import CylindricalPair
from .flank_modification import PairModification
from .materials import Material
from .pair_shape import PairShape
from .tooth_pair import pair_stiffness

Reals = NDArray[np.float64]
PLACES = 97
"""Along the path of contact, where the stiffness of a pair of teeth is computed."""
SPUR_POINTS, POINTS = 1024, 512
"""Phases of a mesh cycle: of one slice, whose steps are sharp, and of many."""
SLICES = 64


@dataclass(frozen=True)
class LoadedMesh:
    """A mesh cycle under one load. Phases are counted from the middle of a pair's path, as of `mesh_cycle`.

    Parameters
    ----------
    force : float
        Normal force, N.
    phases : ndarray, shape (n,)
        Cycles, from the first contact of a pair.
    total_contact_ratio : float
        ε_γ of the unmodified flanks.
    stiffness : ndarray, shape (n,)
        K, N/m.
    deflection : ndarray, shape (n,)
        δ, the loaded static error along the normal, m.
    contact_ratio : float
        ε_α under this load: mean number of pairs that bear, over the whole width.
    """

    force: float
    phases: Reals
    total_contact_ratio: float
    stiffness: Reals
    deflection: Reals
    contact_ratio: float

    @property
    def mean_stiffness(self) -> float:
        """Of K over the cycle, N/m."""
        return float(np.mean(self.stiffness))

    @property
    def unloaded_error(self) -> Reals:
        """e = δ − F/K, shape (n,), m: the mean gap of what bears, weighted by stiffness."""
        return self.deflection - self.force / self.stiffness

    def stiffness_harmonics(self, count: int) -> NDArray[np.complex128]:
        """c_1 … of K over its mean: 1 + Re Σ c_n exp(2πi n (ψ − ε_γ/2)), shape (count,)."""
        return self._harmonics(self.stiffness, count) / self.mean_stiffness

    def error_series(self, count: int) -> Fourier:
        """The error beside so many harmonics of the stiffness, so that both make the loaded error.

        Parameters
        ----------
        count : int
            Harmonics of both, from 1.

        Returns
        -------
        ndarray, shape (2·count + 1,)
            ``[0, c1, s1, …]`` of θ = 2π(ψ − ε_γ/2), m: the first harmonics of δ − F/K_n, K_n those of K. So
            F/K_n + e has the same ones as δ. The mean, which moves the gear and excites nothing, is left out.
        """
        angle = 2.0 * pi * (self.phases - 0.5 * self.total_contact_ratio)
        stiffness = _as_series(self.stiffness_harmonics(count))
        stiffness[0] = 1.0
        kept = self.mean_stiffness * evaluate(stiffness, angle)
        return _as_series(self._harmonics(self.deflection - self.force / kept, count))

    def _harmonics(self, values: Reals, count: int) -> NDArray[np.complex128]:
        orders = np.arange(1, count + 1)
        turns = np.exp(-2j * pi * orders * (self.phases[0] - 0.5 * self.total_contact_ratio))
        return np.asarray(np.fft.rfft(values)[1 : count + 1] * turns * (2.0 / len(values)))


def _as_series(harmonics: NDArray[np.complex128]) -> Fourier:
    """[0, c1, s1, …] of Re Σ c_n exp(inθ)."""
    found = np.zeros(2 * len(harmonics) + 1)
    found[1::2], found[2::2] = harmonics.real, -harmonics.imag
    return found


@dataclass(frozen=True)
class ContactLines:
    """The contact lines of a pair over a mesh cycle, cut into pieces.

    Parameters
    ----------
    phases : ndarray, shape (n,)
    total_contact_ratio : float
    stiffness : ndarray, shape (n, pieces)
        k_j, N/m; 0 where a piece lies beyond the path of contact.
    gaps : ndarray, shape (n, pieces)
        g_j, m.
    share : float
        Part of the face width that a piece has.
    """

    phases: Reals
    total_contact_ratio: float
    stiffness: Reals
    gaps: Reals
    share: float

    @property
    def mean(self) -> float:
        """Mean stiffness where all pieces bear, N/m."""
        return float(self.stiffness.sum(axis=1).mean())

    def under(self, force: float, factor: float = 1.0) -> LoadedMesh:
        """The mesh under a load.

        Parameters
        ----------
        force : float
            Normal force, N; above 0.
        factor : float
            What every stiffness is multiplied by.

        Returns
        -------
        LoadedMesh

        Raises
        ------
        GearlashError
            Where at some phase no piece touches.
        """
        order = np.argsort(np.where(self.stiffness > 0.0, self.gaps, np.inf), axis=1, kind="stable")
        k = factor * np.take_along_axis(self.stiffness, order, axis=1)
        g = np.where(k > 0.0, np.take_along_axis(self.gaps, order, axis=1), 0.0)
        stiff, weighted = np.cumsum(k, axis=1), np.cumsum(k * g, axis=1)
        if not (stiff[:, -1] > 0.0).all():
            raise GearlashError("teeth that mesh all round the cycle: at some of it no pair touches")
        # the force when the next piece begins to bear; pieces beyond the path come last and never do
        bears = (k > 0.0) & (stiff * g - weighted < force)
        last = np.count_nonzero(bears, axis=1) - 1
        rows = np.arange(len(k))
        stiffness = stiff[rows, last]
        deflection = (force + weighted[rows, last]) / stiffness
        ratio = float(np.mean(last + 1)) * self.share
        return LoadedMesh(force, self.phases, self.total_contact_ratio, stiffness, deflection, ratio)

    def under_with_mean(self, force: float, mean: float) -> LoadedMesh:
        """The mesh under a load whose mean stiffness, as far as it bears, is known.

        Parameters
        ----------
        force : float
            N.
        mean : float
            Of the result, N/m.

        Returns
        -------
        LoadedMesh
        """
        factor = mean / self.mean
        found = self.under(force, factor)
        for _ in range(30):
            factor *= mean / found.mean_stiffness
            found = self.under(force, factor)
            if abs(found.mean_stiffness / mean - 1.0) < 1e-6:
                break
        return found


def contact_lines(
    pair: CylindricalPair,
    modification: PairModification,
    line_load: float,
    materials: tuple[Material, Material],
    shape: PairShape | None = None,
) -> ContactLines:
    """The contact lines of modified flanks.

    Parameters
    ----------
    pair : CylindricalPair
        With its face width.
    modification : PairModification
    line_load : float
        F/b, N/m; above 0: how much the contact is flattened, in the mean.
    materials : (Material, Material)
        Of pinion and gear.
    shape : PairShape, optional
        A published shape of a pair's stiffness in place of the calculated one.

    Returns
    -------
    ContactLines

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.gears.flank_modification import FlankModification, PairModification, Relief
    >>> from gearlash.gears.loaded_mesh import contact_lines
    >>> from gearlash.gears.materials import named
    >>> pair = CylindricalPair(CylindricalGear(30, 4e-3), CylindricalGear(60, 4e-3), face_width=0.04)
    >>> tips = FlankModification(tip=Relief(20e-6, 4e-3))
    >>> lines = contact_lines(pair, PairModification(tips, tips), 300e3, (named("steel"), named("steel")))
    >>> [round(lines.under(force).contact_ratio, 2) for force in (1e3, 12e3, 50e3)]
    [1.09, 1.61, 1.72]
    """
    start, end = pair.path_of_contact
    ratio = pair.transverse_contact_ratio
    phases, u, gaps, share = _pieces(pair, modification)
    nodes = np.linspace(0.0, 1.0, PLACES)
    if shape is None:
        curve = np.array(
            [pair_stiffness(pair, start + (end - start) * v, line_load, materials) for v in nodes]
        )
    else:
        curve = shape.at(nodes - 0.5, ratio)
    length = share * pair.face_width / cos(pair.pinion.base_helix_angle)
    stiffness = np.interp(u, nodes, curve * length, left=0.0, right=0.0)
    return ContactLines(phases, pair.total_contact_ratio, stiffness, gaps, share)


@lru_cache(maxsize=4)  # the same at every load
def _pieces(pair: CylindricalPair, modification: PairModification) -> tuple[Reals, Reals, Reals, float]:
    """Phases; where on the path of contact each piece lies, from 0 to 1, and its gap, shape (n, pieces); the
    part of the width that a piece has."""
    start, end = pair.path_of_contact
    overlap = pair.overlap_ratio
    one_slice = overlap < 1e-9 and modification.crowning == 0.0
    points, slices = (SPUR_POINTS, 1) if one_slice else (POINTS, SLICES)
    phases = (np.arange(points) + 0.5) / points
    across = (np.arange(slices) + 0.5) / slices - 0.5
    turns = np.arange(ceil(pair.total_contact_ratio) + 1)
    u = phases[:, None, None] + turns[:, None] - (across + 0.5) * overlap
    u = u / pair.transverse_contact_ratio
    gaps = modification.gap(pair, start + (end - start) * u, np.broadcast_to(across, u.shape))
    found = phases, u.reshape(points, -1), gaps.reshape(points, -1)
    for each in found:
        each.setflags(write=False)
    return *found, 1.0 / slices
