"""A mesh of modified flanks under load: which contact lines bear, how stiff they are, and the loaded error.

The contact lines are cut into pieces, each a spring of the stiffness k_j of its pair of teeth behind a gap
g_j that relief and crowning leave (`flank_modification`). All of them are deflected alike, and those that
bear carry the load,

    F = Σ_j k_j (u − g_j)₊,   δ = u + c F.

Teeth that bend touch before and behind the path of contact, with the corner of a tip (`tip_corner`): there
k_j is that of the end of the path. Where one tooth is loaded its neighbours move too: c is the part of the
give of both bodies that all pairs in contact share, and which the k_j, each found for a pair alone, are
without. δ over the mesh cycle is the static transmission error under load. The model has two excitations in
its place,

    1/K = c + 1/Σ k_j w_j,   e = δ − F/K,

so that F/K + e is the loaded error at this load, and K how the force grows about it. For other loads other
pieces bear, so both are made again for each. A piece stands for a part of the width and a step of phase, over
which its gap goes from a least one through g_j, in the middle, to a largest one: w_j is how much of it is
below u, from 0 to 1. So K is continuous in the load, as that of flanks is.

Left out: that neighbouring slices of a tooth help each other; what changes of the pieces that bear while the
force swings about the load; pitch and form deviations, which are an error of their own; and that flanks which
separate meet again at the smallest gap and not at e.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import ceil, cos, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearlash.system import Fourier, GearlashError, evaluate

from .cylindrical_pair import CylindricalPair
from .flank_modification import PairModification
from .materials import Material
from .pair_shape import PairShape
from .tip_corner import tip_corner_gap
from .tooth_pair import pair_stiffness

Reals = NDArray[np.float64]
PLACES = 97
"""Along the path of contact, where the stiffness of a pair of teeth is computed."""
SPUR_POINTS, POINTS = 1024, 512
"""Phases of a mesh cycle: of straight teeth, whose steps are sharp, and of helical ones."""
SLICES = 64
BEYOND = 0.35
"""Of p_bt: how far contact beyond either end of the path is followed."""
NO_CHANGE = 1e-15
"""m: over what has less the gap does not change."""
SAME_MEAN = 1e-9
"""Relative: means that lie nearer are one."""
SHARED_GIVE = 0.5
"""c b E/(1 − ν²) of one body under a load all along its face: how far a tooth moves where the next one is
loaded. Finite elements of solid gears, held 4 m_n below the root, have 0.4 to 0.6."""


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


class _ByGap(NamedTuple):
    """The pieces of each phase in the order in which they begin to bear, shape (n, pieces); those beyond the
    path of contact come last, and never do."""

    stiffness: Reals
    gaps: Reals  # in the middle
    sums: Reals  # of the stiffness of a piece and all before it
    weighted: Reals  # the same of stiffness times gap
    begins: Reals  # the force at which the middle of a piece begins to bear
    slope_below: Reals  # how much more of a piece bears per deflection, up to its middle
    slope_above: Reals  # and behind that


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
    below, above : ndarray, shape (n, pieces)
        How much the gap of a piece is less, and more, than g_j somewhere on it, m.
    share : float
        Part of the face width that a piece has.
    mean : float
        Mean stiffness of unmodified flanks that touch on all of the path of contact and nowhere else, N/m.
    shared : float
        c, m/N.
    """

    phases: Reals
    total_contact_ratio: float
    stiffness: Reals
    gaps: Reals
    below: Reals
    above: Reals
    share: float
    mean: float
    shared: float = 0.0

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
        pieces = self._by_gap
        if not (pieces.sums[:, -1] > 0.0).all():
            raise GearlashError("teeth that mesh all round the cycle: at some of it no pair touches")
        relative = force / factor  # on springs as they are
        last = np.count_nonzero(pieces.begins < relative, axis=1) - 1
        rows = np.arange(len(last))
        u = (relative + pieces.weighted[rows, last]) / pieces.sums[rows, last]
        over = u[:, None] - pieces.gaps
        bears = np.clip(0.5 + over * pieces.slope_below, 0.0, 0.5)
        bears += np.clip(over * pieces.slope_above, 0.0, 0.5)
        bearing = factor * np.einsum("ij,ij->i", pieces.stiffness, bears)
        shared = self.shared / factor
        ratio = float(bears[pieces.stiffness > 0.0].sum()) / len(rows) * self.share
        stiffness = bearing / (1.0 + shared * bearing)
        return LoadedMesh(force, self.phases, self.total_contact_ratio, stiffness, u + shared * force, ratio)

    @cached_property
    def _by_gap(self) -> _ByGap:
        places = np.argsort(np.where(self.stiffness > 0.0, self.gaps, np.inf), axis=1, kind="stable")
        arrays = self.stiffness, self.gaps, self.below, self.above
        k, gaps, below, above = (np.take_along_axis(each, places, axis=1) for each in arrays)
        g = np.where(k > 0.0, gaps, 0.0)
        sums, weighted = np.cumsum(k, axis=1), np.cumsum(k * g, axis=1)
        begins = np.where(k > 0.0, sums * g - weighted, np.inf)
        slopes = (0.5 / np.maximum(each, NO_CHANGE) for each in (below, above))
        return _ByGap(k, g, sums, weighted, begins, *slopes)

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
        return self.under(force, self.factor_of_mean(force, mean))

    def factor_of_mean(self, force: float, mean: float) -> float:
        """What every stiffness is multiplied by, so that the mesh has this mean stiffness under a load.

        Parameters
        ----------
        force : float
            N.
        mean : float
            Of K over the cycle, N/m.

        Returns
        -------
        float
        """
        factor = mean / self.mean
        for _ in range(30):
            off = mean / self.under(force, factor).mean_stiffness
            factor *= off
            if abs(off - 1.0) < SAME_MEAN:
                break
        return factor


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
        A published shape of a pair's stiffness in place of the calculated one: pairs touch on the path of
        contact only, and share nothing.

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
    phases, u, (gaps, below, above), share = _pieces(
        pair, modification, BEYOND / ratio if shape is None else 0.0
    )
    nodes, shared = np.linspace(0.0, 1.0, PLACES), 0.0
    if shape is None:
        curve = np.array(
            [pair_stiffness(pair, start + (end - start) * v, line_load, materials) for v in nodes]
        )
        soft = sum((1.0 - one.poisson_ratio**2) / one.youngs_modulus for one in materials)
        shared = SHARED_GIVE * soft
    else:
        curve = shape.at(nodes - 0.5, ratio)
    width = pair.face_width / cos(pair.pinion.base_helix_angle)
    mean = float(np.trapezoid(curve, nodes)) * ratio * width
    alone = curve / (1.0 - shared * curve)
    near = (u >= 0.0) & (u <= 1.0) if shape is not None else np.isfinite(gaps)
    stiffness = np.where(near, np.interp(u, nodes, alone), 0.0) * (share * width)
    return ContactLines(
        phases, pair.total_contact_ratio, stiffness, gaps, below, above, share, mean, shared / width
    )


