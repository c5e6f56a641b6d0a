"""What is said of real teeth beside the lumped model."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.studies.verification import Compared, PointFound, Verification

KEPT, NONE, UNEVEN = "kept", "none", "uneven"
"""Instead of P-Q-R: of a motion that has not come back, always in contact or not; and of one that parts and
whose mean forces have come back, but not its impacts: not as many in every period."""


def in_words(label: str) -> str:
    """A label as sentences, tables and figures say it."""
    words = {
        KEPT: "in contact, not repeating within 1 %",
        NONE: "parts, not repeating within 1 %",
        UNEVEN: "parts, impacts not repeating",
    }
    return words.get(label, label)


def label_of(point: PointFound) -> str:
    """P-Q-R, or what a motion without such a label does."""
    reading = point.reading
    if reading.label is not None:
        return str(reading.label)
    if reading.apart == 0.0 and not reading.back_impacts:
        return KEPT
    return NONE if reading.period is None else UNEVEN


def sentence(found: Verification) -> str:
    """What of the case's motions real teeth confirm; then at each speed what they do in every way."""
    name = found.inputs.case
    ways = [one for one in found.compared if one.points]
    if not ways:
        return f"{name}: nothing was computed of the multibody model"
    if not found.stated:
        return f"{name}: motions of real teeth were found, and nothing beside them of the lumped model"
    told = []
    for i, stated in enumerate(found.stated):
        motions = [(one.configuration.name, _at(one, i)) for one in ways]
        real = ", ".join(
            f"{in_words(label_of(point))} ({way})" for way, point in motions if point is not None
        )
        speed = found.inputs.rpm(found.inputs.speeds[i], found.inputs.mean_stiffness)
        told.append(
            f"at {speed:.0f} rpm {stated.label} by the case, with real teeth {real or 'not computed'}"
        )
    return f"{name}: {_agreement(found, ways)}; {'; '.join(told)}"


def _at(one: Compared, index: int) -> PointFound | None:
    """The point at the index-th speed; None where it was not computed."""
    omega = one.configuration.omegas[index]
    return next((point for point in one.points if point.omega == omega), None)


def _agreement(found: Verification, ways: list[Compared]) -> str:
    """In which ways to hold the inputs real teeth do as the case says, at all speeds: one thing each."""
    from gearlash.studies.verification import seen_of_lumped, seen_of_teeth

    pairs = {
        one.configuration.name: [
            (seen_of_lumped(stated), None if (point := _at(one, i)) is None else seen_of_teeth(point))
            for i, stated in enumerate(found.stated)
        ]
        for one in ways
    }

    def where(what: str) -> str:
        """Where both say the same of it; what one of them does not know is not the same."""
        same = [
            name
            for name, both in pairs.items()
            if all(
                real is not None and getattr(real, what) not in (None, "")
                and getattr(real, what) == getattr(case, what)
                for case, real in both
            )
        ]  # fmt: skip
        count = len(pairs)
        if len(same) == count:
            return f"in all {count} ways to hold the inputs" if count > 1 else "with these inputs"
        if not same:
            return f"in none of {count} ways to hold the inputs" if count > 1 else "not with these inputs"
        return f"in {len(same)} of {count} ways to hold the inputs ({', '.join(same)})"

    return (
        f"whether real teeth part is as the case says {where('parts')}, whether their back sides touch "
        f"{where('back')}, the periodic label {where('label')}"
    )
