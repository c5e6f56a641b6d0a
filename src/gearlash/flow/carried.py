"""What a march returns, and a boundary that it does not cross."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from gearlash.system import Record, Status

from ._tables import Array


@dataclass(frozen=True, eq=False, repr=False)
class Strobes(Record):
    """A motion sampled at equal phases, and the contacts that it made in between.

    Attributes
    ----------
    states : array (stretches + 1, n)
        The state at the start and at the end of every stretch.
    contacts : array (stretches, 4·clearances) of int
        Of each clearance and stretch: engagements at + and at -, releases at + and at -.
    undecided : int
        Places where it could not be decided within rounding whether a boundary is touched.
    status : Status
        Whether the motion was carried to its end; where not, the later rows are missing.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> strobes = gl.march(family.system({"omega": 0.9}), family.start({"omega": 0.9}), 20)
    >>> strobes.states.shape, strobes.contacts.shape, strobes.status.ok
    ((21, 2), (20, 4), True)
    """

    _printed: ClassVar = ("status", "undecided", "states", "contacts")

    states: Array
    contacts: Array
    undecided: int
    status: Status


@dataclass(frozen=True, eq=False, repr=False)
class Carried(Record):
    """A state carried from one phase to another.

    Attributes
    ----------
    state : array (n,)
        Where the motion came to.
    jacobian : array (n, n), or None
        Its derivative with respect to the start, where that was asked for.
    contacts : array (4·clearances,) of int
        Of each clearance: engagements at + and at -, releases at + and at -.
    undecided : int
        Places where it could not be decided within rounding whether a boundary is touched.
    status : Status
        Whether the motion was carried to its end.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> carried = gl.variational(family.system(), family.start(), 1.0)
    >>> carried.state.shape, carried.jacobian.shape
    ((2,), (2, 2))
    """

    _printed: ClassVar = ("status", "undecided", "state", "contacts")

    state: Array
    jacobian: Array | None
    contacts: Array
    undecided: int
    status: Status


@dataclass(frozen=True, repr=False)
class Hold(Record):
    """A boundary that is not treated as crossed between two phases.

    What is left is the one-sided, smooth system in which a grazing extremum may pass through the boundary.

    Parameters
    ----------
    boundary : int
        +1 or -1: the side of the clearance.
    begin, end : float
        Phases, in mesh cycles from phase zero, between which it is held.
    clearance : int, default 0
        Number of the clearance.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> system, start = family.system({"omega": 0.9}), [1.1, -0.5]
    >>> len(gl.trace(system, start, 0.5).events)
    1
    >>> len(gl.trace(system, start, 0.5, hold=gl.Hold(1, 0.0, 0.5)).events)
    0
    """

    boundary: int
    begin: float
    end: float
    clearance: int = 0
