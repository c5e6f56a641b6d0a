"""The mesh of the multibody model at one face width: compliance, contact, and what follows of both."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from gearlash.case import Problem
from gearlash.gears import CylindricalPair
from gearlash.gears.flank_modification import PairModification
from gearlash.multibody import Modes
from gearlash.multibody._tables import CORNER_REACH
from gearlash.multibody.contact import MeshContact
from gearlash.multibody.quasi_static import QuasiStatic, quasi_static
from gearlash.multibody.topography import Relief, Topography
from gearlash.system import GearlashError

from .bending import Bending, bending_gear, bending_pinion
from .inputs import ORDERS, Inputs
from .refused import NotVerifiableError

if TYPE_CHECKING:  # scikit-fem is an extra
    from gearlash.multibody.compliance import FlankCompliance, SectorSettings

SLICES = 21
PHASES = 32
"""Of a mesh cycle, at which the stiffness is computed."""
CLOSE = 5e-3
"""Of a stiffness to the one wanted, relative."""
MOST_WIDTHS = 10
WIDEST = 16.0
"""Of a width that is tried, over that of the case."""
CLOSE_TORQUE = 1e-3
"""Of a torque to the one wanted, relative."""
MOST_TORQUES = 30
DEFLECTIONS = 6.0
"""Of the mesh under its mean force: how deep flanks may be in each other, if that is more than is usual."""
FARTHEST = 4.0
"""From one width that is tried to the next: this factor at most."""
RIM_DEPTH = 4.0
"""Of the sector below the root circle, over the module, where the body is so deep."""
OF_BODY = 0.8
"""Of what lies between root circle and bore, or inner face of a rim, the sector takes at most so much."""


@dataclass(frozen=True)
class Mesh:
    """A pair at one face width.

    Attributes
    ----------
    pair : CylindricalPair
    perfect : MeshContact
        Of flanks without error, undamped; with what modification they have.
    inputs : Inputs
        What it was made from.
    static : QuasiStatic
        A mesh cycle under the torque, flanks without error.
    """

    pair: CylindricalPair
    perfect: MeshContact
    inputs: Inputs
    static: QuasiStatic

    @cached_property
    def gear(self) -> Bending:
        """How the body of the gear bends."""
        return bending_gear(self.inputs, self.perfect)

    @cached_property
    def pinion(self) -> Bending:
        """How that of the pinion bends, with its shaft."""
        return bending_pinion(self.inputs, self.perfect)

    @property
    def width(self) -> float:
        """Of the teeth, m."""
        return self.pair.face_width

    @property
    def stiffness(self) -> float:
        """Mean over the mesh cycle, N/m."""
        return self.static.mean_stiffness

    @property
    def ripples(self) -> tuple[float, ...]:
        """ε of the mesh orders 1, 2, …: k = k_m (1 + Σ ε_n cos(n θ + φ_n))."""
        return tuple(self.static.ripple(n)[0] for n in ORDERS)

    @property
    def ripple_phases(self) -> tuple[float, ...]:
        """φ_n, rad."""
        return tuple(self.static.ripple(n)[1] for n in ORDERS)

    @property
    def static_errors(self) -> tuple[complex, ...]:
        """Harmonics of the error that these flanks make beside the stiffness, m: e_n of e = Re Σ e_n
        exp(i n θ), so that F/k + e, with k of `ripples`, is the static error under load. Relief and crowning
        make it, and contact beyond the path of contact.
        """
        theta = 2.0 * np.pi * self.static.phase
        waves = sum(
            ripple * np.cos(n * theta + phase)
            for n, ripple, phase in zip(ORDERS, self.ripples, self.ripple_phases, strict=True)
        )
        left = self.static.transmission_error - self.static.force / (self.stiffness * (1.0 + waves))
        found = (self.static.error_harmonic(n, left) for n in ORDERS)
        return tuple(complex(amplitude * np.exp(1j * angle)) for amplitude, angle in found)

    def contact(
        self,
        inputs: Inputs,
        *,
        errors: tuple[tuple[float, float], ...] = (),
        damping: float = 1.0,
        flexible: bool = False,
        flexible_pinion: bool = False,
    ) -> MeshContact:
        """The contact with an error on its flanks, damped as ξ_m asks for.

        Parameters
        ----------
        inputs : Inputs
        errors : tuple of (float, float)
            Of the mesh orders 1, 2, …: amplitude, m, and phase, rad.
        damping : float
            Over what matches ξ_m: the damping time 2 ξ_m/√(k/m_e).
        flexible : bool
            Whether the gear's body bends.
        flexible_pinion : bool
            Whether the pinion's does.

        Returns
        -------
        MeshContact
        """
        time = 2.0 * damping * inputs.mesh_damping / inputs.natural_frequency(self.stiffness)
        waves = tuple((each, phase, n) for n, (each, phase) in enumerate(errors, start=1) if each)
        shape = replace(self.perfect.topography, error=waves)
        bending = self.bending(flexible, flexible_pinion)
        contact = self.perfect if bending is None else self.perfect.with_modes(bending.rim)
        return contact.with_(damping_time=time, topography=shape)

    def bending(self, flexible: bool, flexible_pinion: bool = False) -> Bending | None:
        """Modes of the bodies that bend; None where both are rigid.

        Parameters
        ----------
        flexible, flexible_pinion : bool
            Whether the gear does, and the pinion.

        Returns
        -------
        Bending or None
        """
        if not flexible:
            return self.pinion if flexible_pinion else None
        return self.gear.and_(self.pinion) if flexible_pinion else self.gear

    def modes(self, flexible: bool, flexible_pinion: bool = False) -> Modes | None:
        """The same as the machine takes them."""
        found = self.bending(flexible, flexible_pinion)
        return None if found is None else found.modes


def mesh_of(
    inputs: Inputs,
    width: float,
    torque: float,
    settings: SectorSettings | None = None,
    slices: int = SLICES,
) -> Mesh:
    """The mesh of the inputs at a face width.

    Parameters
    ----------
    inputs : Inputs
    width : float
        m.
    torque : float
        On the pinion, N·m.
    settings : SectorSettings, optional
        Of the finite elements, but for a sector deeper than the body; those of a verification where nothing
        is given.
    slices : int
        Of the face.

    Returns
    -------
    Mesh
    """
    pair = replace(inputs.pair, face_width=width)
    contact = MeshContact.of(
        pair,
        _compliances(inputs, pair, settings),
        materials=inputs.materials,
        slices=slices,
        topography=Topography(modification=inputs.modification),
        reach=max(CORNER_REACH, DEFLECTIONS * inputs.mean_force / inputs.mean_stiffness),
    )
    return Mesh(pair, contact, inputs, _turned(inputs, contact, torque))


def _turned(inputs: Inputs, contact: MeshContact, torque: float, why: str = "") -> QuasiStatic:
    """A mesh cycle under a torque. For more than flanks carry raises `NotVerifiableError`, of the torque
    that the case states."""
    try:
        return quasi_static(contact, torque, phases=PHASES)
    except GearlashError as error:
        expected = f"less: {why}{error} at a face width of {1e3 * contact.flanks.pair.face_width:.4g} mm"
        problem = Problem("operation.torque", f"{inputs.torque:.4g} N·m", expected)
        raise NotVerifiableError(inputs.case, [problem]) from error


def _compliances(
    inputs: Inputs, pair: CylindricalPair, settings: SectorSettings | None
) -> tuple[FlankCompliance, FlankCompliance]:
    """Of both gears. A body that is less deep than the usual sector has a smaller one."""
    from gearlash.multibody.compliance import SectorSettings, pair_compliances

    bodies = zip(pair.gears, inputs.bodies, strict=True)
    depth = min(0.5 * (gear.root_diameter - (body.rim_inner_diameter or body.bore)) for gear, body in bodies)
    ratio = OF_BODY * depth / pair.pinion.normal_module
    widths = pair.face_width, pair.face_width
    if settings is not None:
        settings = replace(settings, rim_depth=min(settings.rim_depth, ratio))
        return pair_compliances(pair, widths, inputs.materials, settings, keep=False)
    if ratio >= RIM_DEPTH:
        return pair_compliances(pair, widths, inputs.materials)
    return pair_compliances(pair, widths, inputs.materials, SectorSettings(rim_depth=ratio))


def modified(mesh: Mesh, relief: Relief) -> Mesh:
    """The same teeth with modified flanks.

    Parameters
    ----------
    mesh : Mesh
    relief : Relief
        In place of what the case states.

    Returns
    -------
    Mesh
    """
    return _with_shape(mesh, Topography(relief=relief))


def unmodified(mesh: Mesh) -> Mesh:
    """The same teeth with plain involute flanks.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    Mesh
    """
    return _with_shape(mesh, Topography(modification=PairModification()))


def _with_shape(mesh: Mesh, shape: Topography) -> Mesh:
    return _under(replace(mesh, perfect=mesh.perfect.with_(topography=shape)), mesh.static.torque)


def _under(mesh: Mesh, torque: float, why: str = "") -> Mesh:
    """The same teeth under a torque, turned slowly through a mesh cycle; ``why`` it is that torque."""
    return replace(mesh, static=_turned(mesh.inputs, mesh.perfect, torque, why))


def scaled_mesh(inputs: Inputs, full: Mesh) -> Mesh:
    """The same teeth under the torque that is to that of the case as their stiffness to that of the case.

    Real teeth are stiffer the more they carry, so this torque is the solution of an equation. Stiffness grows
    less than in proportion to the torque, so each torque that follows from the last stiffness is nearer.

    Parameters
    ----------
    inputs : Inputs
    full : Mesh
        Of the width of the case.

    Returns
    -------
    Mesh

    Raises
    ------
    NotVerifiableError
        Where no torque is within a thousandth of the one wanted.
    """
    found = full
    for _ in range(MOST_TORQUES):
        wanted = inputs.torque * found.stiffness / inputs.mean_stiffness
        if abs(wanted / found.static.torque - 1.0) < CLOSE_TORQUE:
            return found
        found = _under(full, wanted, f"dimensionless numbers are held at {wanted:.4g} N·m, and ")
    expected = (
        f"one beside which a torque exists that makes teeth of {full.width * 1e3:.4g} mm as stiff, over "
        f"{inputs.mean_stiffness:.4g} N/m, as that torque is over this one"
    )
    raise NotVerifiableError(inputs.case, [Problem("operation.torque", f"{inputs.torque:.4g} N·m", expected)])


def matched_mesh(inputs: Inputs, full: Mesh) -> Mesh:
    """The face width whose computed stiffness is that of the case, and its mesh.

    Parameters
    ----------
    inputs : Inputs
    full : Mesh
        Of the width of the case: where the search begins.

    Returns
    -------
    Mesh
        The nearest of those tried, where none is within `CLOSE`.
    """
    tried = [full]
    while len(tried) <= MOST_WIDTHS and not is_close(inputs, tried[-1]):
        width = _next_width(inputs, tried)
        if width is None:
            break
        tried.append(mesh_of(inputs, width, inputs.torque))
    return min(tried, key=lambda mesh: abs(mesh.stiffness - inputs.mean_stiffness))


def _next_width(inputs: Inputs, tried: Sequence[Mesh]) -> float | None:
    """By the line through the last two, or the origin and the first; between those that are too soft and too
    stiff, and not too far from the last. None where no other width is left to try."""
    wanted, last = inputs.mean_stiffness, tried[-1]
    before = (tried[-2].width, tried[-2].stiffness) if len(tried) > 1 else (0.0, 0.0)
    slope = (last.stiffness - before[1]) / (last.width - before[0])
    guess = last.width + (wanted - last.stiffness) / slope if slope > 0.0 else last.width
    soft = max((mesh.width for mesh in tried if mesh.stiffness < wanted), default=None)
    stiff = min((mesh.width for mesh in tried if mesh.stiffness > wanted), default=None)
    if soft is not None and stiff is not None:
        guess = guess if soft < guess < stiff else 0.5 * (soft + stiff)
    elif stiff is not None:
        guess = max(guess if guess < stiff else 0.0, stiff / FARTHEST)
    elif soft is not None:
        guess = min(guess if guess > soft else np.inf, soft * FARTHEST)
    width = _rounded(guess)
    known = any(width == mesh.width for mesh in tried)
    return None if known or width > WIDEST * tried[0].width else width


def is_close(inputs: Inputs, mesh: Mesh) -> bool:
    """Whether a mesh is as stiff as the case says.

    Parameters
    ----------
    inputs : Inputs
    mesh : Mesh

    Returns
    -------
    bool
    """
    return abs(mesh.stiffness / inputs.mean_stiffness - 1.0) < CLOSE


def _rounded(width: float) -> float:
    """To a power of ten metres that is a hundredth of it or less: finite elements are kept by width."""
    digits = -int(np.floor(np.log10(CLOSE * 2.0 * width)))
    return round(width, digits)
