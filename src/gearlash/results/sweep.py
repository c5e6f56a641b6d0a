"""A sweep: one attractor per value of a parameter."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar

from gearlash.system import GearlashError, Label, Named, Record, Status, given

from .axis import Axis
from .point import Point


class Direction(Named):
    """Where each point starts: from the cold start, or from the attractor of the point before it."""

    COLD = "cold"
    UP = "up"
    DOWN = "down"


@dataclass(frozen=True, eq=False, repr=False)
class Sweep(Record):
    """One attractor for each value of a parameter.

    Attributes
    ----------
    axis : Axis
        The parameter by short name, and its dimensionless values.
    direction : Direction
    points : tuple of Point
        In the order of the axis, whatever the direction, one for every value.
    complete : bool
        False where the sweep was stopped early; what is missing has the status `not-computed`.
    message : str
        Why it is not complete.
    fixed : mapping of str to float
        Other parameters that were set, over those of the model.
    start : str
        What its points start from, where that has a name of its own: a report has "thrown +4" for the cold
        start with teeth thrown together or apart.

    Examples
    --------
    >>> import gearlash as gl
    >>> found = gl.sweep(gl.load_case("kahraman-singh"), gl.Axis.even("omega", 0.5, 1.0, 6))
    >>> found.shares
    {1-0-0: 4, 1-1-0: 2}
    >>> found.runs()
    [(0, 3, 1-0-0), (4, 5, 1-1-0)]
    """

    _printed: ClassVar = ("axis", "direction", "shares", "statuses", "complete", "message", "fixed")

    axis: Axis
    direction: Direction
    points: tuple[Point, ...]
    complete: bool = True
    message: str = ""
    fixed: Mapping[str, float] = field(default_factory=dict)
    start: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "direction", given.choice(Direction, "direction", self.direction))
        super().__post_init__()
        points = given.instances("points of a sweep", self.points, Point, "a tuple of Point")
        if len(points) != len(self.axis):
            raise GearlashError(f"a sweep of {len(self.axis)} values has {len(points)} points")

    @property
    def way(self) -> str:
        """How its motions were found: the name of its start, or its direction."""
        return self.start or str(self.direction)

    @property
    def computed(self) -> int:
        """How many points were computed."""
        return sum(point.status is not Status.NOT_COMPUTED for point in self.points)

    @property
    def statuses(self) -> dict[Status, int]:
        """How many points have which status."""
        return dict(Counter(point.status for point in self.points))

    @property
    def shares(self) -> dict[Label, int]:
        """How many points have which label, the most frequent first."""
        found = Counter(point.label for point in self.points if point.label is not None)
        return dict(sorted(found.items(), key=lambda item: (-item[1], str(item[0]))))

    @property
    def certificates(self) -> dict[str, int]:
        """How many of the computed points are certified, uncertain, failed."""
        return dict(Counter(point.certificate for point in self.points if point.certificate))

    def runs(self) -> list[tuple[int, int, Label | Status]]:
        """Maximal stretches of one label, in the order of the axis.

        Returns
        -------
        list of (int, int, Signature or MotionKind or Status)
            First index, last index, label; where there is no motion the status takes the place of the label.
        """
        found: list[tuple[int, int, Label | Status]] = []
        for i, point in enumerate(self.points):
            label = point.status if point.label is None else point.label
            if found and found[-1][2] == label:
                found[-1] = (found[-1][0], i, label)
            else:
                found.append((i, i, label))
        return found
