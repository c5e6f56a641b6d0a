"""Columns of a varied parameter: first in the unit that was asked for."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from math import isclose
from typing import TYPE_CHECKING, Any

import numpy as np

from gearlash.case import Case
from gearlash.results.columns import Column
from gearlash.results.variables import dimension

from .answers.asked import as_typed, is_quantity

if TYPE_CHECKING:
    from .answers.asked import Asked


def axes_first(table: Sequence[Column], case: Case, axes: Sequence[tuple[str, Asked]]) -> list[Column]:
    """A table of a dataset with the varied parameters, by short name, in front: each first in the unit asked
    for, dimensionless last."""
    front: list[Column] = []
    rest = list(table)
    for short, asked in axes:
        leaves = {path.rpartition(".")[2] for path, _, _ in case.physical(short, 1.0)}
        own = [each for each in rest if each.name in (short, dimension(short)) and not each.unit]
        others = [_rounded(each) for each in rest if each.name in leaves and each.unit]
        rest = [each for each in rest if each not in own and not (each.name in leaves and each.unit)]
        typed = [_typed(asked, asked.name, column.values) for column in own] if asked.unit else []
        others = sorted(others, key=lambda each: each.name != asked.name)
        if typed and others and _same(typed[0], others[0]):
            typed = []  # it is there in the same unit
        if asked.unit and (typed or others) and is_quantity(short):
            own = []
        front += [*typed, *others, *own] if asked.unit else [*own, *others]
    return front + rest


def told_as_asked(
    table: Sequence[Column], asked: Asked, names: Collection[str], called: str = ""
) -> list[Column]:
    """A table of records with every value of the parameter, which columns with these names have, in the unit
    asked for before the dimensionless one: of ``lower_value`` the column ``lower_pinion_speed [rpm]`` that is
    there, else one of the same name, or ``called`` so."""
    if not asked.unit:
        return list(table)
    found: list[Column] = []
    moved: set[str] = set()
    for column in table:
        if column.name in names and not column.unit:
            other = column.name.removesuffix("value") + asked.name
            there = [each for each in table if each.name == other and each.unit]
            if column.name.endswith("value") and there:
                moved.add(there[0].head)
                found.append(_rounded(there[0]))
            else:
                found.append(_typed(asked, called or column.name, column.values))
        if column.head not in moved:
            found.append(column)
    return found


def _typed(asked: Asked, name: str, values: Iterable[Any]) -> Column:
    told = [None if value is None else as_typed(asked.value(float(value))) for value in values]
    return Column(name, told, asked.unit)


def _rounded(column: Column) -> Column:
    values = [None if value is None else as_typed(float(value)) for value in column.values]
    return Column(column.name, values, column.unit, column.description)


def _same(one: Column, other: Column) -> bool:
    """Whether both have the same numbers under the same name: then in one unit."""
    pairs = zip(np.asarray(one.values, dtype=float), np.asarray(other.values, dtype=float), strict=True)
    return one.name == other.name and all(isclose(a, b, rel_tol=1e-9) for a, b in pairs)
