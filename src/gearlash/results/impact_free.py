"""Where impact-free motion exists."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

Ending = Literal["contact", "stability", "unsolved"]


@dataclass(frozen=True)
class ImpactFree:
    """Where one motion without impacts exists and is stable, in values of ω.

    It is the motion of teeth that never part, on the side of the load. Nothing is said about other motions at
    the same speeds, nor which starts lead to this one. None (null in JSON): not met within the search.

    Examples
    --------
    >>> import gearlash as gl
    >>> found = gl.impact_free_speeds(gl.load_case("kahraman-singh"))
    >>> found.here, round(found.upper, 4), found.upper_ending
    (True, 0.8206, 'contact')
    """

    here: Annotated[bool, "this motion exists at this speed (perhaps beside the one that was found)"]
    lower: Annotated[float | None, "lower end of the interval around this speed in which it exists"]
    upper: Annotated[float | None, "its upper end"]
    lower_error: Annotated[float | None, "estimate of the error of the lower end"]
    upper_error: Annotated[float | None, "the same of the upper end"]
    lower_ending: Annotated[
        Ending | None,
        "what ends there: contact (a grazing), stability (it is unstable beyond), or unsolved (it could "
        "not be solved for beyond)",
    ]
    upper_ending: Annotated[Ending | None, "the same of the upper end"]
    nearest: Annotated[float | None, "nearest speed found at which it exists, where it does not exist here"]
    nearest_error: Annotated[float | None, "estimate of its error"]
    searched_from: Annotated[float, "the least speed that was looked at"]
    searched_to: Annotated[float, "the largest speed that was looked at"]
    step: Annotated[
        float,
        "distance between two speeds that were looked at, over the speed, at the most: what is narrower may "
        "have been missed",
    ]
