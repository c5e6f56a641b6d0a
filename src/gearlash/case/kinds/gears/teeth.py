"""From what is stated of a pair to its teeth: profile shifts, however they are stated, tips and roots."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import atan, cos, degrees, floor, inf, log, pi, radians, tan

from gearlash.case.entries import Entry
from gearlash.case.errors import Problem
from gearlash.case.stated import Provenance
from gearlash.gears import BasicRack, CylindricalGear, CylindricalPair, inspection
from gearlash.gears.cylindrical_pair import shift_sum, tip_shortening
from gearlash.system import GearlashError

from .drawn import CENTRE, RACK, RACKS, SHIFT_SUM, SHORTENED, TIPS
from .keys import GEARS
from .meshing import ValueProblemError
from .rules import EntriesByKey, PairRules

PRESSURE_ANGLE = radians(20.0)
MOST_SHIFT = 3.0
"""|x| beyond which a measure is that of another gear."""
USUAL_WIDTH = 10.0
"""Face width over the module where none is stated."""
ROUNDED = 1e-6
"""m: a measured tooth thickness that is nearer than that to the nominal one is the nominal one, rounded."""
FULL = 2e-3
"""Of the full root radius: one that is larger by less is the full one, rounded."""
NO_SHIFT = 1e-3
"""Sum of the profile shifts below which a stated centre distance is that of teeth without shift, rounded."""


class Teeth:
    """The teeth of a pair as stated values give them, and what of them had to be inferred or assumed."""

    def __init__(self, rules: PairRules, entries: EntriesByKey):
        self.rules, self.entries = rules, entries
        self.found: list[Entry] = []
        self.allowances: dict[str, float] = {}

    def number(self, key: str) -> float | None:
        """A stated value, None where there is none."""
        entry = self.entries.get(key)
        return None if entry is None else entry.number

    def pair(self) -> CylindricalPair:
        """The pair. Raises `GearlashError` for teeth that do not mesh."""
        gears = [self._gear(gear) for gear in GEARS]
        centre = self.number(CENTRE)
        pair = CylindricalPair(gears[0], gears[1], centre, self._face_width())
        shifts = self._shifts(pair)
        gears = [
            self._finished(name, replace(gear, profile_shift=x))
            for name, gear, x in zip(GEARS, gears, shifts, strict=True)
        ]
        found = replace(pair, pinion=gears[0], gear=gears[1])
        if self.rules.places.chosen(self.entries, TIPS) != SHORTENED:
            return found
        taken = 2.0 * min(tip_shortening(found), 0.0)
        gears = [
            gear
            if gear.stated_tip_diameter is not None
            else replace(gear, stated_tip_diameter=gear.tip_diameter + taken)
            for gear in found.gears
        ]
        return replace(found, pinion=gears[0], gear=gears[1])

    def _gear(self, gear: str) -> CylindricalGear:
        """Without tip, root and allowance."""
        teeth = int(self.entries[f"{gear}.teeth"].number)
        plain = CylindricalGear(
            teeth,
            self.entries[self.rules.module].number,
            self.number("mesh.helix_angle") or 0.0,
            rack=self._rack(gear),
        )
        x = self.number(f"{gear}.profile_shift")
        return plain if x is None else replace(plain, profile_shift=x)

    def _rack(self, gear: str) -> BasicRack:
        angle = self.number("mesh.pressure_angle")
        if angle is None:
            angle = PRESSURE_ANGLE
            self._assume("mesh.pressure_angle", angle, "not stated: 20° of ISO 53")
        rack = replace(RACKS[self.rules.places.chosen(self.entries, RACK)], pressure_angle=angle)
        for leaf in ("addendum", "dedendum", "root_radius"):
            stated = self.number(f"{gear}.{leaf}")
            rack = rack if stated is None else replace(rack, **{leaf: stated})
        room = _room(rack.dedendum, angle)
        if room < 0.0:
            most = degrees(atan(pi / 4 / rack.dedendum))
            paths = ("mesh.pressure_angle", "mesh.transverse_pressure_angle", f"{gear}.dedendum")
            entry = next(e for p in paths if (e := self.entries.get(p)) is not None and e.text)
            expected = (
                f"up to {int(10 * most) / 10:g} deg: with more, this rack ends in a point before its tip"
                if entry.path != paths[-1]
                else f"up to {pi / 4 / tan(angle):.3g}: with more, this rack ends in a point before its tip"
            )
            raise ValueProblemError(Problem(entry.path, repr(entry.text), expected))
        if self.number(f"{gear}.root_diameter") is None:  # which tells how deep the rack cuts
            self._rounding_fits(gear, room)
        return replace(rack, root_radius=min(rack.root_radius, room))

    def _rounding_fits(self, gear: str, room: float) -> None:
        """Raises `ValueProblemError` for a stated root radius that the tip of the rack has no room for."""
        entry = self.entries.get(f"{gear}.root_radius")
        if entry is None or entry.number <= room * (1.0 + FULL):
            return
        largest = floor(1e4 * room) / 1e4
        expected = f"up to {largest:g}, the full radius of a rack as deep and as steep as this one"
        raise ValueProblemError(Problem(entry.path, repr(entry.text), expected))

    def _face_width(self) -> float:
        stated = [w for gear in GEARS if (w := self.number(f"{gear}.face_width")) is not None]
        width = min(stated, default=USUAL_WIDTH * self.entries[self.rules.module].number)
        for gear in GEARS:
            if f"{gear}.face_width" not in self.entries:
                why = "as its mate" if stated else f"not stated: {USUAL_WIDTH:g} m_n"
                self._assume(
                    f"{gear}.face_width", width, why, *(() if stated else (0.6 * width, 1.6 * width))
                )
        return width

    def _shifts(self, pair: CylindricalPair) -> tuple[float, float]:
        """Both profile shifts: stated, measured, from their sum or the centre distance, or none."""
        known = [self._shift(name, gear) for name, gear in zip(GEARS, pair.gears, strict=True)]
        total = self.number(SHIFT_SUM)
        if self.number(CENTRE) is not None:
            total = shift_sum(pair)
        first, second = known
        if first is not None and second is not None:
            return first, second
        if total is None:
            why = "no profile shift, span, dimension over balls or centre distance stated"
            first, second = (
                self._shifted(g, 0.0, why) if x is None else x for g, x in zip(GEARS, known, strict=True)
            )
            return first, second
        rest = f"what x_1 + x_2 = {total:.4g} leaves"
        if first is None and second is None and abs(total) < NO_SHIFT:
            why = "x_1 + x_2 = 0: no profile shift stated"
            first, second = (self._shifted(gear, 0.5 * total, why) for gear in GEARS)
            return first, second
        if first is None and second is None:
            first = _pinion_share(total, pair)
            why = f"pinion's share of x_1 + x_2 = {total:.4g}, BS 436"
            self._shifted(GEARS[0], first, why)
        if first is None:
            assert second is not None
            return self._inferred_shift(GEARS[0], total - second, rest), second
        return first, self._inferred_shift(GEARS[1], total - first, rest)

    def _shift(self, name: str, gear: CylindricalGear) -> float | None:
        """Of one gear, as stated or measured. A measure beside a stated shift tells the allowance."""
        measured = self._measured(name, gear)
        path = f"{name}.profile_shift"
        stated = self.number(path)
        if measured is None:
            return stated
        generating, how = measured
        unit = 2.0 * gear.normal_module * tan(gear.rack.pressure_angle)
        if stated is not None:
            allowance = f"{name}.thickness_allowance"
            self.allowances[name] = unit * (generating - stated)
            if abs(self.allowances[name]) < ROUNDED:
                self.allowances[name], how = 0.0, f"{how}, which is that of the stated shift"
            self.found.append(
                Entry(allowance, allowance, self.allowances[name], "", Provenance.INFERRED, how)
            )
            return stated
        x = generating - (self.number(f"{name}.thickness_allowance") or 0.0) / unit
        return self._inferred_shift(name, x, how)

    def _measured(self, name: str, gear: CylindricalGear) -> tuple[float, str] | None:
        """The generating profile shift that a measure gives, and how."""
        span, teeth = self.number(f"{name}.span"), self.number(f"{name}.span_teeth")
        if span is not None:
            k = inspection.span_teeth(gear) if teeth is None else int(teeth)
            nominal = f"{1e3 * inspection.span_measurement(gear.nominal(), k):.5g} mm over {k} teeth"
            x = self._measurable(f"{name}.span", nominal, lambda: inspection.with_span(gear, span, k))
            return x, f"from W_{k}"
        thickness = self.number(f"{name}.tooth_thickness")
        if thickness is not None:
            tangent, module = tan(gear.rack.pressure_angle), gear.normal_module
            return (thickness / module - 0.5 * pi) / (2.0 * tangent), "from the tooth thickness s_n"
        ball = self.number(f"{name}.ball_diameter")
        for leaf, pins in (("over_balls", False), ("over_pins", True)):
            dimension = self.number(f"{name}.{leaf}")
            if dimension is not None:
                ball = 1.75 * gear.normal_module if ball is None else ball
                how = f"from the dimension over {'pins' if pins else 'balls'} of {ball * 1e3:.5g} mm"
                measure = inspection.dimension_over_pins if pins else inspection.dimension_over_balls
                nominal = f"{1e3 * measure(gear.nominal(), ball):.5g} mm"
                x = self._measurable(
                    f"{name}.{leaf}",
                    nominal,
                    lambda d=dimension, b=ball, p=pins: inspection.with_dimension_over_balls(gear, d, b, p),
                )
                return x, how
        return None

    def _measurable(self, path: str, nominal: str, gear: Callable[[], CylindricalGear]) -> float:
        """The generating profile shift of a measure. Raises `ValueProblemError` for one of no such gear."""
        try:
            x = gear().profile_shift
        except GearlashError:
            x = inf
        if abs(x) > MOST_SHIFT:
            stated = self.number(f"{path.partition('.')[0]}.profile_shift")
            shift = f"with the stated profile shift {stated:.4g}" if stated else "without profile shift"
            expected = f"a measure of such teeth: {nominal} {shift}"
            raise ValueProblemError(Problem(path, repr(self.entries[path].text), expected))
        return x

    def _shifted(self, gear: str, x: float, why: str) -> float:
        self._assume(f"{gear}.profile_shift", x, why)
        return x

    def _inferred_shift(self, gear: str, x: float, how: str) -> float:
        path = f"{gear}.profile_shift"
        self.found.append(Entry(path, path, x, "", Provenance.INFERRED, how))
        return x

    def _assume(
        self, path: str, value: float, why: str, least: float | None = None, most: float | None = None
    ) -> None:
        self.found.append(Entry(path, path, value, "", Provenance.ASSUMED, why, least, most))

    def _finished(self, name: str, gear: CylindricalGear) -> CylindricalGear:
        """With the stated tip, root and allowance."""
        allowance = self.number(f"{name}.thickness_allowance") or self.allowances.get(name, 0.0)
        tip, root = self.number(f"{name}.tip_diameter"), self.number(f"{name}.root_diameter")
        gear = replace(gear, thickness_allowance=allowance)
        if root is not None:
            self._root_fits(name, gear, root)
            gear = replace(gear, rack=self._with_root(name, gear, root))
        path, alteration = f"{name}.tip_diameter", self.number(f"{name}.tip_alteration")
        if alteration is not None:
            path, tip = f"{name}.tip_alteration", gear.tip_diameter + 2.0 * alteration
        if tip is not None:
            least = max(gear.base_diameter, gear.root_diameter)
            if not tip > least:
                usual = f"{1e3 * gear.tip_diameter:.5g} mm is usual"
                expected = (
                    f"a tip diameter of more than {1e3 * least:.5g} mm, that of base or root circle; {usual}"
                )
                raise ValueProblemError(Problem(path, repr(self.entries[path].text), expected))
        return replace(gear, stated_tip_diameter=tip)

    def _with_root(self, name: str, gear: CylindricalGear, root: float) -> BasicRack:
        """The rack whose tip cuts this root diameter; its rounding as stated, else as far as it has room."""
        rack, module, stated = gear.rack, gear.normal_module, self.number(f"{name}.root_radius")
        dedendum = gear.generating_profile_shift + (gear.reference_diameter - root) / (2.0 * module)
        room = _room(dedendum, rack.pressure_angle)
        self._rounding_fits(name, max(room, 0.0))
        radius = rack.root_radius if stated is None else stated
        return replace(rack, dedendum=dedendum, root_radius=max(0.0, min(radius, room)))

    def _root_fits(self, name: str, gear: CylindricalGear, root: float) -> None:
        """Raises `ValueProblemError` for a root that no rack cuts into these teeth."""
        angle, module = gear.rack.pressure_angle, gear.normal_module
        deepest = gear.reference_diameter - 2.0 * module * (
            pi / 4 / tan(angle) - gear.generating_profile_shift
        )
        if not deepest < root < gear.tip_diameter:
            path = f"{name}.root_diameter"
            expected = (
                f"between {1e3 * deepest:.5g} and {1e3 * gear.tip_diameter:.5g} mm, "
                f"{1e3 * gear.root_diameter:.5g} mm is usual"
            )
            raise ValueProblemError(Problem(path, repr(self.entries[path].text), expected))


def _pinion_share(total: float, pair: CylindricalPair) -> float:
    """x_1 of a sum: x_1 = Σx/2 + (1/2 − Σx/2) ln u / ln(z_n1 z_n2/100), BS 436."""
    product = pair.pinion.virtual_teeth * pair.gear.virtual_teeth / 100.0
    if product <= 1.5 or pair.ratio <= 0.0:
        return 0.5 * total
    return 0.5 * total + (0.5 - 0.5 * total) * log(pair.ratio) / log(product)


def _room(dedendum: float, angle: float) -> float:
    """The largest rounding that the tip of a rack has room for, over m_n; below 0 it is a point before."""
    return (pi / 4 - dedendum * tan(angle)) / (1.0 / cos(angle) - tan(angle))
