"""The sign test: what the signs of Bernstein coefficients prove of a whole cell.

Coefficients that are all beyond their bound on one side of a boundary prove that it is not reached. Where
they change sides once, with one at most that may be either, there is exactly one crossing; where they do so
twice, there are two or none (Descartes; see `_root_isolation`). Just behind a crossing, in the new region,
the virtual start lies beyond the boundary, as a rule: the last change of sides inward is that crossing
itself, and only one outward can follow. Where a motion has come into the middle of its cell, by a crossing of
another boundary, it is inside there: a change inward lies before that place. Of anything else the test
proves nothing, and the cell is gone through event by event."""

from __future__ import annotations

from gearlash._kernel.jit import inlined

from ._tables import ORDER, TERMS
from ._vector import greatest, least, ones_in, over, under

ALL_COEFFICIENTS = (1 << TERMS) - 1
CLEAR, ONE_EXIT, EXIT_AND_RETURN, LATER_EXIT, UNSURE = 0, 1, 2, 3, 4


@inlined
def _change(first, last):
    """Whether the coefficients of the mask ``first`` come first and those of ``last`` behind them, with one
    at most between that may be either: one change of sides."""
    rest = ALL_COEFFICIENTS ^ last
    found = first != 0 and last != 0 and (first & (first + 1)) == 0
    return found and (rest == first or rest == 2 * first + 1)


@inlined
def _two_changes(outer, middle):
    """Whether those of ``middle`` come in one stretch between those of ``outer``, with one at most at either
    of its ends that may be either."""
    rest = ALL_COEFFICIENTS ^ outer
    lowest = rest & -rest
    highest = (rest + lowest) >> 1
    inner = rest & ~lowest & ~highest
    at_ends = (outer & 1) != 0 and (outer >> (TERMS - 1)) != 0
    return at_ends and middle != 0 and (rest & (rest + lowest)) == 0 and (inner & ~middle) == 0


@inlined
def sign_test(moved, first, inward, place, near, crossed, begun):
    """What X (coefficients from ``first`` in moved) does over the whole cell at a boundary, of which it is
    inside above ``place`` (``inward`` > 0) or below: `CLEAR`, it stays inside; `ONE_EXIT`, it leaves once;
    `EXIT_AND_RETURN`, it may leave once and come back, or not; `LATER_EXIT`, having come in it leaves once
    more; else `UNSURE`.

    ``near`` bounds the error of a coefficient; ``crossed``: X has just come in through this boundary, and
    what is before counts as beyond; ``begun``: the motion is no longer at the beginning of the cell, and only
    what is to come counts."""
    if inward > 0.0:
        inside, beyond = over(moved, first, place + near), under(moved, first, place - near)
    else:
        inside, beyond = under(moved, first, place - near), over(moved, first, place + near)
    if inside == ALL_COEFFICIENTS:
        return CLEAR
    if crossed or begun:
        if _change(beyond, inside) or (crossed and _two_changes(inside, beyond)):
            return CLEAR
        if not crossed and _change(inside, beyond):
            return ONE_EXIT
        return LATER_EXIT if _two_changes(beyond, inside) else UNSURE
    if _change(inside, beyond):
        return ONE_EXIT
    return EXIT_AND_RETURN if _two_changes(inside, beyond) else UNSURE


@inlined
def leaving(moved, first, inward, place, last):
    """Where the control polygon of the coefficients leaves for the first time, or for the ``last``."""
    inside = over(moved, first, place) if inward > 0.0 else under(moved, first, place)
    if last:  # those beyond at the end
        before = (TERMS - 1) - _leading(ALL_COEFFICIENTS ^ inside)
    else:
        before = _trailing(inside) - 1
    left, right = moved[first + before] - place, moved[first + before + 1] - place
    return (before + left / (left - right)) * (1.0 / ORDER)


@inlined
def _trailing(mask):
    """Ones at the low end."""
    return ones_in(mask & ~(mask + 1)) if mask != ALL_COEFFICIENTS else TERMS


@inlined
def _leading(mask):
    """Ones at the high end."""
    zeros = ALL_COEFFICIENTS ^ mask
    place = 0
    while zeros != 0:
        zeros >>= 1
        place += 1
    return TERMS - place


@inlined
def farthest(moved, first, inward):
    """Where (0 to 1) the control polygon is farthest inside."""
    if inward > 0.0:
        mask = ALL_COEFFICIENTS ^ under(moved, first, greatest(moved, first))
    else:
        mask = ALL_COEFFICIENTS ^ over(moved, first, least(moved, first))
    return ones_in((mask & -mask) - 1) / ORDER
