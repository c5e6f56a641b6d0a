"""How much memory the tables of one system may take, what they would take, and which number of the system
makes them large. All of it is known before a table is built."""

from __future__ import annotations

import os
import re
from dataclasses import replace
from math import pi, prod

import numpy as np

from gearlash.system import ContactRule, GearlashError, System
from gearlash.system.harmonics import harmonics

from ._tables import FREE, MINUS, PLUS, TERMS, Plan, Shape, lay_out
from .regions import Sides, fastest_of, first_guess, highest_moved, highest_turn, units_of

MOST_CELLS = 200_000
ILL_SCALED = 2.0  # times the cells that rates ask for: behind it they are not the reason
MOST_BYTES = 1_000_000_000
"""Of the tables of one system, unless `VARIABLE` says otherwise; a study holds those of two at a time."""
VARIABLE = "GEARLASH_MEMORY"
_SIZE = re.compile(r"\s*(\d{1,9}(?:\.\d{1,9})?)\s*([KMGT]i?B)\s*", re.ASCII)
_BYTES = {"K": 1, "M": 2, "G": 3, "T": 4}


def allowed() -> float:
    """Bytes. Raises `GearlashError` where the variable holds something else."""
    text = os.environ.get(VARIABLE, "")
    if not text.strip():
        return MOST_BYTES
    match = _SIZE.fullmatch(text)
    if match is None:
        raise GearlashError(f"{VARIABLE} = {text[:40]!r}: expected a size such as 500MB or 4GB")
    return float(match[1]) * (1024.0 if match[2][1] == "i" else 1000.0) ** _BYTES[match[2][0]]


def regions_likely(system: System) -> int:
    """Regions that motions come to: no contact, and contact on every side where there is something to hit."""
    return 1 + sum(c.stops(side) for c in system.clearances for side in (1, -1))


def regions_possible(system: System, room: float) -> int:
    """As many regions as motions can come to at all, but no more than ``room`` (how many fit)."""
    possible = prod(1 + c.stops(1) + c.stops(-1) for c in system.clearances)
    return max(regions_likely(system), int(min(possible, room)))


def needed(shape: Shape, regions: int, units: int) -> float:
    """Bytes of the tables of so many regions, with the responses to unit inputs that they are summed from."""
    return 8.0 * shape.slots + regions * of_region(shape, units)


def of_region(shape: Shape, units: int) -> float:
    """Bytes of one region's tables, with its responses."""
    return 8.0 * (shape.slot + float(shape.cells) * units * (shape.n + shape.clearances * TERMS))


def load(system: System) -> tuple[int, float]:
    """Cells of a period, as first guessed, and bytes of tables. Raises `GearlashError` where there are too
    many or it takes too much."""
    cells = first_guess(system)
    check_cells(system, cells)
    shape, regions, units = laid_out(system, int(cells)), regions_likely(system), len(units_of(system))
    check_memory(system, shape, regions, units)
    return int(cells), needed(shape, regions, units)


def laid_out(system: System, cells: int) -> Shape:
    """The places of the tables, with so many cells."""
    series = (s for c in system.clearances for s in (c.offset, c.stiffness_plus, c.stiffness_minus))
    count = max(harmonics(s) for s in (system.forcing, *series))
    return lay_out(Plan(system.size, len(system.clearances), cells, count))


def check_memory(system: System, shape: Shape, regions: int, units: int) -> None:
    """Raises `GearlashError` where the tables of so many regions would take more than is allowed."""
    size, most = needed(shape, regions, units), allowed()
    if size > most:
        raise GearlashError(
            f"tables of {_count(regions, 'contact state')}, {shape.cells:,} cells a period, for "
            f"{_count(shape.n, 'state')} would take {size_text(size)}, more than the {size_text(most)} "
            f"allowed: {cause(system, shape.cells)}; {advice(system, shape.cells)}, or allow more memory "
            f"({VARIABLE}={size_text(size * 1.2, '')})"
        )


def check_cells(system: System, cells: float) -> None:
    """Raises `GearlashError` where a period would be cut into too many cells."""
    if not cells <= MOST_CELLS:
        raise GearlashError(
            f"{_number(cells)} cells a period would be needed, more than {MOST_CELLS:,}: "
            f"{cause(system, cells)}; {advice(system, cells)}"
        )