@lru_cache(maxsize=4)  # the same at every load
def _pieces(
    pair: CylindricalPair, modification: PairModification, beyond: float
) -> tuple[Reals, Reals, tuple[Reals, Reals, Reals], float]:
    """Phases; where each piece lies, 0 to 1 on the path of contact and beyond it; its gap in the middle,
    infinite where it is not followed, and how much that is less and more elsewhere on it, all of shape (n,
    pieces); the part of the width that a piece has."""
    straight = pair.overlap_ratio < 1e-9
    one_slice = straight and modification.crowning == 0.0
    points, slices = SPUR_POINTS if straight else POINTS, 1 if one_slice else SLICES
    phases = (np.arange(points) + 0.5) / points
    across = (np.arange(slices) + 0.5) / slices - 0.5
    u, middle = _gaps(pair, modification, beyond, phases, across)
    edges = [_gaps(pair, modification, beyond, np.arange(points + 1) / points, across)[1]]
    sides = [(edges[0][:-1], edges[0][1:])]
    if not one_slice:
        edges.append(_gaps(pair, modification, beyond, phases, np.arange(slices + 1) / slices - 0.5)[1])
        sides.append((edges[1][..., :-1], edges[1][..., 1:]))
    below, above = np.zeros_like(middle), np.zeros_like(middle)
    known = np.isfinite(middle)
    for pair_of_edges in sides:  # what it changes along the phase and across the width adds up
        for edge in (np.minimum(*pair_of_edges), np.maximum(*pair_of_edges)):
            change = np.subtract(edge, middle, where=known & np.isfinite(edge), out=np.zeros_like(middle))
            below += np.maximum(-change, 0.0)
            above += np.maximum(change, 0.0)
    u, middle, below, above = (each.reshape(points, -1) for each in (u, middle, below, above))
    for each in (phases, u, middle, below, above):
        each.setflags(write=False)
    return phases, u, (middle, below, above), 1.0 / slices


def _gaps(
    pair: CylindricalPair, modification: PairModification, beyond: float, phases: Reals, across: Reals
) -> tuple[Reals, Reals]:
    """Places on the path of contact, 0 to 1, and gaps there, shape (phases, pairs, across)."""
    start, end = pair.path_of_contact
    more = ceil(beyond * pair.transverse_contact_ratio)
    turns = np.arange(-more, ceil(pair.total_contact_ratio) + 1 + more)
    u = phases[:, None, None] + turns[:, None] - (across + 0.5) * pair.overlap_ratio
    u = u / pair.transverse_contact_ratio
    places = start + (end - start) * np.clip(u, 0.0, 1.0)
    return u, modification.gap(pair, places, np.broadcast_to(across, u.shape)) + _corners(pair, u, beyond)


def _corners(pair: CylindricalPair, u: Reals, beyond: float) -> Reals:
    """Gap that tip corners leave beyond the path of contact; infinite farther off than ``beyond``."""
    start, end = pair.path_of_contact
    far = np.maximum(-u, u - 1.0)
    found = np.where(far > beyond, np.inf, 0.0)
    along = cos(pair.pinion.base_helix_angle)
    for which, after in ((0, u - 1.0), (1, -u)):
        here = (after > 0.0) & (after <= beyond)
        found[here] = along * tip_corner_gap(pair, which, (end - start) * after[here])
    return found
