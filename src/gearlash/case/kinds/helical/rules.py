"""What a helical pair needs, what would be stated twice, and what follows from its bearings and its helix."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from math import sqrt

from gearlash.case.kinds.gears import supports
from gearlash.case.kinds.gears.keys import GEARS
from gearlash.case.kinds.gears.records import Body, Derived, Numbers
from gearlash.case.kinds.gears.rules import EntriesByKey, PairRules
from gearlash.case.scales import Scales
from gearlash.gears import HelicalPair, LineOfAction, YAxis, helical
from gearlash.system import ContactRule, Family

from .places import BEARINGS, FACTORS, MODULE, PLACES, Y_AXIS


class HelicalRules(PairRules):
    name = "helical-pair"
    places = PLACES
    module = MODULE
    angles = ("mesh.helix_angle",)
    bearings = BEARINGS
    fixed = (*FACTORS, *(f"bearing_frequency_{bearing}" for bearing in BEARINGS))

    def required(self, entries: EntriesByKey, physical: bool, known: Collection[str]) -> Iterator[str]:
        damped = any(f"bearing_damping_{b}" in known for b in BEARINGS)
        yield from (f"bearing_damping_{b}" for b in BEARINGS) if damped else ("bearing_damping",)
        yield from (f"bearing_frequency_{b}" for b in BEARINGS)
        if physical:
            yield from ("gear.teeth", "pinion.mass", "gear.mass")
            yield from (MODULE, "mesh.pressure_angle", "mesh.helix_angle")
        else:
            yield from ("rotation_factor", *FACTORS)

    def redundant(self, entries: EntriesByKey) -> Iterator[tuple[str, str]]:
        for key in FACTORS:
            if key in entries:
                yield key, "it follows from the angles and masses of this physical case"
        yield from supports.redundant(entries)

    def y_axis(self, entries: EntriesByKey) -> YAxis:
        return YAxis(self.places.chosen(entries, Y_AXIS))

    def pair(self, entries: EntriesByKey, body: Body, scales: Scales, contact: ContactRule) -> HelicalPair:
        kappa = [entries[f"bearing_frequency_{b}"] for b in BEARINGS]
        if body.line is None or scales.equivalent_mass is None or scales.omega_n is None:
            c_t2, c_y, c_z = (entries[key].number for key in ("rotation_factor", "y_factor", "z_factor"))
            ratios = entries["mass_ratio_p"].number, entries["mass_ratio_g"].number
            frequencies = [entry.number for entry in kappa]
        else:
            c_t2, c_y, c_z = body.line.c_t**2, body.line.c_y, body.line.c_z
            m_p, m_g = (supports.mass(entries, gear) for gear in GEARS)
            ratios = scales.equivalent_mass / m_p, scales.equivalent_mass / m_g
            sides = [
                (gear, mass, axis) for gear, mass in zip(GEARS, (m_p, m_g), strict=True) for axis in "yz"
            ]
            frequencies = [
                entry.number
                if entry.dimensionless
                else sqrt(supports.stiffness(entries, gear, axis) / mass) / scales.omega_n
                for entry, (gear, mass, axis) in zip(kappa, sides, strict=True)
            ]
        yp, zp, yg, zg = frequencies
        return HelicalPair(c_t2, c_y, c_z, ratios, (yp, zp, yg, zg), contact)

    def family(self, numbers: Numbers) -> Family:
        assert numbers.pair is not None  # `pair` made it
        return helical.family(numbers.pair, numbers.parameters, numbers.excitation)

    def natural_frequencies(self, numbers: Numbers, rotation_factor: float) -> Iterable[float]:
        assert numbers.pair is not None
        return helical.natural_frequencies(numbers.pair, rotation_factor)

    def frequency_inputs(self, entries: EntriesByKey) -> tuple[str, ...]:
        bearings = [key for key in entries if key.startswith(("bearing_frequency", "mass_ratio"))]
        return (
            "derived.c_y",
            "derived.c_z",
            "rotation_factor",
            "y_factor",
            "z_factor",
            *bearings,
            *supports.inputs(entries),
        )

    def support_stiffnesses(self, entries: EntriesByKey) -> Iterator[Derived]:
        return supports.derived(entries)

    def directions(self, line: LineOfAction, angles: tuple[str, ...]) -> Iterator[Derived]:
        yield Derived("derived.c_y", line.c_y, "", Y_AXIS, angles, "factor of lateral displacement")
        yield Derived("derived.c_z", line.c_z, "", "sin β_b", angles, "factor of axial displacement")

    def overlap(self, overlap: float, transverse: float, inputs: tuple[str, ...]) -> Iterator[Derived]:
        yield Derived("derived.overlap_ratio", overlap, "", "b sin β/(π m_n)", inputs, "ε_β")
        yield Derived("derived.total_contact_ratio", transverse + overlap, "", "ε_α + ε_β", inputs, "ε_γ")
