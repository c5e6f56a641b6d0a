"""What the orbits between two neighbours on a branch are: their label, and how unstable they are.

Next to a computed orbit that is known. Between two special points with no orbit in between it follows from
what each of them changes: a fold, doubling, torus or branch point the number of unstable multipliers, a
grazing the contacts."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

Label = TypeVar("Label")
GRAZING = "grazing"


@dataclass(frozen=True)
class Here(Generic[Label]):
    """A computed orbit: its label, and how many multipliers lie outside the unit circle."""

    label: Label
    unstable: int


@dataclass(frozen=True)
class Passing(Generic[Label]):
    """A special point, with label and number of unstable multipliers of the two orbits between which it was
    found; other special points may lie between the same two."""

    kind: str
    before: Here[Label]
    after: Here[Label]

    def passed(self, here: Here[Label]) -> Here[Label]:
        """What comes after it, where ``here`` comes before."""
        if self.kind == GRAZING:
            other = self.after.label if self.after.label != here.label else self.before.label
            return Here(other, here.unstable)
        change = self.after.unstable - self.before.unstable
        return Here(here.label, max(0, here.unstable + change))


def between(nodes: Sequence[Here[Label] | Passing[Label]]) -> list[Here[Label]]:
    """Of orbits and special points in the order of the branch, what lies between every two."""
    found: list[Here[Label]] = []
    for left, right in itertools.pairwise(nodes):
        if isinstance(left, Here):
            found.append(left)
        elif isinstance(right, Here):
            found.append(right)
        else:
            found.append(left.passed(found[-1] if found else left.before))
    return found
