"""What other starts lead to, at the same parameters."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearlash.system import Label, Status


@dataclass(frozen=True)
class BesideMotion:
    """A motion that one or more of the other starts lead to.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> start = family.start()
    >>> found = gl.attractor(family.system({"omega": 0.8}), start)
    >>> (other,) = gl.motions_beside(found, dict(zip(family.states, start)), start).others
    >>> str(other.label), other.starts, other.impacts
    ('1-1-0', 8, True)
    """

    label: Annotated[Label, "P-Q-R (/Q-R of every further clearance), aperiodic, neutral or unresolved"]
    status: Annotated[Status, "ok, or why it is not to be relied on"]
    starts: Annotated[int, "how many of the other starts lead to it"]
    impacts: Annotated[bool | None, "does it have impacts? null where nothing was settled"]
    start: Annotated[dict[str, float], "the first of these starts, by state name: --initial takes it"]


@dataclass(frozen=True)
class Beside:
    """Whether another motion coexists with the one found, as far as a few other starts show.

    The starts are the motion itself, with the relative velocity in a clearance raised and lowered; all states
    zero; and of a system with one clearance the periodic motions that it would have if contact were kept on
    one side, or never made. What these do not find may exist all the same.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> start = family.start()
    >>> found = gl.attractor(family.system({"omega": 0.8}), start)
    >>> beside = gl.motions_beside(found, dict(zip(family.states, start)), start)
    >>> beside.starts, beside.same, beside.undecided, len(beside.others)
    (11, 3, 0, 1)
    """

    starts: Annotated[int, "other starts that were followed"]
    same: Annotated[
        int, "how many of them lead back to the motion that was found; two aperiodic motions count as one"
    ]
    undecided: Annotated[int, "how many of them led to nothing that could be named in the time they had"]
    others: Annotated[tuple[BesideMotion, ...], "different motions, those of the most starts first"]
