"""What docs/verification.md says was found for the article's pair follows from the data that are kept.

After `make verified` a test that fails here names the words that the page now has to have.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gearlash.article.report import lumped_beside, window, with_settings
from gearlash.article.report.seen import RULES, parts
from gearlash.article.report.words import joined
from gearlash.article.verified import VerifiedPoint, VerifiedWay, kept
from gearlash.studies.verification.settings import PLANNED

PAGE = " ".join((Path(__file__).parents[2] / "docs" / "verification.md").read_text(encoding="utf-8").split())
WAYS = {way.name: way for way in kept().ways}
POINTS = [point for way in kept().ways for point in way.points]


def settings_of(way: VerifiedWay, which: int) -> list[with_settings.Row]:
    return with_settings.rows_at(way, way.points[which])


def parting(way: VerifiedWay, which: int) -> int:
    return sum(parts(row[2], row[3]) for row in settings_of(way, which))


def numbers(values: list[float]) -> str:
    return ", ".join(f"{value:.2f}" for value in values)


def solvers() -> list[tuple[VerifiedPoint, with_settings.Row]]:
    return [
        (point, row)
        for way in kept().ways
        for point in way.points
        for row in with_settings.rows_at(way, point)
        if row[0] == "generalized-α"
    ]


def of_settings() -> list[str]:
    """Counts of settings beside."""
    one, other, absolute = WAYS["stiffness"], WAYS["dimensionless"], WAYS["absolute"]
    have, none = with_settings.with_both(one), with_settings.with_both(other)
    low = settings_of(absolute, 0)
    named = sum(row[2] == absolute.points[0].label for row in low)
    assert have == ["bearing damping × 2"]
    return [
        f"Of {len(settings_of(one, 0))} settings beside with {one.face_width:.1f} mm, each with one change, "
        f"{len(have)} has both reported motions (twice the damping of the bearings)",
        f"and of {len(settings_of(other, 0))} with {other.face_width:.0f} mm, {len(none)}.",
        f"Teeth part at 3600 rpm with {parting(absolute, 0)} of the {len(low)} settings, with the label "
        f"{absolute.points[0].label} with {named} of them",
        f"Contact at 4000 rpm is kept with all {len(settings_of(absolute, 1)) - parting(absolute, 1)}.",
    ]


def of_forces() -> list[str]:
    """Least and greatest forces, and how both models compare."""
    both = [
        p
        for p in POINTS
        if not parts(p.label, p.apart) and not any(parts(p.lumped[r], p.lumped_apart[r]) for r in RULES)
    ]
    held = [WAYS[name].points[0].least for name in ("stiffness", "dimensionless")]
    apart = WAYS["absolute"].points[0]
    same = [lumped_beside.same(POINTS, rule) for rule in RULES]
    labels = [sum(p.lumped[rule] == p.label for p in POINTS) for rule in RULES]
    ways = [way for way in kept().ways if way.window]
    grid = len(window.DIRECTIONS) * sum(len(way.window["speed"]) for way in ways)
    differ = {sum(len(each) for way in ways for each in way.apart_differs[rule]) for rule in RULES}
    assert len(set(same)) == len(differ) == 1
    return [
        f"the force falls to {held[0]:.2f} and {held[1]:.2f} of its mean at the lower one",
        f"({apart.peak:.2f} and {apart.lumped_peak['always']:.2f} of the mean at 3600 rpm",
        f"the least forces of real teeth are {numbers([p.least for p in both])} of the mean, and those of "
        f"the lumped model {numbers([min(p.lumped_force) for p in both])}.",
        f"on whether teeth part at {same[0]} of {len(POINTS)} points under each rule, and on the label at "
        f"{labels[0]}, {labels[1]} and {labels[2]}",
        f"at {differ.pop()} of {grid} points of the grid of speeds under each rule",
    ]


def of_runs() -> list[str]:
    """The balance of energy, both solvers, and the inputs."""
    runs, worst = solvers(), max(abs(point.energy_residual) for point in POINTS)
    assert all(parts(p.label, p.apart) == parts(row[2], row[3]) for p, row in runs)
    alike = sum(point.label == row[2] for point, row in runs)
    one, absolute, case = WAYS["dimensionless"], WAYS["absolute"], WAYS["stiffness"]
    error = "error over static deflection"
    omegas = [f"{point.omega:.2f}" for way in (absolute, case) for point in way.points]
    return [
        f"at most {worst:.1e} is missing".replace("e-0", "e-"),
        f"at all {len(runs)} points of the kept data that have both, and the label at {alike} of them.",
        f"{one.points[0].speed:.0f} and {one.points[1].speed:.0f} rpm of the inputs “dimensionless”",
        f"{one.face_width:.0f} mm at {one.torque:.0f} N·m with bearings that grow",
        f"the error is {absolute.numbers[error]:.1f} static deflections of the mesh in place of "
        f"{case.numbers[error]:.1f}, and the mesh frequency {omegas[0]} and {omegas[1]} of that of the mesh "
        f"in place of {omegas[2]} and {omegas[3]}",
        f"with {WAYS['modified'].points[0].impacts:.2g} beginnings of contact a cycle",
    ]


def of_what_is_kept_beside() -> list[str]:
    """How long motions settled, and what flanks make of the error under load."""
    cycles = [row[2] for way in kept().ways for row in way.settled]
    longer, plan = sum(count > PLANNED.settle for count in cycles), PLANNED
    relieved = WAYS["modified"].errors_under_load
    plain = max(max(way.errors_under_load) for name, way in WAYS.items() if name != "modified")
    return [
        f"to {plan.longest * plan.settle + plan.read + 1} cycles at most",
        f"of the {len(cycles)} motions of the kept data {longer} were given more than {plan.settle}, none "
        f"more than {max(cycles)}.",
        f"{joined([f'{each:.2f}' for each in relieved])} µm at the first three mesh orders with the modified "
        f"flanks of the report, at most {plain:.2f} µm with unmodified ones, beside the "
        f"{WAYS['modified'].error:.1f} µm that are on them.",
    ]


@pytest.mark.parametrize("words", [*of_settings(), *of_forces(), *of_runs(), *of_what_is_kept_beside()])
def test_the_page_says_what_the_data_say(words: str):
    assert words in PAGE


def test_two_bodies_that_bend_part_as_the_page_says():
    """With 14.2 mm at the higher speed only, with 65 mm at both, and not with the absolute inputs."""
    found = {}
    for name, way in WAYS.items():
        rows = [row for which in (0, 1) for row in settings_of(way, which) if row[0] == "flexible pinion"]
        found[name] = [parts(row[2], row[3]) for row in rows]
    assert found["stiffness"] == [False, True]
    assert found["dimensionless"] == [True, True]
    assert found["absolute"] == [False, False]
    assert (
        "with 14.2 mm at the higher speed only, the reverse of what is reported, and with 65 mm at both"
        in PAGE
    )


def test_the_modified_teeth_do_what_the_page_says():
    """Both part, pressed together; at the higher speed contact is found, begun from below."""
    way = WAYS["modified"]
    assert all(point.apart > 0.0 for point in way.points)
    at = int(np.abs(np.array(way.window["speed"]) - way.points[1].speed).argmin())
    assert not parts(way.window["up"][at], None)
    assert way.window["up"][at] != "none"
    assert "begun from the motion at the speed below they stay in contact" in PAGE
