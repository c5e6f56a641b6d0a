"""Every value of a gear pair, stated and derived, with where it is from and which assumption it rests on."""

from __future__ import annotations

from collections.abc import Iterator

from gearlash.case.kinds.listed import displayed, limits
from gearlash.case.stated import Provenance
from gearlash.case.value import DERIVED, Value

from . import drawn, play
from .curves import STEMS, TABLE
from .derive import derived, disc_gears
from .keys import BODY, CONTACT
from .pair import GearPair
from .phases import REASON


def values(pair: GearPair) -> list[Value]:
    """Stated values, defaults that took effect, then derived numbers."""
    stated = [*_stated(pair), *_curves(pair), *_defaults(pair)]
    assumed = {v.path for v in stated if v.provenance == Provenance.ASSUMED}
    roots: dict[str, tuple[str, ...]] = {v.path: (v.path,) for v in stated if v.path in assumed}
    roots |= {e.key: (e.path,) for e in pair.entries.values() if e.path in assumed}
    found = list(stated)
    for d in derived(pair):
        rests_on = tuple(dict.fromkeys(root for name in d.inputs for root in roots.get(name, ())))
        roots[d.path] = rests_on
        found.append(Value(d.path, d.value, d.unit, DERIVED, d.formula, d.short, d.description, rests_on))
    return found


def _stated(pair: GearPair) -> Iterator[Value]:
    seen = set()
    for entry in pair.ranged.values():
        if entry.path in seen:
            continue  # one stated damping ratio of all bearings makes four entries
        seen.add(entry.path)
        place = pair.places.quantities.get(entry.path)
        if place is None:
            what, shown, unit, short = pair.places.choices[entry.path].description, entry.value, "", None
        else:
            what, shown, unit = place.description, displayed(entry.number, place), place.unit
            short = place.key if place.key in pair.places.two_way else None
        about = entry.path, shown, unit, entry.provenance, entry.reason, short, what, (), entry.text
        yield Value(*about, *limits(entry, place))


def _curves(pair: GearPair) -> Iterator[Value]:
    """What stands for each stated curve, and how far it is from it."""
    for name, curve in pair.reconstructed.items():
        stated = pair.curves[name]
        text = f"{name} over a {curve.over}"
        if len(curve.phases):
            part = 100.0 * curve.rms_error / curve.peak_to_peak if curve.peak_to_peak else 0.0
            text += f", of {len(curve.phases)} points; what is left: {part:.2g} % of peak to peak, rms"
        what = f"{curve.harmonics} harmonics"
        provenance = Provenance(stated["provenance"])
        yield Value(f"{TABLE}.{name}", what, "", provenance, stated["reason"], f"{STEMS[name]}_scale", text)
        if stated.get("unphased") and (len(pair.curves) > 1 or curve.harmonics > 1 or name == "error"):
            path, text = f"{TABLE}.{name}.phases", f"phases of the harmonics of {TABLE}.{name}"
            yield Value(path, 0.0, "rad", Provenance.ASSUMED, REASON, None, text)


def _defaults(pair: GearPair) -> Iterator[Value]:
    assumed = Provenance.ASSUMED
    for path, choice in pair.places.choices.items():
        if path in drawn.KEYS:
            continue
        takes_effect = path != BODY or disc_gears(pair)
        if path == play.HOUSING_MATERIAL:
            takes_effect = play.stated(pair.entries)
        if path not in pair.entries and takes_effect and (pair.scales.physical or path == CONTACT):
            yield Value(path, choice.default, "", assumed, "default", None, choice.description)
    in_curves = {STEMS[name] for name in pair.curves}
    for short, value in (("ripple", 0.0), ("error", 0.0), ("back_stiffness", 1.0), ("back_gap", 1.0)):
        if short not in pair.entries and short not in in_curves:
            place = pair.places.quantities[f"dimensionless.{short}"]
            yield Value(place.path, value, "", assumed, "default: not stated", short, place.description)
