"""What one kind of gear pair says of itself, and no other part of this folder knows."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Collection, Iterable, Iterator, Mapping

from gearlash.case.entries import Entry
from gearlash.case.scales import Scales
from gearlash.gears import HelicalPair, LineOfAction, YAxis
from gearlash.system import ContactRule, Family

from .places import Places
from .records import Body, Derived, Numbers

EntriesByKey = Mapping[str, Entry]


class PairRules(ABC):
    """A kind of gear pair: its name, its places, the path of its module, and which of the keys with two ways
    are ``fixed`` numbers of the pair instead of parameters; the ``angles`` beside the pressure angle that its
    teeth need, and the directions of its ``bearings``."""

    name: str
    places: Places
    module: str
    fixed: Collection[str] = ()
    angles: tuple[str, ...] = ()
    bearings: tuple[str, ...] = ()

    @abstractmethod
    def required(self, entries: EntriesByKey, physical: bool, known: Collection[str]) -> Iterator[str]:
        """Keys that must be stated, beside those of every pair; ``known`` are keys that are, if wrongly."""

    @abstractmethod
    def redundant(self, entries: EntriesByKey) -> Iterator[tuple[str, str]]:
        """Keys stated although other values of this physical case determine them, each with the reason."""

    @abstractmethod
    def y_axis(self, entries: EntriesByKey) -> YAxis:
        """Direction of the lateral coordinate."""

    @abstractmethod
    def pair(
        self, entries: EntriesByKey, body: Body, scales: Scales, contact: ContactRule
    ) -> HelicalPair | None:
        """The fixed numbers of a pair with bearings; None where there are none."""

    @abstractmethod
    def family(self, numbers: Numbers) -> Family:
        """The family of systems."""

    @abstractmethod
    def natural_frequencies(self, numbers: Numbers, rotation_factor: float) -> Iterable[float]:
        """Undamped, over ω_n, the mesh closed at its mean stiffness."""

    @abstractmethod
    def frequency_inputs(self, entries: EntriesByKey) -> tuple[str, ...]:
        """What these were computed from, beside masses and mean stiffness."""

    def support_stiffnesses(self, entries: EntriesByKey) -> Iterator[Derived]:
        """Stiffnesses of bearings in series with other parts."""
        return iter(())

    def directions(self, line: LineOfAction, angles: tuple[str, ...]) -> Iterator[Derived]:
        """How motion of the bearings enters the mesh, which follows from the angles."""
        return iter(())

    def overlap(self, overlap: float, transverse: float, inputs: tuple[str, ...]) -> Iterator[Derived]:
        """Contact ratios that the face width decides: ε_β, and with the transverse one the total."""
        return iter(())
