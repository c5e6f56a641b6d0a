"""The systems that the engine knows: periodically forced, piecewise linear, with clearances.

    z' = M z + b(θ) + Σ_j g_j Φ_j,                                θ = ω τ
    Φ_j = η_j^±(θ) · deadzone(X_j; -D_j⁻, D_j⁺) + ζ_j^± X_j',         X_j = h_j·z - e_j(θ),  h_j·g_k = 0

Nothing here knows about gears.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from . import given
from .harmonics import Fourier, constant
from .record import Record
from .status import GearlashError, Named

Vector = NDArray[np.float64]
SMALLEST_ENTRY = 1e-100  # of the largest number of h and of g
MOST_CLEARANCES = 8
"""Of a system: 3^8 regions are numbered."""
SERIES = "stiffness_plus", "stiffness_minus", "offset"
NUMBERS = "gap_plus", "gap_minus", "damping"


class ContactRule(Named):
    """When the contact damping acts: in the gap too, in contact only, or never pulling."""

    ALWAYS = "always"
    """Damping acts in contact and in the gap."""
    IN_CONTACT = "in-contact"
    """Damping acts in contact only."""
    NO_TENSION = "no-tension"
    """As in contact only, but contact ends where the force falls to zero: the sides never pull."""


@dataclass(frozen=True, eq=False, repr=False)
class Clearance(Record):
    """One gap with its two sides.

    A side acts if its own stiffness, or the damping stated for it, is not zero (`stops`). A damping in common
    is not inherited by a side without stiffness from one that has some: that side is no stop at all. Where
    neither has stiffness it is stated for both. Under the rule `always` damping belongs to no side, and
    stiffness alone decides.

    Parameters
    ----------
    h : array_like of shape (n,)
        Reads the gap coordinate X = h·z - offset(θ). Its largest number is from 1e-100 to 1e100.
    g : array_like of shape (n,)
        How the contact force Φ enters the state equations; sizes as those of ``h``.
    gap_plus : float
        D⁺: side + is in contact where X > D⁺.
    gap_minus : float
        D⁻: side - is in contact where X < -D⁻; D⁺ + D⁻ is 0 or more.
    stiffness_plus : float or array_like of odd length
        Of side +, as a Fourier series ``[mean, c1, s1, ...]`` of θ over the base period.
    stiffness_minus : float or array_like of odd length
        Of side -.
    damping : float
        ζ of both sides: Φ holds ζ X'.
    offset : float or array_like of odd length
        Fourier series that is taken from h·z.
    contact : ContactRule or str
        When the damping acts.
    name : str
        Told in results; different for every clearance of a system.
    damping_minus : float, optional
        ζ of side -, where it has its own; not with the rule `always`.

    Raises
    ------
    GearlashError
        For arguments that are no such numbers.

    Examples
    --------
    >>> import gearlash as gl
    >>> stop = gl.Clearance([1.0, 0.0], [0.0, -1.0], 0.5, 100.0, 8.0, 0.0, contact="in-contact", name="stop")
    >>> stop.stops(1), stop.stops(-1)
    (True, False)
    """

    h: Vector
    g: Vector
    gap_plus: float
    gap_minus: float
    stiffness_plus: Fourier
    stiffness_minus: Fourier
    damping: float = 0.0
    offset: Fourier = field(default_factory=lambda: constant(0.0))
    contact: ContactRule = ContactRule.ALWAYS
    name: str = "mesh"
    damping_minus: float | None = None

    def __post_init__(self) -> None:
        name = given.word("name of a clearance", self.name)
        of = f"clearance {name!r}: "
        arrays = {key: given.kept(given.numbers(f"{of}{key}", getattr(self, key), ("n",))) for key in "hg"}
        arrays |= {key: given.series(f"{of}{key}", getattr(self, key)) for key in SERIES}
        plain = {key: given.number(f"{of}{key}", getattr(self, key)) for key in NUMBERS}
        if self.damping_minus is not None:
            plain["damping_minus"] = given.number(f"{of}damping_minus", self.damping_minus)
        contact = given.choice(ContactRule, f"contact rule of clearance {name!r}", self.contact)
        for key, value in {**arrays, **plain, "name": name, "contact": contact}.items():
            object.__setattr__(self, key, value)

    @property
    def dampings(self) -> tuple[float, float]:
        """Damping in contact on side + and on side -."""
        return self.damping, self.damping if self.damping_minus is None else self.damping_minus

    def stops(self, boundary: int) -> bool:
        """Whether anything acts behind a boundary: stiffness of that side, or damping stated for it.

        Parameters
        ----------
        boundary : {1, -1}
            Side + or side -.

        Returns
        -------
        bool
        """
        return self._stopping[0 if boundary > 0 else 1]

    @cached_property
    def _stopping(self) -> tuple[bool, bool]:
        """Of side + and side -."""
        stiff = bool(self.stiffness_plus.any()), bool(self.stiffness_minus.any())
        always, inherited = self.contact is ContactRule.ALWAYS, self.damping_minus is None
        damped = (
            not always and not (inherited and stiff[1 - side]) and self.dampings[side] != 0.0
            for side in (0, 1)
        )
        plus, minus = (one or other for one, other in zip(stiff, damped, strict=True))
        return plus, minus


@dataclass(frozen=True, eq=False, repr=False)
class System(Record):
    """A periodically forced, piecewise-linear system with clearances, all numbers fixed.

    z' = M z + b(θ) + Σ_j g_j Φ_j with θ = ω τ, Φ_j the contact force of clearance j. What is handed over is
    copied into plain arrays that nothing changes any more.

    Parameters
    ----------
    omega : float
        ω = dθ/dτ, above 0; 2π of θ are one mesh cycle.
    matrix : array_like of shape (n, n)
        M, without any contact.
    forcing : array_like of shape (n, 2H+1)
        b: a Fourier series ``[mean, c1, s1, ...]`` of θ for every state, over the base period.
    clearances : tuple of Clearance
        One to eight for the engine; their h and g have n numbers, and h_j·g_k = 0 for all pairs.
    cycles : int
        Mesh cycles of the base period, after which everything repeats; 1 or more.

    Raises
    ------
    GearlashError
        For what is no such number, shapes that disagree, ω ≤ 0, a gap of negative width, or h·g ≠ 0 (the
        contact force would act on the velocity of a gap directly).

    Examples
    --------
    >>> import gearlash as gl
    >>> stop = gl.Clearance([1.0, 0.0], [0.0, -1.0], 0.5, 100.0, 8.0, 0.0, name="stop")
    >>> matrix = [[0.0, 1.0], [-1.0, -0.1]]
    >>> forcing = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]]  # cos θ drives the velocity
    >>> system = gl.System(0.8, matrix, forcing, (stop,))
    >>> system.size, round(system.period, 4)
    (2, 7.854)
    """

    omega: float
    matrix: NDArray[np.float64]
    forcing: NDArray[np.float64]
    clearances: tuple[Clearance, ...]
    cycles: int = 1

    def __post_init__(self) -> None:
        plain = {
            "omega": given.positive("omega", self.omega),
            "matrix": given.kept(given.numbers("matrix", self.matrix, ("n", "n"))),
            "forcing": given.kept(given.numbers("forcing", self.forcing, ("n", "odd"))),
            "clearances": given.instances("clearances", self.clearances, Clearance, "a tuple of Clearance"),
            "cycles": given.whole("cycles", self.cycles),
        }
        for key, value in plain.items():
            object.__setattr__(self, key, value)
        problems = _problems(self)
        if problems:
            raise GearlashError("not a valid system: " + "; ".join(problems))

    @property
    def size(self) -> int:
        """Number of states n."""
        return self.matrix.shape[0]

    @property
    def period(self) -> float:
        """Duration of the base period in τ."""
        return 2.0 * np.pi * self.cycles / self.omega

    @property
    def excited(self) -> bool:
        """Does anything vary with time: the forcing, or stiffness or offset of a clearance that acts? A
        system without comes to rest, or moves by itself; its period is that of no excitation."""
        acting = [c for c in self.clearances if c.stops(1) or c.stops(-1) or any(c.dampings)]
        series = [s for c in acting for s in (c.stiffness_plus, c.stiffness_minus, c.offset)]
        return any(bool(s[..., 1:].any()) for s in (self.forcing, *series))


def _problems(system: System) -> list[str]:
    n = system.matrix.shape[0]
    found = []
    if system.matrix.shape != (n, n) or n == 0:
        found.append(f"matrix has shape {system.matrix.shape}, expected (n, n)")
    if system.forcing.shape[0] != n or system.forcing.shape[1] % 2 == 0:
        found.append(f"forcing has shape {system.forcing.shape}, expected ({n}, odd)")
    for clearance in system.clearances:
        found += [f"clearance {clearance.name!r}: {text}" for text in _clearance_problems(clearance, n)]
    return found or _couplings(system.clearances)


def _couplings(clearances: tuple[Clearance, ...]) -> list[str]:
    """h_j·g_k = 0 for all pairs, to rounding: a contact force acts on accelerations, on no gap's velocity
    directly."""
    found = []
    for reader in clearances:
        for actor in clearances:
            terms = float(np.abs(reader.h) @ np.abs(actor.g))
            sizes = float(np.linalg.norm(reader.h) * np.linalg.norm(actor.g))  # in turned coordinates
            if abs(float(reader.h @ actor.g)) > max(1e-14 * terms, 1e-15 * sizes):
                found.append(
                    f"h of clearance {reader.name!r} times g of {actor.name!r} is not zero: contact forces "
                    "must act on accelerations, not on the velocity of a gap"
                )
    names = [c.name for c in clearances]
    if len(set(names)) < len(names):
        found.append(f"two clearances have the same name: {', '.join(names)}")
    return found


def size_problem(direction: Vector) -> str:
    """What is wrong with the size of h or g, whose square must be a number."""
    largest = float(np.abs(direction).max(initial=0.0))
    if largest == 0.0 or SMALLEST_ENTRY <= largest <= 1.0 / SMALLEST_ENTRY:
        return ""
    return (
        f"has {largest:g} as its largest number, expected one from {SMALLEST_ENTRY:g} to "
        f"{1.0 / SMALLEST_ENTRY:g}"
    )


def _clearance_problems(clearance: Clearance, n: int) -> list[str]:
    found = []
    if clearance.h.shape != (n,) or clearance.g.shape != (n,):
        return [f"h and g have shapes {clearance.h.shape}, {clearance.g.shape}, expected ({n},)"]
    width = clearance.gap_plus + clearance.gap_minus
    if width < 0:
        found.append(f"gap has width {width}, expected 0 or more")
    if not clearance.h.any():
        found.append("h is zero: the gap coordinate reads no state")
    found += [f"{name} {text}" for name in ("h", "g") if (text := size_problem(getattr(clearance, name)))]
    if clearance.contact is ContactRule.ALWAYS and len(set(clearance.dampings)) > 1:
        found.append("damping_minus differs from damping, which the rule 'always' does not allow")
    return found
