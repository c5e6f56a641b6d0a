"""What a drawing states in other words: of the gear, as power, in the transverse section, in inches."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan, cos, pi, tan

from gearlash.case.entries import Entry
from gearlash.case.stated import Provenance

from . import drawn
from .keys import GEARS
from .rules import EntriesByKey, PairRules

INCH = 0.0254


def teeth_in_other_words(rules: PairRules, entries: EntriesByKey) -> EntriesByKey:
    """The entries with module, pressure angle and profile shifts of the normal section, where they are stated
    in the transverse one or as a diametral pitch."""
    return {**entries, **{e.key: e for e in _teeth(rules, entries) if e.key not in entries}}


def _teeth(rules: PairRules, entries: EntriesByKey) -> Iterator[Entry]:
    if any(angle not in entries for angle in rules.angles):
        return
    helix = entries["mesh.helix_angle"].number if "mesh.helix_angle" in entries else 0.0
    along = cos(helix)
    inferred = Provenance.INFERRED
    for key, inches, factor, how in (
        (drawn.TRANSVERSE_MODULE, False, along, "m_t cos β"),
        (drawn.PITCH, True, 1.0, "25.4 mm over the diametral pitch"),
        (drawn.TRANSVERSE_PITCH, True, along, "25.4 mm over the transverse diametral pitch, times cos β"),
    ):
        if key in entries:
            value = entries[key].number
            module = factor * (INCH / value if inches else value)
            yield Entry(rules.module, rules.module, module, "", inferred, how)
    if drawn.TRANSVERSE_ANGLE in entries:
        angle = atan(tan(entries[drawn.TRANSVERSE_ANGLE].number) * along)
        path = "mesh.pressure_angle"
        yield Entry(path, path, angle, "", inferred, "tan α_n = tan α_t cos β")
    for gear in GEARS:
        key, path = f"{gear}.transverse_profile_shift", f"{gear}.profile_shift"
        if key in entries:
            yield Entry(path, path, entries[key].number / along, "", inferred, "x_t m_t over m_n")


def operation_in_other_words(entries: EntriesByKey) -> Iterator[Entry]:
    """Speed and torque of the gear, and power, as those of the pinion."""
    ratio = entries["gear.teeth"].number / entries["pinion.teeth"].number
    speed = entries.get("omega")
    if drawn.GEAR_SPEED in entries:
        value = entries[drawn.GEAR_SPEED].number * ratio
        speed = Entry(
            "omega", "operation.pinion_speed", value, "", Provenance.INFERRED, "speed of the gear times u"
        )
        yield speed
    path, inferred = "operation.torque", Provenance.INFERRED
    for own, of_gear in zip(drawn.SPEED_RANGE, drawn.GEAR_RANGE, strict=True):
        if of_gear in entries:
            yield Entry(own, own, entries[of_gear].number * ratio, "", inferred, "speed of the gear times u")
    if drawn.GEAR_TORQUE in entries:
        value = entries[drawn.GEAR_TORQUE].number / ratio
        yield Entry("load", path, value, "", inferred, "torque of the gear over u, without losses")
    if drawn.POWERED in entries and speed is not None and not speed.dimensionless:
        turning = speed.number
        if speed.path == "operation.mesh_frequency":
            turning = 2.0 * pi * speed.number / entries["pinion.teeth"].number
        yield Entry(
            "load", path, entries[drawn.POWERED].number / turning, "", inferred, "power over the stated speed"
        )
