"""What is odd about stated materials: a name that stands for another one, values of none that is listed."""

from __future__ import annotations

from collections.abc import Iterator

from gearlash.case.note import Note
from gearlash.gears.drawing import Drawing
from gearlash.gears.materials import MATERIALS

from .keys import GEARS
from .rules import EntriesByKey

BEYOND = 1.25
"""Times the greatest value of the list, and below the least one."""
_LISTED = tuple(MATERIALS.values())
MODULI = (
    min(one.youngs_range[0] for one in _LISTED) / BEYOND,
    max(one.youngs_range[1] for one in _LISTED) * BEYOND,
)
"""Pa: no gear material is known here beyond."""
DENSITIES = min(one.density for one in _LISTED) / BEYOND, max(one.density for one in _LISTED) * BEYOND
"""kg/m³, likewise."""


def about_materials(stated: EntriesByKey, drawing: Drawing) -> Iterator[Note]:
    """Every such note.

    Parameters
    ----------
    stated : mapping
    drawing : Drawing
    """
    yield from _of_another_name(stated, drawing)
    yield from _of_none(stated)


def _of_another_name(stated: EntriesByKey, drawing: Drawing) -> Iterator[Note]:
    """A designation that the list has under another name, steels apart, which all have one modulus: with the
    values of the list that nobody stated beside it."""
    for gear, one in zip(GEARS, drawing.chosen_materials, strict=True):
        entry = stated.get(f"{gear}.material")
        if entry is None or one.name in ("steel", str(entry.value)):
            continue
        values = {
            "youngs_modulus": f"E {1e-9 * one.youngs_modulus:g} GPa",
            "poisson_ratio": f"ν {one.poisson_ratio:g}",
            "density": f"{one.density:g} kg/m³",
        }
        if f"{gear}.temperature" in stated or "mesh.temperature" in stated:
            values["thermal_expansion"] = f"{1e6 * one.expansion:g} µm/(m·K)"
        left = [leaf for leaf in values if f"{gear}.{leaf}" not in stated]
        if left and one.name.casefold() != str(entry.value).casefold():
            yield Note(
                entry.path,
                f"{entry.value} is taken for {one.name}: {', '.join(values[leaf] for leaf in left)}; "
                f"{_and(left)} may be stated beside it",
            )


def _of_none(stated: EntriesByKey) -> Iterator[Note]:
    """Moduli and densities far from those of every listed material."""
    rows = (("youngs_modulus", MODULI, 1e-9, "GPa"), ("density", DENSITIES, 1.0, "kg/m³"))
    for gear in GEARS:
        for leaf, (least, greatest), factor, unit in rows:
            entry = stated.get(f"{gear}.{leaf}")
            if entry is not None and not least <= entry.number <= greatest:
                low, high = factor * least * BEYOND, factor * greatest / BEYOND
                own = f"{factor * entry.number:.4g} {unit}"
                yield Note(entry.path, f"{own}; materials of the list have {low:g} to {high:g} {unit}")


def _and(words: list[str]) -> str:
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1])))