def cause(system: System, cells: float) -> str:
    """Which number makes a period so many cells."""
    guess = first_guess(system)
    if cells > ILL_SCALED * guess:
        small, large = _sizes(system)
        return (
            f"its rates alone would need {_number(guess)} cells, but coefficients from {small:.2g} to "
            f"{large:.2g} over a period of {system.period:.2g} let states grow faster than rates say"
        )
    moved = 2.0 * pi * highest_moved(system)
    if 2.0 * pi * highest_turn(system) > system.period * fastest_of(system) + moved:
        return f"harmonic {highest_turn(system)} of a forcing or an offset"
    if moved > system.period * fastest_of(system):
        return f"harmonic {highest_moved(system)} of a stiffness"
    name, what, rate = _fastest(system)
    there = f"{what} of {name}" if name else "the matrix"
    about = f"omega = {system.omega:.6g}"
    if system.cycles > 1:
        about += f" (a base period of {system.cycles} cycles)"
    return f"{about} is slow beside the rate {rate:.6g}, which {there} makes"


def advice(system: System, cells: float) -> str:
    """What to change."""
    if cells > ILL_SCALED * first_guess(system):
        return "raise omega, or measure states in units that bring coefficients closer"
    turn, moved = 2.0 * pi * highest_turn(system), 2.0 * pi * highest_moved(system)
    if max(turn, moved) > system.period * fastest_of(system):
        return "use fewer harmonics"
    name, what, _ = _fastest(system)
    return f"raise omega, or make {what.split(' = ')[0] if name else 'the fastest rate'} smaller"


def _sizes(system: System) -> tuple[float, float]:
    """The smallest and largest coefficient that is there, of all that a motion's rates come from."""
    arrays = [system.matrix]
    for c in system.clearances:
        arrays += [c.h, c.g, c.stiffness_plus, c.stiffness_minus, np.array(c.dampings)]
    found = np.abs(np.concatenate([np.ravel(array) for array in arrays]))
    return float(found[found > 0.0].min()), float(found.max())


def _fastest(system: System) -> tuple[str, str, float]:
    """The side of a clearance whose contact is the fastest, with its stiffness or damping, and the rate; no
    name where the system is as fast without contact."""
    count = len(system.clearances)
    free = fastest_of(system, [(FREE,) * count])
    found = "", "", free
    for i, clearance in enumerate(system.clearances):
        for side in (PLUS, MINUS):
            if not clearance.stops(1 if side == PLUS else -1):
                continue
            sides: Sides = (FREE,) * i + (side,) + (FREE,) * (count - i - 1)
            rate = fastest_of(system, [sides])
            if rate > max(found[2], 1.5 * free):
                found = (
                    f"side {'+' if side == PLUS else '-'} of {clearance.name!r}",
                    _what(system, i, sides),
                    rate,
                )
    return found if found[0] else _damped(system, free)


def _what(system: System, i: int, sides: Sides) -> str:
    """Whether the stiffness or the damping of a side makes it fast."""
    clearance, plus = system.clearances[i], sides[i] == PLUS
    damping = clearance.dampings[0 if plus else 1]
    undamped = replace(clearance, damping=0.0, damping_minus=None)
    others = system.clearances
    without = replace(system, clearances=(*others[:i], undamped, *others[i + 1 :]))
    if damping and fastest_of(system, [sides]) > 1.5 * fastest_of(without, [sides]):
        return f"damping = {damping:.6g}"
    series = clearance.stiffness_plus if plus else clearance.stiffness_minus
    return f"stiffness = {float(series[0]):.6g}"


def _damped(system: System, free: float) -> tuple[str, str, float]:
    """Damping that acts in the gap too is part of the system without contact."""
    for clearance in system.clearances:
        if clearance.contact is ContactRule.ALWAYS and clearance.damping:
            others = (c for c in system.clearances if c is not clearance)
            undamped = replace(system, clearances=(replace(clearance, damping=0.0), *others))
            if free > 1.5 * fastest_of(undamped, [(FREE,) * len(system.clearances)]):
                return repr(clearance.name), f"damping = {clearance.damping:.6g}", free
    return "", "", free


def _number(cells: float) -> str:
    return f"{cells:,.0f}" if cells < 1e12 else f"{cells:.2g}"


def _count(number: int, what: str) -> str:
    return f"1 {what}" if number == 1 else f"{number} {what}s"


def size_text(size: float, gap: str = " ") -> str:
    """Bytes in words."""
    return f"{size / 1e9:.3g}{gap}GB" if size >= 1e9 else f"{size / 1e6:.0f}{gap}MB"
