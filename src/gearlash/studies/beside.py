"""A few other starts at the same parameters: does another motion coexist with the one found?

From the motion itself the relative velocity in every clearance is raised and lowered, a little and much, so
that contact is lost or made; of a system with one clearance the periodic motions without any change of
contact are tried, too.
Each start is followed for `BUDGET` base periods at the most.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash import orbits
from gearlash.orbits import Aperiodic, Attractor, Orbit, Settings, Unresolved
from gearlash.results.beside import Beside, BesideMotion
from gearlash.studies.impact_free import linear_states
from gearlash.system import Clearance, GearlashError, Status, System, given

from .arguments import checked_settings

Array = NDArray[np.float64]

BUDGET = 2_000  # base periods of one start
KICKS = (-1.0, 1.0, -2.0, 2.0, -4.0, 4.0, -8.0, 8.0, 16.0)
"""In units of what carries the motion across its clearance. The larger ones lead to motions of much energy
that go on below a resonance, where speed that comes down from it finds them."""
THROWS = (4.0, -4.0, 16.0)
"""Of the cold start, in the same units: what is tried at every speed of a range, and not at one alone."""
MOST_STARTS = 16  # starts in all, beside those that are given
SAME_MOTION = 1e-6  # of the size of a motion: what agrees so well is the same
SMALLEST_SIZE = 1e-3  # of a clearance's own numbers, where the motion has no size


def motions_beside(
    found: Attractor,
    start: Mapping[str, float],
    cold_start: ArrayLike,
    *,
    more: Sequence[ArrayLike] = (),
    settings: Settings | None = None,
    tell: Callable[[int, int], object] | None = None,
) -> Beside | None:
    """Looks for other motions at the parameters at which one was found.

    From the motion itself the velocity in every clearance is raised and lowered, so that contact is lost or
    made; the cold start and rest are tried, and of a system with one clearance the periodic motions without
    any change of contact. Each start is followed for 2,000 base periods at the most.

    Parameters
    ----------
    found : Orbit, Aperiodic, Neutral or Unresolved
        The motion, as from `attractor`.
    start : mapping of str to float
        The state, by name, from which it was found: it is not tried again.
    cold_start : array_like of shape (n,)
        Such as ``family.start()``.
    more : sequence of array_like of shape (n,)
        Starts that are tried first, such as states of motions at parameters next to these.
    settings : Settings, optional
        How every attractor is looked for.
    tell : callable, optional
        Hears how many starts were followed, out of how many.

    Returns
    -------
    Beside or None
        The other motions and how many starts lead to each; None where ``found`` is no motion to compare with.

    Raises
    ------
    GearlashError
        For a start that does not fit the system.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> start = family.start({"omega": 0.8})
    >>> found = gl.attractor(family.system({"omega": 0.8}), start)
    >>> beside = gl.motions_beside(found, dict(zip(family.states, start)), start)
    >>> beside.starts, beside.same, [other.label for other in beside.others]
    (11, 3, [1-1-0])
    """
    given.instance("found", found, (Orbit, Aperiodic), "a motion, as from gearlash.attractor")
    if tell is not None:
        given.function("tell", tell, "a function of two whole numbers")
    if found.status not in (Status.OK, Status.UNCERTAIN):
        return None
    size = found.propagators.system.size
    own = given.numbers("start", list(given.mapping("start", start).values()), (size,))
    cold = given.numbers("cold_start", cold_start, (size,))
    settings = checked_settings(settings)
    settings = replace(settings, budget=min(settings.budget, BUDGET))
    given_starts = [given.numbers("more", state, (size,)) for state in more]
    starts = _different(found, own, [*given_starts, *_starts(found, cold)], MOST_STARTS + len(given_starts))
    same = undecided = 0
    others: list[tuple[Attractor, Array, int]] = []
    for done, state in enumerate(starts, 1):
        other = _followed(found, state, settings)
        if tell is not None:
            tell(done, len(starts))
        if other is None or isinstance(other, Unresolved):
            undecided += 1
        elif _same(found, other):
            same += 1
        else:
            at = next((i for i, known in enumerate(others) if _same(known[0], other)), None)
            if at is None:
                others.append((other, state, 1))
            else:
                others[at] = (*others[at][:2], others[at][2] + 1)
    rows = sorted(others, key=lambda row: -row[2])
    return Beside(len(starts), same, undecided, tuple(_motion(*row, list(start)) for row in rows))


def _different(found: Attractor, own: Array, states: Iterable[Array], most: int) -> list[Array]:
    """Each once, without the start that was used and without states of the motion itself."""
    near = SAME_MOTION * max(1.0, float(np.abs(found.strobes).max()))
    kept: list[Array] = []
    for state in states:
        known = np.array([own, *kept, *found.strobes])
        if float(np.abs(known - state).max(axis=1).min()) > near:
            kept.append(state)
    return kept[:most]


def _starts(found: Attractor, cold: Array) -> Iterator[Array]:
    """Other states, those first that are the likeliest to lead elsewhere."""
    system, state = found.propagators.system, np.asarray(found.final_state, dtype=np.float64)
    kicks = [Kick.of(system, c, found, i) for i, c in enumerate(system.clearances)]
    yield cold
    if cold.any():
        yield np.zeros(system.size)
    if len(system.clearances) == 1:
        yield from linear_states(system)
    for factor in KICKS:
        for kick in kicks:
            yield state + factor * kick.velocity * kick.direction


def thrown(found: Attractor, cold: Array) -> list[Array]:
    """The cold start with the velocity in the first clearance raised and lowered: teeth are thrown together
    and apart, so that motions of much energy are met. None where ``found`` is no motion to measure it by."""
    if found.status not in (Status.OK, Status.UNCERTAIN):
        return []
    kick = Kick.of(found.propagators.system, found.propagators.system.clearances[0], found, 0)
    return [cold + factor * kick.velocity * kick.direction for factor in THROWS]


@dataclass(frozen=True)
class Kick:
    """A change of state that is one of the velocity of a gap: its direction, and how much matters."""

    direction: Array
    velocity: float

    @staticmethod
    def of(system: System, clearance: Clearance, found: Attractor, index: int) -> Kick:
        row = clearance.h @ system.matrix  # of the gap's velocity
        if not row.any():
            row = clearance.h
        stiffness = max(clearance.stiffness_plus[0], clearance.stiffness_minus[0])
        own = float(np.sqrt(abs(clearance.h @ system.matrix @ clearance.g) * abs(stiffness)))
        x = found.trace.extrema_of(index).displacement
        if not len(x):  # a motion at rest
            x = found.trace.at([found.trace.phase], index).displacement
        edges = (clearance.gap_plus, -clearance.gap_minus)
        apart = min(abs(float(one) - edge) for one in (x.min(), x.max()) for edge in edges)
        wide = clearance.gap_plus + clearance.gap_minus
        across = min(wide, 2.0 * float(x.max() - x.min()) + apart) if wide > 0.0 else float(np.ptp(x))
        across = max(across, SMALLEST_SIZE * max(1.0, abs(float(x.mean()))))
        return Kick(row / float(row @ row), across * max(system.omega, own))


def _followed(found: Attractor, start: Array, settings: Settings) -> Attractor | None:
    try:
        return orbits.attractor(found.propagators, start, settings)
    except (GearlashError, np.linalg.LinAlgError):
        return None


def _same(one: Attractor, other: Attractor) -> bool:
    """The same motion: one orbit at another of its phases too; two aperiodic motions count as one."""
    if one.label != other.label:
        return False
    if not (isinstance(one, Orbit) and isinstance(other, Orbit)):
        return True
    size = max(float(np.abs(one.strobes).max()), SMALLEST_SIZE)
    apart = np.abs(one.strobes[:, None, :] - other.state[None, None, :]).max(axis=2)
    return bool(apart.min() <= SAME_MOTION * size)


def _motion(found: Attractor, start: Array, starts: int, names: list[str]) -> BesideMotion:
    impacts = bool(found.signature.impacts) if isinstance(found, Orbit) else bool(len(found.events))
    return BesideMotion(
        label=found.label,
        status=found.status,
        starts=starts,
        impacts=impacts,
        start=dict(zip(names, map(float, start), strict=True)),
    )
