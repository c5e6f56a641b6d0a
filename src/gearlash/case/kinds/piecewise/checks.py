"""What in a piecewise-linear case makes no system: numbers without a value, negative gaps, h·g ≠ 0."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from gearlash.case.entries import Entry
from gearlash.case.errors import Problem
from gearlash.system import Clearance, ContactRule, GearlashError
from gearlash.system.piecewise import size_problem

from .arrays import NoValueError, Scalar
from .file import Structure
from .model import Gap, Model, model_of


def contradictions(structure: Structure, entries: Mapping[str, Entry]) -> list[Problem]:
    """Every reason why these values make no system; empty when they make one."""
    model = model_of(structure, entries)
    values, problems = _defined(model, {name: entries[name].number for name in structure["parameters"]})
    problems += [problem for scalar in model.scalars() if (problem := _without_value(scalar, values))]
    if problems:
        return problems
    gaps = [(gap, gap.at(values)) for gap in model.gaps]
    problems = [problem for gap, clearance in gaps for problem in _of_clearance(gap, clearance)]
    problems += _couplings([clearance for _, clearance in gaps])
    if not problems:
        try:
            model.system(values)
        except GearlashError as error:
            problems.append(Problem("case", None, f"numbers that make a system ({error})"))
    return problems


def _defined(model: Model, parameters: Mapping[str, float]) -> tuple[dict[str, float], list[Problem]]:
    """Parameters and those definitions that have a value; the others are problems."""
    values, problems = dict(parameters), []
    for name, scalar in model.definitions:
        if not scalar.names <= set(values):
            continue  # what it is made of is a problem already
        problem = _without_value(scalar, values)
        if problem is None:
            values[name] = scalar.at(values)
        else:
            problems.append(problem)
    return values, problems


def _without_value(scalar: Scalar, values: Mapping[str, float]) -> Problem | None:
    if not scalar.names <= set(values):
        return None  # one of its definitions is a problem already
    try:
        scalar.at(values)
    except NoValueError as error:
        return Problem(error.path, repr(error.text), error.expected)
    return None


def _of_clearance(gap: Gap, clearance: Clearance) -> Iterator[Problem]:
    path = f"clearance.{gap.name}"
    width = clearance.gap_plus + clearance.gap_minus
    if width < 0.0:
        expected = (
            f"gap_plus + gap_minus of 0 or more (it is {width:g}): contact is X > gap_plus, X < -gap_minus"
        )
        yield Problem(f"{path}.gap_minus", repr(clearance.gap_minus), expected)
    if not clearance.h.any():
        yield Problem(f"{path}.h", None, "a number other than 0: the gap coordinate reads no state")
    if not clearance.g.any():
        yield Problem(f"{path}.g", None, "a number other than 0: the contact force acts on no state")
    for name in ("h", "g"):
        problem = size_problem(getattr(clearance, name))
        if problem:
            yield Problem(f"{path}.{name}", None, f"a direction of a usual size (it {problem})")
    if clearance.contact is ContactRule.ALWAYS and len(set(clearance.dampings)) > 1:
        expected = "no other damping than side + has: contact = 'always' lets it act in the gap too"
        yield Problem(f"{path}.damping_minus", repr(clearance.damping_minus), expected)


def _couplings(clearances: list[Clearance]) -> Iterator[Problem]:
    """h_j·g_k = 0 for all pairs: a contact force acts on accelerations, on no gap's velocity directly."""
    for reader in clearances:
        for actor in clearances:
            size = float(np.abs(reader.h) @ np.abs(actor.g))
            product = float(reader.h @ actor.g)
            if abs(product) > 1e-14 * size:
                expected = (
                    f"h·g = 0 with g of {actor.name} (it is {product:g}): a contact force acts on "
                    "accelerations, so h must read displacements and g enter the equations of velocities"
                )
                yield Problem(f"clearance.{reader.name}.h", None, expected)
