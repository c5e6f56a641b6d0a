"""How a motion was followed along a parameter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from gearlash.system import Label

INTERRUPTED = "interrupted"  # why a motion was not followed further


@dataclass(frozen=True)
class PassedBifurcation:
    """A change of the motion on the way that is no grazing (none: no stable orbit was found there).

    Attributes
    ----------
    kind : {"fold", "doubling", "Neimark-Sacker", "branch point"}
    value : float
        Of the parameter.
    label_below, label_above : Signature or MotionKind
        Of the motions below and above this value.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> path, _ = gl.first_grazing(case, "omega", gl.point(case, {"omega": 1.0}, name="omega"), "down")
    >>> [(change.kind, round(change.value, 4)) for change in path.passed]
    [('fold', 0.708)]
    """

    kind: str
    value: float
    label_below: Label
    label_above: Label


@dataclass(frozen=True)
class FollowedPath:
    """Where the motion was followed to.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> path, _ = gl.first_grazing(case, "omega", gl.point(case, {"omega": 0.8}, name="omega"), "up")
    >>> path.ended, path.decided
    ('grazing at 0.8206310877', True)
    """

    direction: Annotated[Literal["down", "up"], "to lower values of the parameter, or to higher ones"]
    reached: Annotated[float, "last value at which it was found"]
    ended: Annotated[str, "why it was not followed further"]
    decided: Annotated[
        bool, "whether a grazing, the end of the motion, or the end of the search is there; else it was lost"
    ]
    beyond: Annotated[str, "what the orbit does just beyond its grazing"]
    passed: Annotated[tuple[PassedBifurcation, ...], "changes on the way that are no grazing"]
