"""What a touch does to the multipliers of an orbit: the square-root law, predicted from the field.

An excursion of depth d beyond the boundary changes the motion by w = s (4/3) √(2/|a0|) d^{3/2} v, with v =
η g under the rule `always`, η g + ζ A g under `in-contact` (A: Jacobian of the region grazed from), and v = g
where with `no-tension` the force itself touches zero. So the monodromy changes by √d times a matrix of rank
one, and every simple multiplier as λ0 + c √d. Sources: A. Nordmark, J. Sound Vib. 145 (1991) 279,
doi:10.1016/0022-460X(91)90592-8; M. di Bernardo, C. Budd, A. Champneys, Physica D 160 (2001) 222,
doi:10.1016/S0167-2789(01)00349-9. A touch from the gap under `no-tension` has no such law: it is linear."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Carried, Hold, Propagators
from gearlash.flow.regions import matrix_of
from gearlash.orbits import Orbit, orbit_at
from gearlash.orbits.floquet import ordered
from gearlash.orbits.grazing import force_gradient
from gearlash.system import Clearance, ContactRule, Family, GearlashError, Record, evaluate, given

from .branch import Branch
from .corner import abrupt
from .equations import Array, Line
from .extrema import Extrema, Extremum
from .points import SpecialKind, SpecialPoint

Complex = NDArray[np.complex128]
HELD = 1e-3  # mesh cycles on either side of the touch in which the boundary is not crossed
BESIDE = 1e-5  # of the parameter's interval: where the rate of the extremum is read, on the clear side
SHALLOW = 0.25  # of what the coordinate travels: depth up to which the law is taken at its word
SMALL = 1e-6  # what counts as zero in the conditions of the law


@dataclass(frozen=True, eq=False, repr=False)
class GrazingLaw(Record):
    """The square-root law of a touch: every multiplier moves as λ0 + c √d with the depth d beyond it.

    Attributes
    ----------
    value : float
        Of the parameter at the touch.
    multipliers : ndarray of complex, of shape (n,)
        λ0 of the touching orbit, by modulus, descending.
    coefficients : ndarray of complex, of shape (n,)
        c of each, predicted from the field; depths in units of X (of Φ where the force touches zero).
    a0 : float
        X'' (Φ'') at the touch.
    rate : float
        How fast the extremum's distance changes with the parameter, on the side without the change.
    missing : tuple of str
        Conditions of the law that do not hold within 1e-6, in words: it then says nothing.
    predicted_depth, predicted_value : float
        Where a multiplier comes to 1 or -1 first by the law, and the value of the parameter there; NaN where
        none does between the limits of the branch, or not so near that the law could say it: deeper than a
        quarter of what the extremum's coordinate travels in the orbit.
    predicted_kind : SpecialKind or None
        Fold or doubling.
    computed_depth, computed_value : float
        The same of the next fold or doubling of the branch before any other touch; NaN where there is none.
    computed_kind : SpecialKind or None

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    >>> low = min(branch.of_kind("grazing"), key=lambda special: special.value)
    >>> law = gl.grazing_law(case, branch, low)
    >>> law.missing, law.computed_kind.value
    ((), 'fold')
    """

    _printed: ClassVar = ("value", "missing", "predicted_depth", "computed_depth", "predicted_kind")

    value: float
    multipliers: Complex
    coefficients: Complex
    a0: float
    rate: float
    missing: tuple[str, ...]
    predicted_depth: float
    predicted_value: float
    predicted_kind: SpecialKind | None
    computed_depth: float
    computed_value: float
    computed_kind: SpecialKind | None

    @property
    def generic(self) -> bool:
        """Whether all conditions of the law hold."""
        return not self.missing

    def at(self, depth: float) -> Complex:
        """The multipliers at a depth, by the law.

        Parameters
        ----------
        depth : float
            0 or more.

        Returns
        -------
        ndarray of complex, of shape (n,)
            In the order of `multipliers`.
        """
        return self.multipliers + self.coefficients * np.sqrt(given.number("depth", depth, 0.0))


def law_at(family: Family, branch: Branch, special: SpecialPoint) -> GrazingLaw:
    """The law at a touch of a branch. Raises `GearlashError` for what is no touch, and for one from the gap
    under `no-tension`."""
    extremum = special.extremum
    if special.kind is not SpecialKind.GRAZING or extremum is None:
        raise GearlashError(f"a {special.kind} is no touch: expected a special point of kind grazing")
    line = Line(family, branch.values, branch.name, branch.lower, branch.upper)
    props = line.system_at(special.value)
    if abrupt(props.system, extremum):
        raise GearlashError("a touch from the gap under no-tension has no square-root law: it is linear")
    touched = _touched(props, special, extremum)
    multipliers, coefficients = touched.multipliers
    rate = _rate(line, special, extremum)
    missing = _missing(multipliers, coefficients, extremum, rate * line.unit)
    depth, kind = (np.nan, None) if missing else _first(touched)
    there = special.value + touched.way_to(depth, -np.sign(extremum.a0) * rate)
    if not (depth <= SHALLOW * _travel(special, extremum) and branch.lower <= there <= branch.upper):
        depth, there, kind = np.nan, np.nan, None
    beyond = _next(branch, special)
    return GrazingLaw(
        value=special.value,
        multipliers=multipliers,
        coefficients=coefficients,
        a0=extremum.a0,
        rate=rate,
        missing=missing,
        predicted_depth=depth,
        predicted_value=there,
        predicted_kind=kind,
        computed_depth=np.nan if beyond is None else _depth(beyond, extremum),
        computed_value=np.nan if beyond is None else beyond.value,
        computed_kind=None if beyond is None else beyond.kind,
    )


@dataclass(frozen=True, eq=False)
class _Touched:
    """The monodromy W (n, n) of the touching orbit, to which a depth d adds √d a bᵀ: ``whole``, ``column`` a
    and ``row`` b."""

    whole: Array
    column: Array
    row: Array

    def gain(self, multiplier: float) -> float:
        """bᵀ (W - multiplier · I)⁻¹ a. Raises `LinAlgError` where that multiplier is there."""
        matrix = self.whole - multiplier * np.eye(len(self.whole))
        return float(self.row @ np.linalg.solve(matrix, self.column))

    def way_to(self, depth: float, rate: float) -> float:
        """By how much the parameter changes to a depth, which it changes at ``rate`` without the touch: what
        the touch does to the orbit moves the extremum, too, d + (2/3) g d^{3/2} = rate · change."""
        try:
            return (depth + 2.0 / 3.0 * self.gain(1.0) * depth**1.5) / rate if rate else float("nan")
        except np.linalg.LinAlgError:
            return float("nan")

    @property
    def multipliers(self) -> tuple[Complex, Complex]:
        """λ0 and c (n,) of every multiplier."""
        values, right = np.linalg.eig(self.whole)
        moved = (np.linalg.inv(right) @ self.column) * (self.row @ right)
        order = [int(np.argmin(np.abs(values - value))) for value in ordered(values)]
        return values[order].astype(np.complex128), moved[order].astype(np.complex128)


def _touched(props: Propagators, special: SpecialPoint, extremum: Extremum) -> _Touched:
    """From the held orbit, and what the excursion adds to it."""
    start, phase, clearance = special.point.state, extremum.phase, props.system.clearances[extremum.clearance]
    hold = Hold(extremum.boundary, phase - HELD, phase + HELD, extremum.clearance)
    first = _flow(flow.carry(props, start, phase, jacobian=True, hold=hold))
    whole = _flow(flow.carry(props, start, float(special.point.period), jacobian=True, hold=hold))
    gradient = clearance.h
    if extremum.surface == "force":
        gradient = force_gradient(props.system, extremum.clearance, phase, extremum.boundary)
    deeper = -1.0 if extremum.a0 > 0.0 else 1.0  # a minimum goes below its boundary, a maximum above
    size = 2.0 * np.sqrt(2.0 / abs(extremum.a0)) * extremum.boundary * deeper
    column = whole @ np.linalg.solve(first, _kick(props, special, extremum, clearance))
    return _Touched(whole, size * column, gradient @ first)


def _flow(carried: Carried) -> Array:
    assert carried.jacobian is not None
    return carried.jacobian


def _kick(props: Propagators, special: SpecialPoint, extremum: Extremum, clearance: Clearance) -> Array:
    """v (n,): the direction in which an excursion changes the motion."""
    if extremum.surface == "force":
        return clearance.g
    plus = extremum.boundary > 0
    system, phase = props.system, extremum.phase
    series = clearance.stiffness_plus if plus else clearance.stiffness_minus
    kick = float(evaluate(series, 2.0 * np.pi / system.cycles * phase)) * clearance.g
    if clearance.contact is ContactRule.ALWAYS:
        return kick
    trace = flow.trace(props, special.point.state, phase)
    sides = [int(trace.regions_of(j)[-1]) for j in range(len(system.clearances))]
    from_contact = extremum.boundary * extremum.a0 > 0.0
    sides[extremum.clearance] = (0 if plus else 2) if from_contact else 1
    return kick + clearance.dampings[0 if plus else 1] * (matrix_of(system, tuple(sides)) @ clearance.g)


def _rate(line: Line, special: SpecialPoint, extremum: Extremum) -> float:
    """Of the distance with the parameter, on the side where nothing is changed by the touch."""
    period = special.point.period
    for sign in (1.0, -1.0):
        step = sign * BESIDE * line.unit
        distances = []
        for part in (1.0, 2.0):
            props = line.system_at(special.value + part * step)
            orbit: Orbit | None = orbit_at(props, special.point.state, period // props.system.cycles)
            near = [] if orbit is None else _alike(Extrema.of(orbit), extremum)
            if near:
                distances.append(near[0].distance)
        if len(distances) == 2 and distances[0] * extremum.a0 > 0.0:
            return (4.0 * distances[0] - distances[1]) / (2.0 * step)
    return float("nan")


def _alike(extrema: Extrema, extremum: Extremum) -> list[Extremum]:
    """Extrema of the same kind, the nearest in phase first."""
    mine = [each for each in extrema.all if each.group == extremum.group]

    def away(each: Extremum) -> float:
        apart = abs(each.phase - extremum.phase) % extrema.cycles
        return min(apart, extrema.cycles - apart)

    return sorted(mine, key=away)


def _first(touched: _Touched) -> tuple[float, SpecialKind | None]:
    """The least depth at which det(W + √d a bᵀ ∓ I) vanishes: where 1 + √d bᵀ (W ∓ I)⁻¹ a does."""
    found = []
    for target, kind in ((1.0, SpecialKind.FOLD), (-1.0, SpecialKind.DOUBLING)):
        try:
            gain = touched.gain(target)
        except np.linalg.LinAlgError:
            continue
        if gain < 0.0:
            found.append((1.0 / gain**2, kind))
    return min(found, default=(float("nan"), None), key=lambda pair: pair[0])


def _travel(special: SpecialPoint, extremum: Extremum) -> float:
    """From the least to the largest extremum of the coordinate that touches, along the orbit."""
    mine = (extremum.clearance, extremum.surface, extremum.boundary)
    known = [e.distance for e in special.point.extrema if (e.clearance, e.surface, e.boundary) == mine]
    return max(known) - min(known) if len(known) > 1 else np.inf


def _next(branch: Branch, special: SpecialPoint) -> SpecialPoint | None:
    """The next fold or doubling of the branch beyond the touch, on the side where the contact has changed, if
    no other touch comes before it."""
    assert special.extremum is not None
    after = [each for each in branch.special if each.arclength > special.arclength]
    before = [each for each in reversed(branch.special) if each.arclength < special.arclength]
    for side in (after, before):
        if not side or side[0].kind not in (SpecialKind.FOLD, SpecialKind.DOUBLING):
            continue
        if _depth(side[0], special.extremum) > 0.0:
            return side[0]
    return None


def _depth(special: SpecialPoint, extremum: Extremum) -> float:
    """How far beyond its boundary an extremum lies; NaN where it is no longer there."""
    for each in special.point.extrema:
        if each.number == extremum.number:
            return -each.distance if extremum.a0 > 0.0 else each.distance
    return float("nan")


def _missing(multipliers: Complex, coefficients: Complex, extremum: Extremum, rate: float) -> tuple[str, ...]:
    found = []
    if abs(extremum.a0) <= SMALL:
        found.append(f"a0 = {extremum.a0:.1e} is zero: the extremum is born or ends there")
    if float(np.abs(multipliers - 1.0).min()) <= SMALL:
        found.append("a multiplier is 1: the orbit does not depend smoothly on the parameter")
    if np.isnan(rate):
        found.append("how the extremum moves with the parameter was not found")
    elif abs(rate) <= SMALL:
        found.append(f"the extremum does not move with the parameter: {rate:.1e} over its interval")
    if float(np.abs(coefficients).max()) <= SMALL:
        found.append("the touch moves no multiplier")
    return tuple(found)
