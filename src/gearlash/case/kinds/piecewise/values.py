"""Every value of a piecewise-linear case as shown to a person: parameters, contact rules, what follows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from gearlash.case.entries import Entry
from gearlash.case.stated import Provenance
from gearlash.case.value import DERIVED, Value
from gearlash.system import Clearance, System

from .arrays import Scalar
from .expressions import Expression
from .file import Structure
from .model import Model, contact_of, model_of
from .places import CONTACT


def values(structure: Structure, entries: Mapping[str, Entry]) -> list[Value]:
    """Parameters, contact rules (the default where none is stated), definitions, closed frequencies."""
    found = [*_parameters(structure, entries), *_contacts(structure, entries)]
    model = model_of(structure, entries)
    roots: dict[str, tuple[str, ...]] = {
        v.short: (v.path,) for v in found if v.short and v.provenance == Provenance.ASSUMED
    }
    own = model.complete({name: entries[name].number for name in structure["parameters"]})
    for name, scalar in model.definitions:
        rests_on = _rests_on([scalar], roots)
        roots[name] = rests_on
        formula = scalar.stated.text if isinstance(scalar.stated, Expression) else f"{scalar.stated:g}"
        found.append(Value(scalar.path, own[name], "", DERIVED, formula, rests_on=rests_on))
    found += _closed(model, model.system(own), roots)
    return found


def _parameters(structure: Structure, entries: Mapping[str, Entry]) -> Iterator[Value]:
    for name, about in structure["parameters"].items():
        e = entries[name]
        what = about.get("description", "")
        yield Value(e.path, e.number, "", e.provenance, e.reason, name, what, text=e.text)


def _contacts(structure: Structure, entries: Mapping[str, Entry]) -> Iterator[Value]:
    for clearance in structure["clearance"]:
        path = f"clearance.{clearance['name']}.contact"
        e = entries.get(path)
        rule = contact_of(clearance["name"], entries).value
        provenance, reason, text = (
            (Provenance.ASSUMED, "default", "") if e is None else (e.provenance, e.reason, e.text)
        )
        yield Value(path, rule, "", provenance, reason, None, CONTACT, text=text)


def _rests_on(scalars: Iterable[Scalar], roots: dict[str, tuple[str, ...]]) -> tuple[str, ...]:
    names = dict.fromkeys(name for scalar in scalars for name in sorted(scalar.names))
    return tuple(dict.fromkeys(root for name in names for root in roots.get(name, ())))


def _closed(model: Model, system: System, roots: dict[str, tuple[str, ...]]) -> Iterator[Value]:
    """Natural frequencies with every clearance closed on its side +."""
    arrays = [model.matrix, *(gap.arrays[key] for gap in model.gaps for key in ("h", "g"))]
    scalars = [part for array in arrays for part in array.parts]
    for gap in model.gaps:
        scalars += [part for index, part in gap.arrays["stiffness_plus"].scalars if index == (0,)]
        scalars.append(gap.numbers["damping"])
    rests_on = _rests_on(scalars, roots)
    for i, frequency in enumerate(closed_frequencies(system), start=1):
        what = f"natural frequency {i} with every clearance closed on side + at its mean stiffness"
        formula = "|λ| of an oscillating pair of eigenvalues"
        yield Value(
            f"derived.closed_frequency_{i}", float(frequency), "", DERIVED, formula, None, what, rests_on
        )


def closed_frequencies(system: System) -> NDArray[np.float64]:
    """|λ| of every oscillating pair of eigenvalues with all clearances closed on side +, ascending.

    Equal to the undamped natural frequencies where damping is proportional."""
    closed = system.matrix.copy()
    for c in system.clearances:
        closed += np.outer(c.g, _force(c, system))
    eigenvalues = np.linalg.eigvals(closed)
    return np.sort(np.abs(eigenvalues[eigenvalues.imag > 0.0]))


def _force(c: Clearance, system: System) -> NDArray[np.float64]:
    """Φ per state in contact on side +: mean stiffness times X, damping times X' = h·M z."""
    return c.stiffness_plus[0] * c.h + c.damping * (c.h @ system.matrix)
