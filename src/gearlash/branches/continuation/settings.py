"""How a branch is followed."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.system import GearlashError, Record


@dataclass(frozen=True, repr=False)
class ContinuationSettings(Record):
    """How a branch is followed.

    Lengths of steps are in scaled unknowns: 1 is the width of the parameter's interval, or as far as the
    states move in the course of the first orbit.

    Parameters
    ----------
    first, shortest, longest : float
        Lengths of the first step, and of any; 0 < shortest ≤ first ≤ longest ≤ 1. Where the states move
        farther than on the first orbit, the longest step is as much longer.
    angle : float
        Largest angle in rad between the directions of the branch at both ends of a step, 0.01 to 1.
    most_points : int
        In each of the two ways from the first orbit.
    certify : bool
        Whether every orbit is certified (about 1 ms each).

    Raises
    ------
    GearlashError
        For lengths or an angle that are none.

    Examples
    --------
    >>> import gearlash as gl
    >>> coarse = gl.ContinuationSettings(longest=0.1, certify=False)
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> limits = {"lower": 1.4, "upper": 1.6}
    >>> branch = gl.continue_branch(family, "omega", values={"omega": 1.5}, **limits, steps=coarse)
    >>> branch.name
    'omega'
    """

    first: float = 1e-3
    shortest: float = 1e-9
    longest: float = 0.05
    angle: float = 0.3
    most_points: int = 2_000
    certify: bool = True

    def __post_init__(self) -> None:
        super().__post_init__()
        if not 0.0 < self.shortest <= self.first <= self.longest <= 1.0:
            raise GearlashError(
                f"lengths of steps {self.shortest:g}, {self.first:g}, {self.longest:g}: expected "
                "0 < shortest ≤ first ≤ longest ≤ 1"
            )
        if not 0.01 <= self.angle <= 1.0:
            raise GearlashError(f"angle = {self.angle:g}: expected 0.01 to 1 rad")
        if self.most_points < 1:
            raise GearlashError(f"most_points is {self.most_points}: expected 1 or more")
