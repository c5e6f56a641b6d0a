"""Random drawings become cases whose numbers are those of hand formulas, and extreme ones get a verdict."""

from __future__ import annotations

from math import asin, atan, cos, isfinite, pi, radians, sin, sqrt, tan

import pytest

import gearlash as gl
from benchmarks.drawings import MODULES, MOST_TEETH, PLASTICS, RandomDrawing, random_drawing
from cli.conftest import Gearlash
from gearlash.gears import materials
from gearlash.results import Axis
from gearlash.results.pair_question import speeds_around
from gearlash.studies.assessment import assess

SEEDS = range(0, 20, 3)
EXTREME = {
    "light plastic spur pair": 20,  # module 0.8, 0.1 N·m, 11479 rpm
    "undercut helical pair": 15,  # 14 teeth, module 0.8
}


@pytest.fixture
def drawn(tmp_path, gearlash: Gearlash):
    """The case of a seed, by `gearlash new`."""

    def case_of(seed: int) -> gl.Case:
        file = tmp_path / f"drawing-{seed}.toml"
        assert gearlash("new", str(file), *random_drawing(seed).options).code == 0
        return gl.load_case(file)

    return case_of


def test_a_seed_is_a_drawing_within_the_ranges():
    for seed in range(200):
        one = random_drawing(seed)
        assert one == random_drawing(seed)
        assert one.module in MODULES
        assert 12 <= one.teeth[0] <= one.teeth[1] <= MOST_TEETH
        assert 0.99 <= one.teeth[1] / one.teeth[0] <= 8.1
        assert 0.0 <= one.helix_angle <= 35.0
    kinds = [random_drawing(seed) for seed in range(20)]
    assert any(one.helix_angle for one in kinds)
    assert any(set(one.materials) & set(PLASTICS) for one in kinds)


def by_hand(drawing: RandomDrawing, stiffness: float) -> dict[str, float]:
    """Overlap ratio, masses of discs in kg, and the speed at which the mesh meets the natural frequency of
    both bodies on its stiffness, their bearings rigid, in rpm."""
    helix, width, teeth = radians(drawing.helix_angle), drawing.face_width * 1e-3, drawing.teeth
    module = drawing.module * 1e-3
    radii = [module * z / cos(helix) / 2.0 for z in teeth]
    bores = [0.0, 0.0] if drawing.bores is None else [b * 0.5e-3 for b in drawing.bores]
    density = [materials.named(name).density for name in drawing.materials]
    mass = [rho * width * pi * (r**2 - b**2) for rho, r, b in zip(density, radii, bores, strict=True)]
    inertia = [m * (r**2 + b**2) / 2.0 for m, r, b in zip(mass, radii, bores, strict=True)]
    transverse = atan(tan(radians(20.0)) / cos(helix))
    reduced = 1.0 / sum((r * cos(transverse)) ** 2 / j for r, j in zip(radii, inertia, strict=True))
    base_helix = asin(sin(helix) * cos(radians(20.0)))
    frequency = sqrt(stiffness * cos(base_helix) ** 2 / reduced) / (2.0 * pi)
    return {
        "overlap_ratio": width * sin(helix) / (pi * module),
        "pinion": mass[0],
        "gear": mass[1],
        "speed": 60.0 * frequency / teeth[0],
    }


@pytest.mark.parametrize("seed", SEEDS)
def test_numbers_are_those_of_hand_formulas(seed, drawn):
    drawing, case = random_drawing(seed), drawn(seed)
    values = {value.path: value.value for value in case.values()}
    stiffness = values["mesh.mean_stiffness"]
    hand = by_hand(drawing, stiffness)
    assert 1.0 < values["derived.transverse_contact_ratio"] < 2.0
    if drawing.helix_angle:
        assert values["derived.overlap_ratio"] == pytest.approx(hand["overlap_ratio"], rel=0.01)
    for body in ("pinion", "gear"):  # of the mean diameter of the teeth, which a profile shift moves
        assert values[f"{body}.mass"] == pytest.approx(hand[body], rel=0.08)
    a_width = stiffness / drawing.face_width * 1e-6  # N/(mm µm): steel 20, and plastics a hundredth of it
    low, high = (0.08, 1.5) if set(drawing.materials) & set(PLASTICS) else (7.0, 26.0)
    assert low < a_width < high
    if not drawing.helix_angle:
        meets = [v for path, v in values.items() if path.startswith("derived.critical")]
        assert meets == [pytest.approx(hand["speed"], rel=0.06)]


@pytest.mark.parametrize("seed", EXTREME.values(), ids=EXTREME)
def test_extreme_drawings_get_a_verdict(seed, drawn, monkeypatch):
    monkeypatch.setattr("gearlash.studies.assessment.WORK", 600)  # so that this takes seconds
    case = drawn(seed)
    ends = speeds_around(case, 2).values
    found = assess(case, Axis.even("omega", float(ends[0]), float(ends[1]), 5))
    assert found.complete
    assert found.signals is not None
    static = found.values["load"] / found.values["rotation_factor"]
    force = found.signals.force
    assert force.mean == pytest.approx(static, rel=0.05)  # what is carried is what is driven
    assert force.least <= static <= force.most
    assert 0.0 <= found.signals.share_without_contact < 1.0
    assert found.ranges is not None
    assert isfinite(found.ranges.margin)
    for band in (*found.separating, *found.back_side):
        assert ends[0] <= band.lower.value <= band.upper.value <= ends[1]
