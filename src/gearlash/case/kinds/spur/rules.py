"""What a spur pair needs, what would be stated twice, and what follows from its bodies."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from gearlash.case.kinds.gears.keys import EQUIVALENT_MASS, GEARS, PROJECTION
from gearlash.case.kinds.gears.records import Body, Numbers
from gearlash.case.kinds.gears.rules import EntriesByKey, PairRules
from gearlash.case.scales import Scales
from gearlash.gears import Projection, YAxis, spur
from gearlash.system import ContactRule, Family

from .places import MODULE, PLACES, RADII


class SpurRules(PairRules):
    name = "spur-1dof"
    places = PLACES
    module = MODULE

    def required(self, entries: EntriesByKey, physical: bool, known: Collection[str]) -> Iterator[str]:
        """Inertias and radii, unless the equivalent mass is stated; a torque needs radii in any case."""
        if not physical:
            return
        lumped, base = EQUIVALENT_MASS in known, any(radius in known for radius in RADII)
        for gear in GEARS:
            # A solid disc has the pitch radius, which a base radius alone does not give.
            if not lumped and (base or f"{gear}.mass" not in known):
                yield f"{gear}.inertia"
        if lumped and ("load" not in entries or entries["load"].dimensionless):
            return
        yield from RADII if base else ("gear.teeth", MODULE, "mesh.pressure_angle")

    def redundant(self, entries: EntriesByKey) -> Iterator[tuple[str, str]]:
        for key in RADII:
            if key not in entries:
                continue
            if MODULE in entries:
                yield key, f"it follows from {MODULE}, teeth and mesh.pressure_angle"
            elif self.places.chosen(entries, PROJECTION) == Projection.PITCH:
                yield key, f"{PROJECTION} = pitch needs {MODULE} and mesh.pressure_angle instead"
        if EQUIVALENT_MASS in entries and all(f"{gear}.inertia" in entries for gear in GEARS):
            yield EQUIVALENT_MASS, "it follows from both inertias and radii"
        for gear in GEARS:
            if EQUIVALENT_MASS in entries and f"{gear}.added_inertia" in entries:
                yield f"{gear}.added_inertia", f"{EQUIVALENT_MASS} is that of all that turns"

    def y_axis(self, entries: EntriesByKey) -> YAxis:
        return YAxis.LINE_OF_ACTION

    def pair(self, entries: EntriesByKey, body: Body, scales: Scales, contact: ContactRule) -> None:
        return None

    def family(self, numbers: Numbers) -> Family:
        line = numbers.body.line
        turned = {} if line is None else {"rotation_factor": line.c_t**2}
        return spur.family({**turned, **numbers.parameters}, numbers.contact, numbers.excitation)

    def natural_frequencies(self, numbers: Numbers, rotation_factor: float) -> Iterable[float]:
        return spur.natural_frequencies(rotation_factor)

    def frequency_inputs(self, entries: EntriesByKey) -> tuple[str, ...]:
        return ("rotation_factor",)
