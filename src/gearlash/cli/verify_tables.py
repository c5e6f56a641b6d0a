"""The tables of `gearlash verify`, the main one first."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from .tables import table_of

if TYPE_CHECKING:
    from gearlash.results.columns import Column

    from .answers.verify import ConfigurationCompared, PointComputed, VerifyAnswer

REAL = "real teeth"


def verify_tables(answer: VerifyAnswer) -> dict[str, Sequence[Column]]:
    """A row a motion; forces over time and order; labels over the window; centre distance; meshes."""
    from gearlash.results.columns import Column

    from .answers.verify import MeshComputed

    ways = answer.configurations
    return {
        "verify": _motions(ways),
        "forces": _long(ways, ("phase", "force_over_mean"), _forces),
        "orders": _long(ways, ("order", "amplitude_over_mean"), _orders),
        "window": _window(ways),
        "breathing": _breathing(ways),
        "meshes": [
            Column(column.name, column.values, UNITS_OF_MESH.get(column.name, ""))
            for column in table_of(answer.meshes, MeshComputed)
        ],
    }


UNITS_OF_MESH = {
    "face_width": "mm",
    "stiffness": "N/m",
    "transmission_error": "µm",
    **{f"errors_under_load_{order}": "µm" for order in (1, 2, 3)},
    "backlash": "µm",
    "torque": "N·m",
}


def _motions(ways: Sequence[ConfigurationCompared]) -> list[Column]:
    """Of real teeth with every setting, and of the lumped model under every rule."""
    from gearlash.results.columns import Column

    rows: list[tuple[Any, ...]] = []
    for way in ways:
        speeds = {p.omega: p.speed for p in way.points}
        for p in (*way.points, *way.beside):
            forces = p.least_force, p.mean_force, p.greatest_force
            steps = p.settled, p.settle_steps, p.read_steps
            read = p.impacts, p.back_impacts, *forces, p.returns, p.energy_residual, *steps
            rows.append((way.name, REAL, p.setting, p.speed, p.omega, p.label, p.apart, *read))
        for p in way.lumped:
            head = way.name, "lumped model", p.rule, speeds.get(p.omega), p.omega
            rows.append((*head, p.label, p.apart, *(None,) * 10))
    heads = (
        ("inputs", ""), ("model", ""), ("setting_or_rule", ""), ("speed", "rpm"), ("omega", ""),
        ("label", ""), ("apart", ""), ("impacts", ""), ("back_impacts", ""), ("least_force", "N"),
        ("mean_force", "N"), ("greatest_force", "N"), ("returns", ""), ("energy_residual", ""),
        ("settled", ""), ("settle_steps", ""), ("read_steps", ""),
    )  # fmt: skip
    return [Column(name, [row[i] for row in rows], unit) for i, (name, unit) in enumerate(heads)]


def _forces(point: PointComputed) -> Iterator[tuple[float, float]]:
    yield from zip(point.phase, (each / point.mean_force for each in point.force), strict=True)


def _orders(point: PointComputed) -> Iterator[tuple[float, float]]:
    yield from ((0.5 * i, each / point.mean_force) for i, each in enumerate(point.orders, 1))


def _long(ways: Sequence[ConfigurationCompared], names: tuple[str, str], of: Any) -> list[Column]:
    """Two numbers a row, of every motion as planned and of the lumped ones."""
    from gearlash.results.columns import Column

    rows: list[tuple[Any, ...]] = []
    for way in ways:
        speeds = {p.omega: p.speed for p in way.points}
        for p in way.points:
            rows += [(way.name, REAL, p.speed, p.omega, *each) for each in of(p)]
        for p in way.lumped:
            both: Iterable[tuple[float, float]]
            both = zip(*((p.phase, p.force) if of is _forces else (p.orders, p.amplitudes)), strict=True)
            head = way.name, f"lumped model, {p.rule}", speeds.get(p.omega), p.omega
            rows += [(*head, *each) for each in both]
    heads = ("inputs", "model", "speed", "omega", *names)
    units = {"speed": "rpm"}
    return [Column(name, [row[i] for row in rows], units.get(name, "")) for i, name in enumerate(heads)]


def _window(ways: Sequence[ConfigurationCompared]) -> list[Column]:
    from gearlash.results.columns import Column

    found = [
        Column("inputs", [way.name for way in ways for _ in way.window.omega]),
        Column("speed", [speed for way in ways for speed in way.window.speed], "rpm"),
        Column("omega", [omega for way in ways for omega in way.window.omega]),
        Column("real_teeth_rising", [label for way in ways for label in way.window.up]),
        Column("real_teeth_falling", [label for way in ways for label in way.window.down]),
    ]
    for rule in ways[0].window.lumped_up if ways else ():
        name = f"lumped_{rule.replace('-', '_')}"
        found.append(
            Column(f"{name}_rising", [label for way in ways for label in way.window.lumped_up[rule]])
        )
        found.append(
            Column(f"{name}_falling", [label for way in ways for label in way.window.lumped_down[rule]])
        )
    return found


def _breathing(ways: Sequence[ConfigurationCompared]) -> list[Column]:
    from gearlash.results.columns import Column

    rows = [(way.name, each) for way in ways for each in way.breathing]
    speeds = {(way.name, p.omega): p.speed for way in ways for p in way.points}
    found = [
        Column("inputs", [name for name, _ in rows]),
        Column("speed", [speeds.get((name, each.omega)) for name, each in rows], "rpm"),
        Column("omega", [each.omega for _, each in rows]),
    ]
    for name, unit in (("centre_distance", "µm"), ("contact_ratio", ""), ("backlash", "µm")):
        for i, end in enumerate(("least", "greatest")):
            found.append(Column(f"{name}_{end}", [getattr(each, name)[i] for _, each in rows], unit))
    found.append(Column("label_held", [each.label_held for _, each in rows]))
    return [*found, Column("peak_share", [each.peak_share for _, each in rows])]
