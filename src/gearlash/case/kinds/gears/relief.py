"""Relief and crowning of flanks as a drawing states them: what is taken off, and over which length."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from gearlash.case.entries import Entry
from gearlash.case.errors import Problem
from gearlash.case.quantity import Choice, Quantity
from gearlash.case.stated import Provenance
from gearlash.case.units import LENGTH
from gearlash.gears import CylindricalPair
from gearlash.gears.flank_modification import FlankModification, PairModification, Relief, ReliefForm

from .keys import GEARS
from .places import Places
from .rules import EntriesByKey

FORM = "mesh.relief_form"
ENDS = ("tip", "root")
AMOUNTS = ("tip_relief", "root_relief", "profile_crowning", "crowning")
SAME = tuple(
    (f"{gear}.{end}_relief_length", f"{gear}.{end}_relief_diameter") for gear in GEARS for end in ENDS
)
"""Two ways to say where a relief begins."""


def of_gear(gear: str) -> Iterator[Quantity]:
    """What the table [pinion] or [gear] may hold."""
    for end, symbol in (("tip", "C_αa"), ("root", "C_αf")):
        path = f"{gear}.{end}_relief"
        yield _amount(path, f"{end} relief {symbol} of the {gear}, in the transverse plane")
        what = f"roll length L_C of the {end} relief of the {gear}"
        yield Quantity(f"{path}_length", LENGTH, "mm", "2 mm", what, 0.0, 0.5, above=True)
        what = f"diameter d_C at which the {end} relief of the {gear} begins"
        yield Quantity(f"{path}_diameter", LENGTH, "mm", "80 mm", what, 0.0, 50, above=True)
    what = f"profile crowning C_α of the {gear}, at both ends of the path of contact"
    yield _amount(f"{gear}.profile_crowning", what)
    what = f"lead crowning C_β of the {gear}, at both ends of the face width"
    yield _amount(f"{gear}.crowning", what)


def _amount(path: str, what: str) -> Quantity:
    return Quantity(path, LENGTH, "um", "20 um", what, 0.0, 0.005)


def options() -> Iterator[Choice]:
    """Named options."""
    what = "how tip and root reliefs grow with the roll length"
    yield Choice(FORM, tuple(ReliefForm), ReliefForm.LINEAR, what)


KEYS = frozenset(place.path for gear in GEARS for place in of_gear(gear))


def unusable(entries: EntriesByKey) -> tuple[Problem, ...]:
    """A relief where no teeth are known that it could be on."""
    expected = "teeth, module and helix angle beside it, which tell where contact begins and ends"
    keys = sorted(KEYS & entries.keys())
    return tuple(Problem(entries[key].path, repr(entries[key].text), expected) for key in keys[:1])


@dataclass
class ReliefReader:
    """The modification that stated values make of a pair; what had to be assumed; what cannot be."""

    places: Places
    entries: EntriesByKey
    pair: CylindricalPair
    found: list[Entry] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)

    def read(self) -> PairModification:
        """Both gears."""
        form = ReliefForm(self.places.chosen(self.entries, FORM))
        first, second = (self._gear(index) for index in range(2))
        return PairModification(first, second, form)

    def _gear(self, index: int) -> FlankModification:
        gear = GEARS[index]
        tip, root = (self._relief(index, end) for end in ENDS)
        profile, lead = (self._number(f"{gear}.{leaf}") or 0.0 for leaf in AMOUNTS[2:])
        return FlankModification(tip, root, profile, lead)

    def _number(self, key: str) -> float | None:
        return self.entries[key].number if key in self.entries else None

    def _relief(self, index: int, end: str) -> Relief | None:
        path = f"{GEARS[index]}.{end}_relief"
        amount = self._number(path)
        if amount is None:
            for leaf in ("length", "diameter"):
                entry = self.entries.get(f"{path}_{leaf}")
                if entry is not None:
                    self.problems.append(
                        Problem(path, None, f"the amount that belongs to {entry.path}", missing=True)
                    )
            return None
        if amount == 0.0:
            return None
        return Relief(amount, self._length(index, end))

    def _length(self, index: int, end: str) -> float:
        """Roll length of a relief: stated, from its diameter, or a usual one."""
        path = f"{GEARS[index]}.{end}_relief"
        lowest, tip = self._active(index)
        stated, diameter = (self.entries.get(f"{path}_{leaf}") for leaf in ("length", "diameter"))
        if diameter is not None:
            return self._from_diameter(diameter, index, end)
        if stated is not None:
            if stated.number > tip - lowest:
                expected = f"a length within the {1e3 * (tip - lowest):.4g} mm of roll that touch"
                self.problems.append(Problem(stated.path, repr(stated.text), expected))
            return stated.number
        ratio, pitch = self.pair.transverse_contact_ratio, self.pair.pinion.transverse_base_pitch
        double = max(ratio - 1.0, 0.1) * pitch
        short, long = 0.5 * double, double
        why = "not stated: half of (ε_α − 1) p_bt, a short relief; up to a long one in the range"
        key = f"{path}_length"
        self.found.append(Entry(key, key, short, "", Provenance.ASSUMED, why, short, long))
        return short

    def _from_diameter(self, diameter: Entry, index: int, end: str) -> float:
        one = self.pair.gears[index]
        lowest, tip = self._active(index)
        least, most = (2.0 * (roll**2 + 0.25 * one.base_diameter**2) ** 0.5 for roll in (lowest, tip))
        if not least < diameter.number < most:
            expected = f"a diameter between those that touch, {1e3 * least:.5g} and {1e3 * most:.5g} mm"
            self.problems.append(Problem(diameter.path, repr(diameter.text), expected))
            return tip - lowest
        roll = one.roll_length(diameter.number)
        return tip - roll if end == "tip" else roll - lowest

    def _active(self, index: int) -> tuple[float, float]:
        """Roll lengths between which the flank of a gear touches, up to its tip."""
        one = self.pair.gears[index]
        start, end = self.pair.path_of_contact
        lowest = start if index == 0 else self.pair.tangent_length - end
        return lowest, max(one.roll_length(one.tip_form_diameter), lowest + 1e-9)
