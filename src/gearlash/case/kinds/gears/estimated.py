"""What a pair needs and its file does not state, estimated from what it states, with ranges."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from math import isfinite

from gearlash.case.entries import Entry
from gearlash.case.errors import Problem
from gearlash.case.stated import Provenance
from gearlash.gears import CylindricalPair
from gearlash.gears.backlash import Backlash
from gearlash.gears.cylindrical_pair import shift_sum
from gearlash.gears.drawing import COARSEST, GRADE_SPREAD, USUAL_GRADE, Drawing, Estimate
from gearlash.gears.estimates import estimates
from gearlash.gears.gear_body import GearBody, mean_tooth_diameter
from gearlash.gears.materials import OF_DATA_SHEETS, named, with_own
from gearlash.gears.mesh_stiffness import SOLID, Rim
from gearlash.system import GearlashError

from . import drawn, play, relief
from .converted import operation_in_other_words, teeth_in_other_words
from .curves import STEMS
from .keys import BODY, EQUIVALENT_MASS, GEARS, REFERENCE
from .loaded import is_loaded
from .meshing import ValueProblemError, impossible
from .rules import EntriesByKey, PairRules
from .shared import HIGHEST_HARMONIC
from .teeth import Teeth

HARMONIC_STEMS = "ripple", "error"


@dataclass(frozen=True)
class Completed:
    """Stated values and what was estimated beside them; the pair of teeth where it is known. ``problems`` are
    why nothing could be estimated, ``toothless`` the words without the teeth that they are about, ``refused``
    why an error could not be used; ``play_added`` is what the backlash has more at work than as stated, m."""

    entries: EntriesByKey
    drawing: Drawing | None = None
    problems: tuple[Problem, ...] = ()
    toothless: tuple[Problem, ...] = ()
    refused: tuple[Problem, ...] = ()
    play_added: float = 0.0

    @cached_property
    def follows_torque(self) -> bool:
        """Is anything estimated, or made by modified flanks, that depends on the torque?"""
        if self.drawing is not None and self.drawing.modification.modified:
            return True
        return any(
            e.estimated
            and (key == "mesh.mean_stiffness" or key.startswith(("ripple", "bearing_frequency")))
            and "phase" not in key
            for key, e in self.entries.items()
        )


def is_drawn(keys: Collection[str]) -> bool:
    """Does the case state what only a drawing says of teeth and bodies?"""
    return not drawn.GEOMETRY.isdisjoint(keys)


def is_estimable(path: str) -> bool:
    """Whether what stands at this path is estimated where a drawing is known."""
    return path in _ESTIMABLE


def estimated_beside(before: EntriesByKey, stated: EntriesByKey) -> set[str]:
    """Stems of harmonics that were estimated and of which some are stated now: `override` replaces these, and
    the others stay estimates."""
    estimated = {key for key, entry in before.items() if entry.estimated}
    return {
        stem
        for stem in HARMONIC_STEMS
        if any(_is_harmonic(key, stem) for key in estimated)
        and any(_is_harmonic(key, stem) for key in stated)
    }


def complete(
    rules: PairRules,
    entries: EntriesByKey,
    curves: Collection[str] = (),
    kept: Collection[str] = (),
) -> Completed:
    """The entries with everything that can be estimated and is not stated; ``curves`` are the names of those
    that are, ``kept`` stems of harmonics (`estimated_beside`).

    Estimates need teeth, module (helix angle) and both face widths, or any word of a drawing in place of
    these. A ripple or an error that is not stated is none unless there is such a word. Where a file states
    one harmonic, it has no others but those it states.
    """
    twice = drawn.contradicted(entries)
    entries = teeth_in_other_words(rules, entries)
    geometry = ("pinion.teeth", "gear.teeth", rules.module, *rules.angles)
    if twice:  # which is told where files are read: nothing follows from both
        return Completed(entries)
    if not all(key in entries for key in geometry):
        return Completed(entries, toothless=(*play.unusable(entries), *relief.unusable(entries)))
    widths = all(f"{gear}.face_width" in entries for gear in GEARS) and "mesh.pressure_angle" in entries
    has_drawing = is_drawn(entries)
    known = {**entries, **{e.key: e for e in operation_in_other_words(entries)}}
    moved = bool(play.stated(entries))
    estimable = has_drawing or widths
    wanted = _wanted(rules, known, has_drawing, curves, kept) if estimable else frozenset[str]()
    if not (has_drawing or wanted or moved):
        return Completed(known)
    teeth = Teeth(rules, known)
    try:
        pair = teeth.pair()
        if has_drawing:
            known |= {e.key: e for e in teeth.found}
            known |= {e.key: e for e in (*_play(known, pair), *_grades(known))}
            wanted = _wanted(rules, known, has_drawing, curves, kept)
        unfit = tuple(_unfit_bodies(known, pair))
        if unfit:
            return Completed(known, problems=unfit)
        worked = play.at_work(rules.places, known, pair)
        cannot = tuple(impossible(known, worked or pair)) if has_drawing else ()
        if cannot:
            return Completed(known, problems=cannot)
        flanks = relief.ReliefReader(rules.places, known, worked or pair)
        drawing = replace(_drawing(rules, known, pair), modification=flanks.read(), at_work=worked)
        load = known.get("load")
        if drawing.modification.modified and load is not None and load.dimensionless:
            expected = "a torque with its unit (operation.torque): what bears of modified flanks follows it"
            flanks.problems.append(Problem(load.path, repr(load.text), expected))
        if flanks.problems:
            return Completed(known, problems=tuple(flanks.problems))
        known |= {e.key: e for e in flanks.found}
        discs = _of_discs(known)
        found = (e for e in _entries(rules, _estimates(drawing, wanted)) if e.key not in known)
        known |= {e.key: e for e in found if not (discs and e.key.endswith(".inertia"))}
        more = play.added(rules.places, known, pair)
        jammed = tuple(play.jammed(known, more))
        if jammed:
            return Completed(known, problems=jammed, play_added=more)
    except ValueProblemError as error:
        return Completed(known, problems=(error.problem,))
    except GearlashError as error:
        return Completed(known, problems=(_unmeshed(known, error),))
    return Completed(known, drawing, tuple(_refused(known, entries, pair)), play_added=more)


def _play(entries: EntriesByKey, pair: CylindricalPair) -> Iterator[Entry]:
    """Backlash on the working circle as the normal one."""
    if drawn.PLAY in entries:
        gap = Backlash.from_circumferential(pair, entries[drawn.PLAY].number)
        how = "backlash on the working circle times cos α_wt cos β_b"
        yield Entry("D", "mesh.backlash", gap.normal, "", Provenance.INFERRED, how)


def _grades(entries: EntriesByKey) -> Iterator[Entry]:
    """Flank tolerance classes that nobody states: that of the mate, or a usual one. They have no range of
    their own, as that of the error and of K_v goes over it."""
    keys = [f"{gear}.quality" for gear in GEARS]
    for key, mate in zip(keys, reversed(keys), strict=True):
        if key in entries:
            continue
        grade = entries[mate].number if mate in entries else float(USUAL_GRADE)
        low, high = max(grade - GRADE_SPREAD, 1), min(grade + GRADE_SPREAD, COARSEST)
        origin = "as its mate" if mate in entries else "no class stated: a usual one"
        why = f"{origin}; classes {low:g} to {high:g} in the range of what follows from it"
        yield Entry(key, key, grade, "", Provenance.ASSUMED, why)


def _wanted(
    rules: PairRules,
    entries: EntriesByKey,
    has_drawing: bool,
    curves: Collection[str],
    kept: Collection[str],
) -> frozenset[str]:
    """Names of `gearlash.gears.estimates` that the model needs and nobody states."""
    found = set()
    for key, name in (
        ("mesh.mean_stiffness", "mean_stiffness"),
        ("D", "backlash"),
        ("mesh_damping", "mesh_damping"),
    ):
        if key not in entries:
            found.add(name)
    if has_drawing:
        named = {stem for stem in HARMONIC_STEMS if any(_is_harmonic(key, stem) for key in entries)}
        named = named - set(kept) | {STEMS[name] for name in curves}
        named |= {"error"} if is_loaded(entries) else set()
        found |= {"ripple", "error"} - named
    # an amplitude that is stated says nothing of its phase; files without a drawing keep what they mean
    amplitude = "error" in found or (has_drawing and "error" in entries)
    if amplitude and "error_phase" not in entries:
        found.add("error_phase")
    if not _bodies_known(rules, entries):
        found.add("bodies")
    if any(f"bearing_frequency_{b}" not in entries for b in rules.bearings):
        found.add("bearings")
    if any(f"bearing_damping_{b}" not in entries for b in rules.bearings):
        found.add("bearing_damping")
    if rules.bearings and has_drawing and any(f"{gear}.bearing_span" not in entries for gear in GEARS):
        found.add("bearing_span")
    return frozenset(found)


def _unmeshed(entries: EntriesByKey, error: GearlashError) -> Problem:
    """Teeth that do not mesh, at the centre distance where that is as of an internal gear."""
    if drawn.CENTRE not in entries:
        return Problem("mesh", None, f"teeth that mesh ({error})")
    first, second = (entries[f"{gear}.teeth"].number for gear in GEARS)
    entry, module = entries[drawn.CENTRE], entries.get("mesh.module") or entries["mesh.normal_module"]
    inner = 0.5 * abs(second - first) * module.number
    ring = abs(entry.number - inner) < 1.5 * module.number
    hint = "; a ring gear would have it, and there is no model of internal gears here" if ring else ""
    return Problem(entry.path, repr(entry.text), f"teeth that mesh ({error}{hint})")


def _bodies_known(rules: PairRules, entries: EntriesByKey) -> bool:
    """Does each gear have an inertia, and a mass where bearings need it?"""
    if EQUIVALENT_MASS in entries or "pinion.base_radius" in entries:
        return True
    inertia = ("inertia", "mass") if _of_discs(entries) else ("inertia",)
    needed = (("mass",), inertia) if rules.bearings else (inertia,)
    return all(any(f"{gear}.{leaf}" in entries for leaf in one) for gear in GEARS for one in needed)


def _is_harmonic(key: str, stem: str) -> bool:
    return key.startswith(stem) and "phase" not in key


def _drawing(rules: PairRules, entries: EntriesByKey, pair: CylindricalPair) -> Drawing:
    def stated(key: str) -> float | None:
        return entries[key].number if key in entries else None

    quality = [entries.get(f"{gear}.quality") for gear in GEARS]
    grades = [USUAL_GRADE if each is None else int(each.number) for each in quality]
    open_ = [each is None or not each.text for each in quality]
    fits = [str(entries[f"{g}.fit"].value) if f"{g}.fit" in entries else None for g in GEARS]
    chosen = [fits[0] or fits[1], fits[1] or fits[0]]
    materials = [
        with_own(
            named(rules.places.chosen(entries, f"{gear}.material")),
            *(stated(f"{gear}.{leaf}") for leaf in OF_DATA_SHEETS),
        )
        for gear in GEARS
    ]
    bodies, rims = zip(*(_body(entries, gear, i, pair) for i, gear in enumerate(GEARS)), strict=True)
    load = entries.get("load")
    return Drawing(
        pair,
        (materials[0], materials[1]),
        bodies,
        rims,
        (grades[0], grades[1]),
        None if chosen[0] is None or chosen[1] is None else (chosen[0], chosen[1]),
        _distance_grade(entries),
        None if load is None or load.dimensionless else load.number,
        assumed_grades=(open_[0], open_[1]),
        stated_stiffness=stated("mesh.mean_stiffness"),
        shafts=(stated("pinion.shaft_diameter"), stated("gear.shaft_diameter")),
        spans=(stated("pinion.bearing_span"), stated("gear.bearing_span")),
        stated_bending=("pinion.shaft_stiffness_y" in entries, "gear.shaft_stiffness_y" in entries),
    )


def _distance_grade(entries: EntriesByKey) -> int | None:
    """js of the centre distance: none where its deviation is stated, and no grade beside it."""
    grade = entries.get("mesh.distance_grade")
    return int(grade.number) if grade is not None else None if play.DEVIATION in entries else 7


def _unfit_bodies(entries: EntriesByKey, pair: CylindricalPair) -> Iterator[Problem]:
    """Bores and rims that leave nothing of a body below its teeth."""
    for gear, one in zip(GEARS, pair.gears, strict=True):
        limit, what = one.root_diameter, "its root diameter"
        for leaf in ("rim_diameter", "bore"):
            key = f"{gear}.{leaf}"
            if key not in entries:
                continue
            entry = entries[key]
            if not entry.number < limit:
                expected = f"a diameter below {what}, {limit * 1e3:.4g} mm"
                yield Problem(entry.path, repr(entry.text), expected)
            elif leaf == "rim_diameter":
                limit, what = entry.number, "that of its rim"


def _body(
    entries: EntriesByKey, gear: str, index: int, pair: CylindricalPair
) -> tuple[GearBody | None, Rim | None]:
    """Body and rim, as far as a drawing tells of them."""
    at = {
        leaf: entries[f"{gear}.{leaf}"].number
        for leaf in ("bore", "rim_diameter", "web_width")
        if f"{gear}.{leaf}" in entries
    }
    if not at:
        return None, None
    one, width = pair.gears[index], entries[f"{gear}.face_width"].number
    rim = at.get("rim_diameter")
    body = GearBody(mean_tooth_diameter(one), width, at.get("bore", 0.0), rim, at.get("web_width"))
    if rim is None:
        return body, SOLID
    return body, Rim(0.5 * (one.root_diameter - rim), at.get("web_width", width))


@lru_cache(maxsize=256)
def _estimates(drawing: Drawing, wanted: frozenset[str]) -> Mapping[str, Estimate]:
    return estimates(drawing, HIGHEST_HARMONIC, wanted)


_ESTIMABLE = frozenset(
    {
        "mesh.mean_stiffness",
        "mesh.damping_ratio",
        "mesh.backlash",
        "mesh.pressure_angle",
        "bearings.damping_ratio",
        REFERENCE,
        *(f"{gear}.{leaf}" for gear in GEARS for leaf in ("mass", "inertia", "face_width")),
        *(
            f"{gear}.bearing_{what}_{axis}"
            for gear in GEARS
            for what in ("stiffness", "damping")
            for axis in "yz"
        ),
    }
)
_PATHS = {
    "mean_stiffness": "mesh.mean_stiffness",
    "backlash": "mesh.backlash",
    "error": "mesh.error",
    "error_phase": "mesh.error_phase",
    "mesh_damping": "mesh.damping_ratio",
    "bearing_damping": "bearings.damping_ratio",
}


def _entries(rules: PairRules, found: Mapping[str, Estimate]) -> Iterator[Entry]:
    """Estimates as entries of this kind of pair."""
    for name, one in found.items():
        table, _, leaf = name.partition("_")
        path = _PATHS.get(name, f"{table}.{leaf}")
        if name.startswith("ripple_phase_"):
            path = "mesh.ripple_phase" if name == "ripple_phase_1" else f"mesh.{name}"
        elif name.startswith("ripple_"):
            path = "mesh.ripple" if leaf == "1" else f"mesh.{name}"
        elif leaf.startswith("bearing_") and leaf != "bearing_span":
            path = f"{table}.bearing_stiffness_{leaf[-1]}"
        place = rules.places.quantities.get(path)
        if place is None:
            continue  # a value that this kind of pair has no place for
        for key in rules.places.keys(place):
            ends = one.least, one.greatest
            if leaf == "bearing_span" or ("phase" in name and ends[0] == ends[1]):
                ends = None, None  # no value of this model follows from it, only an end of another range
            yield Entry(key, path, one.value, "", Provenance.ASSUMED, one.source, *ends)


def _of_discs(entries: EntriesByKey) -> bool:
    """Is the inertia of each gear that of a disc of its mass?

    A drawing tells of bodies, and their inertia is that of what it tells: a mass beside it leaves that as it
    is. Without a drawing, or where `model.body` is stated, inertia follows the mass, stated or estimated.
    """
    return BODY in entries or not is_drawn(entries)


def _refused(entries: EntriesByKey, stated: EntriesByKey, pair: CylindricalPair) -> Iterator[Problem]:
    """Estimates that no pair can have."""
    gap = entries.get("D")
    if gap is not None and gap.estimated and not (isfinite(gap.number) and gap.number > 0.0):
        words = [
            k
            for k in (
                drawn.CENTRE,
                *(f"{g}.{leaf}" for leaf in (*drawn.MEASURES, "profile_shift") for g in GEARS),
            )
            if k in stated
        ]
        path = words[0] if words else "mesh"
        shown = repr(stated[path].text) if path in stated else None
        more = ""
        if path == drawn.CENTRE:
            total, room = sum(one.profile_shift for one in pair.gears), shift_sum(pair)
            more = f", of which they need {1e3 * pair.tight_centre_distance:.6g} mm and more"
            if total > room:
                more += f"; or shifts that sum to {room:.4g} and less, where these have {total:.4g}"
        yield Problem(
            path,
            shown,
            f"teeth with play; these have {gap.number * 1e6:.4g} µm of backlash at this centre distance"
            f"{more}",
        )
