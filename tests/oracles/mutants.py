"""Mutants of the flow: copies of the package with one text of the kernels replaced, and what should notice.

Each breaks a bound, a remainder, a direction or a switch. Texts are looked for in all files of the flow, with
any white space between their words, so that neither moving a function nor wrapping a line loses them.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import gearlash

PACKAGE = Path(gearlash.__file__).parent
TESTS = Path(__file__).parents[1]
PATIENCE = 60  # seconds, of up to four facts; a mutant may well run for ever


@dataclass(frozen=True)
class Mutant:
    """One text replaced by another, and the fact of `flow_facts` that it must not survive."""

    name: str
    old: str
    new: str
    fact: str


@dataclass(frozen=True)
class Verdict:
    """Whether the fact was asked for at all, whether it held, and what was printed."""

    asked: bool
    held: bool
    told: str


def pattern(text: str) -> re.Pattern[str]:
    """The text with any white space between its words and signs."""
    return re.compile(r"\s*".join(re.escape(word) for word in re.findall(r"\w+|[^\w\s]", text)))


def places(text: str, package: Path = PACKAGE) -> list[Path]:
    """The files of the flow in which a text occurs, once for each time."""
    found = pattern(text)
    return [
        path
        for path in sorted((package / "flow").rglob("*.py"))
        for _ in found.findall(path.read_text(encoding="utf-8"))
    ]


def copied(folder: Path, mutant: Mutant | None) -> Path:
    """A copy of the package in a folder of its own, mutated; returns that folder."""
    package = folder / "gearlash"
    shutil.copytree(PACKAGE, package, ignore=shutil.ignore_patterns("__pycache__"))
    if mutant is not None:
        (path,) = places(mutant.old, package)
        source = path.read_text(encoding="utf-8")
        path.write_text(pattern(mutant.old).sub(lambda _: mutant.new, source), encoding="utf-8")
    return folder


def ask(source: Path, *facts: str) -> Verdict:
    """Runs facts on a copy of the package, kernels as plain Python, in a process of their own."""
    environment = {
        **os.environ,
        "NUMBA_DISABLE_JIT": "1",
        "PYTHONPATH": os.pathsep.join([str(source), str(TESTS)]),
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    command = [sys.executable, "-m", "oracles.flow_facts", *facts]
    patience = PATIENCE * max(1, len(facts) // 4)
    try:
        done = subprocess.run(
            command, env=environment, capture_output=True, text=True, timeout=patience, check=False
        )
    except subprocess.TimeoutExpired as late:
        told = late.stdout.decode() if isinstance(late.stdout, bytes) else late.stdout or ""
        return Verdict("asked" in told, held=False, told=f"{told}no end within {patience} s")
    return Verdict("asked" in done.stdout, done.returncode == 0, done.stdout + done.stderr)


_CELL_END, _TANGENT = "crossing_at_the_end_of_a_cell", "tangent_over_a_crossing"
_TOUCH, _ROUNDING = "touch_beyond_or_short", "touch_within_rounding"
_BEFORE, _PEAK = "touch_within_rounding_before_a_crossing", "transient_peak"
_PARTS, _COARSE, _START, _RETURN = (
    "closed_orbit_that_parts",
    "grid_that_is_too_coarse",
    "start_on_a_boundary",
    "there_and_back_in_a_cell",
)
_EIGHT, _BEHIND = "eight_as_alone", "behind_what_another_crosses"
_NO_WIDTH, _NO_TENSION, _TWO = "no_width_at_all", "release_where_nothing_presses", "two_side_by_side"

_CHOICE = "best, which, through, behind = at, c, boundary, target"  # of the first crossing of all
_CHOSEN = "best, which, through, behind = (at, c, boundary, target) if {} else (best, which, through, behind)"

BOUNDS = (
    Mutant(
        "no rest at all",
        "memory[at + shape.rest + row] = tail + TABLE_ROUNDING * size",
        "memory[at + shape.rest + row] = 0.0",
        _ROUNDING,
    ),
    Mutant(
        "rough coefficients exact",
        "tail + TABLE_ROUNDING * size + spared",
        "tail + TABLE_ROUNDING * size",
        _CELL_END,
    ),
    Mutant("unit rounding zero", "UNIT_ROUNDING = 2.0**-53", "UNIT_ROUNDING = 0.0", _ROUNDING),
    Mutant(
        "place of a boundary exact",
        "near = bound + PLACE_ROUNDING * memory[shape.reach + c]",
        "near = 0.0",
        _ROUNDING,
    ),
    Mutant(
        "bounds a thousandfold",
        "near = bound + PLACE_ROUNDING * memory[shape.reach + c]",
        "near = 1e-10",
        _TOUCH,
    ),
    Mutant(
        "no bound in a first exit",
        "start, end, near, DERIVATIVE_BOUND * near, on == boundary",
        "start, end, 0.0, 0.0, on == boundary",
        _ROUNDING,
    ),
    Mutant("above its bound: face value", "work[b + i] > bound:", "work[b + i] > 0.0:", _ROUNDING),
    Mutant(
        "undecided not counted in a piece",
        "counts[4 * shape.clearances] += 1",
        "counts[4 * shape.clearances] += 0",
        _ROUNDING,
    ),
    Mutant(
        "undecided not counted at a crossing", "counts[4 * count] += 1", "counts[4 * count] += 0", _BEFORE
    ),
    Mutant(
        "no majorant",
        "terms, new, source = np.zeros(n), np.zeros(n), np.zeros(LAST_TERM + 1)",
        "if n > 0:\n        return 0.0, 0.0\n    terms, new, source = last, last, last",
        _COARSE,
    ),
    Mutant(
        "undecided of one clearance only",
        f"undecided = undecided or open_case if at < best: {_CHOICE}",
        f"undecided = open_case; {_CHOSEN.format('at < best')}",
        _BEFORE,
    ),
)
DIRECTIONS = (
    Mutant("start goes no way", "elif speed < -slope_bound:", "elif False:", _NO_WIDTH),
    Mutant(
        "start leaves where it should stay", "elif speed < -slope_bound:", "elif speed > slope_bound:", _START
    ),
    Mutant("first mode without direction", "moving > bound * memory[shape.scalars]", "False", _START),
    Mutant("first mode the other way", "moving > bound * memory[shape.scalars]", "moving < 0.0", _START),
    Mutant(
        "surface the other way round",
        "return float(-boundary if mode == FREE else boundary)",
        "return float(boundary if mode == FREE else -boundary)",
        _TOUCH,
    ),
    Mutant(
        "crossed boundary forgotten",
        "DERIVATIVE_BOUND * near, on == boundary",
        "DERIVATIVE_BOUND * near, False",
        "crossing_at_a_crawl",
    ),
    Mutant(
        "any crossing blocks",
        "DERIVATIVE_BOUND * near, on == boundary",
        "DERIVATIVE_BOUND * near, on != 0",
        _NO_WIDTH,
    ),
    Mutant(
        "other boundary blocked",
        "motion.on[which] = boundary events += 1",
        "motion.on[which] = -boundary; events += 1",
        "crossing_at_a_crawl",
    ),
)
PROOFS = (
    Mutant("every lap clear", "if not (away < below and away < above):", "if False:", _PEAK),
    Mutant(
        "no swing",
        "swing[c * p + k] = max(swing[c * p + k], peak(out, p + TERMS * c, TERMS) + rest)",
        "swing[c * p + k] = 0.0",
        _PEAK,
    ),
    Mutant(
        "margin above doubled",
        "above = (upper - greatest(out, p + TERMS * c) - rest) * (1.0 - 1e-9)",
        "above = (upper - greatest(out, p + TERMS * c) - rest) * 2.0",
        _PEAK,
    ),
    Mutant(
        "margin below doubled",
        "below = (least(out, p + TERMS * c) - rest - lower) * (1.0 - 1e-9)",
        "below = (least(out, p + TERMS * c) - rest - lower) * 2.0",
        _PEAK,
    ),
    Mutant(
        "lap in contact + unlimited",
        "if modes[c] == PLUS: above = np.inf",
        "if modes[c] == PLUS: above = below = np.inf",
        _PARTS,
    ),
    Mutant(
        "lap in contact - unlimited",
        "elif modes[c] == MINUS: below = np.inf",
        "elif modes[c] == MINUS: above = below = np.inf",
        _PARTS,
    ),
    Mutant(
        "clear in the gap without its bound",
        "return all_under(moved, first, plus - near) and all_over(moved, first, near - minus)",
        "return all_under(moved, first, plus) and all_over(moved, first, -minus)",
        _CELL_END,
    ),
    Mutant(
        "clear in contact + without its bound",
        "return all_over(moved, first, near)",
        "return all_over(moved, first, 0.0)",
        _CELL_END,
    ),
    Mutant(
        "clear of the wrong boundary",
        "plus, minus = memory[shape.gaps + 4 * c],",
        "plus, minus = memory[shape.gaps + 4 * c + 1],",
        _CELL_END,
    ),
    Mutant(
        "no return behind a crossing",
        "return LATER_EXIT if _two_changes(beyond, inside) else UNSURE",
        "return CLEAR",
        _RETURN,
    ),
    Mutant(
        "there and back where nothing is between",
        "or not side * (polynomial(work, x, between) - place) > near:",
        ":",
        _TOUCH,
    ),
    Mutant(
        "two changes taken for one",
        "return EXIT_AND_RETURN if _two_changes(inside, beyond) else UNSURE",
        "return ONE_EXIT",
        _TOUCH,
    ),
    Mutant(
        "always clear behind a crossing",
        "if _change(beyond, inside) or (crossed and _two_changes(inside, beyond)):",
        "if True:",
        _RETURN,
    ),
    Mutant("a stretch in between ignored", "(first & (first + 1)) == 0", "True", _TOUCH),
    Mutant(
        "crossed boundary of a sign test forgotten",
        "motion.on[which], s, proved = boundary, at, False",
        "motion.on[which], s, proved = -boundary, at, False",
        _NO_WIDTH,
    ),
    Mutant(
        "all of a group clear",
        "choose(clear, lanes.out, lanes.u, row, used)",
        "choose(group, lanes.out, lanes.u, row, used)",
        _EIGHT,
    ),
    Mutant("the wrong ones from the queue", "place = first + waiting", "place = first", _EIGHT),
    Mutant(
        "mode of a motion left behind",
        "for which in range(MASK_KINDS): mark(lanes, target",
        "for which in range(IN_MID_CELL, MASK_KINDS): mark(lanes, target",
        _EIGHT,
    ),
    Mutant(
        "number of a motion left behind",
        "lanes.motions[LANES * target + place] = lanes.motions[LANES * source + lane]",
        "pass",
        _EIGHT,
    ),
    Mutant(
        "crossed boundary of one of eight kept",
        "for which in (IN_MID_CELL, ON_PLUS, ON_MINUS, AT_START):",
        "for which in (IN_MID_CELL, AT_START):",
        _EIGHT,
    ),
    Mutant(
        "every lap of eight clear",
        "if not (within and away < np.inf):",
        "if not within and away > np.inf:",
        _EIGHT,
    ),
    Mutant(
        "crossings of both boundaries taken for one",
        "group = upward if boundary > 0 else sure & ~upward",
        "group = sure if boundary > 0 else 0",
        _EIGHT,
    ),
    Mutant(
        "two changes behind another's crossing taken for none",
        "(crossed and _two_changes(inside, beyond))",
        "_two_changes(inside, beyond)",
        _BEHIND,
    ),
    Mutant(
        "first of several crossings by another",
        "which, through = there, at, c, boundary",
        "which, through = there, at, 0, boundary",
        _BEHIND,
    ),
    Mutant(
        "second clearance not looked at",
        "if verdict != CLEAR: return UNSURE, 0, 0",
        "if c > 0: continue",
        _TWO,
    ),
)
SWITCHES = (
    Mutant(
        "pull the other way",
        "lead_back(-sign, duration, change,",
        "lead_back(sign, duration, change,",
        _CELL_END,
    ),
    Mutant(
        "moments without duration",
        "duration, before, after = memory[shape.scalars + 1] * s,",
        "duration, before, after = s,",
        _CELL_END,
    ),
    Mutant(
        "force ceases instead of setting in",
        "sign = 1.0 if engaging else -1.0",
        "sign = -1.0 if engaging else 1.0",
        _CELL_END,
    ),
    Mutant(
        "switch without damping", "rate = 0.0 if rule == ALWAYS else", "rate = 0.0 if True else", _CELL_END
    ),
    Mutant(
        "moments of a tangent without duration",
        "multiple(memory[shape.scalars + 1] * s, change, 0,",
        "multiple(s, change, 0,",
        _TANGENT,
    ),
    Mutant(
        "old centre kept",
        "memory, before, after, u, shape.p)",
        "memory, before, before, u, shape.p)",
        _CELL_END,
    ),
    Mutant(
        "no saltation",
        "if rule == IN_CONTACT or (rule == NO_TENSION and not overlapping):",
        "if False:",
        _TANGENT,
    ),
    Mutant(
        "saltation the other way",
        "jump = sign * damping * polynomial(work, OTHER, s)",
        "jump = -sign * damping * polynomial(work, OTHER, s)",
        _TANGENT,
    ),
    Mutant(
        "saltation where nothing jumps",
        "(rule == NO_TENSION and not overlapping)",
        "rule == NO_TENSION",
        _NO_TENSION,
    ),
    Mutant("engagement told as release", "(0 if engaging else 2)", "(2 if engaging else 0)", _CELL_END),
    Mutant(
        "sides told the wrong way",
        "(0 if boundary > 0 else 1)] += 1",
        "(1 if boundary > 0 else 0)] += 1",
        _CELL_END,
    ),
    Mutant(
        "second clearance not asked",
        _CHOICE,
        _CHOSEN.format("c == 0"),
        _TWO,
    ),
    Mutant(
        "last crossing first",
        f"if at < best: {_CHOICE}",
        f"if at < NO_ROOT: {_CHOICE}",
        _TWO,
    ),
    Mutant(
        "no surface of the force", "if rule != NO_TENSION or mode == FREE: continue", "continue", _NO_TENSION
    ),
    Mutant(
        "force presses always",
        "sign = damping / memory[shape.scalars + 1], 1.0 if pressed else -1.0",
        "sign = damping / memory[shape.scalars + 1], -1.0 if pressed else 1.0",
        _NO_TENSION,
    ),
)

MUTANTS = (*BOUNDS, *DIRECTIONS, *PROOFS, *SWITCHES)
