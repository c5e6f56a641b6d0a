"""Print the worst errors of orbits and grazing points: ``cd tests && python -m branches.measure``.

The tests assert bounds; this shows how far below them the results are.
"""

from __future__ import annotations

import numpy as np

from gearlash.branches import locate_grazing, locate_multiplier
from gearlash.orbits import Orbit, grazing_checks, lyapunov, sections, shoot
from gearlash.system import Family
from oracles import closed_forms
from oracles.heyoka_oracle import Oracle
from orbits.members import article, built, cold, one_dof, orbit

PLACES = [
    *({"omega": w} for w in (1.047, 0.942, 1.11, 0.83)),
    *({"omega": 0.78, "D": D} for D in (0.5, 0.386, 0.39, 0.382, 0.375)),
]


def _orbits() -> None:
    family = article()
    oracle = Oracle([family.system({})], harmonics=1, variational=True)
    worst = dict.fromkeys(
        ("residual", "closes under heyoka", "monodromy", "sum of exponents", "on boundary"), 0.0
    )
    for place in PLACES:
        found = orbit(family, **place)
        system = found.propagators.system
        run = oracle.run(system, found.state, float(found.period))
        theirs, trace = run.jacobian.astype(float), found.propagators.trace
        assert trace is not None  # damping acts always
        data, gap = sections(found), system.clearances[0].gap_plus
        apart = [np.abs(data.drive.displacement - gap), np.abs(data.back.displacement + gap)]
        new = {
            "residual": found.residual,
            "closes under heyoka": float(np.abs(run.state - found.state).max()),
            "monodromy": float(np.abs(found.shot.monodromy - theirs).max() / np.abs(theirs).max()),
            "sum of exponents": abs(found.exponents.sum() / trace - 1.0),
            "on boundary": float(np.concatenate(apart).max(initial=0.0)),
        }
        worst = {name: max(value, new[name]) for name, value in worst.items()}
    for name, value in worst.items():
        print(f"{len(PLACES)} orbits of the article's pair, {name:22} {value:.1e}")
    chaos = cold(family, omega=0.78, D=0.3)
    spectrum = lyapunov(chaos.propagators, chaos.final_state, 2_000)
    assert chaos.propagators.trace is not None
    defect = abs(spectrum.trace_defect / chaos.propagators.trace)
    print(f"chaos, sum of exponents over trace - 1{'':18} {defect:.1e}")


def _first(family: Family, name: str, start: Orbit, values: dict[str, float]):
    check = next(c for c in grazing_checks(start) if c.boundary == 1)
    return locate_grazing(family, name, start, check, values=family.complete(values))


def _closed_forms() -> None:
    family, errors, sides = one_dof(), [], []
    for omega in np.linspace(0.25, 1.9, 34):
        exact = closed_forms.spur_grazing_load(omega, 0.1, 0.1)
        values = {"omega": omega, "load": 1.1 * exact}
        clear = closed_forms.permanent_contact(family.system(values), order=2)(np.array(0.0))
        shot = shoot(built(family, **values), clear, 1)
        start = Orbit(built(family, **values), shot, 0, shot.status, "")
        point = _first(family, "load", start, values)
        errors.append(abs(point.value / exact - 1.0))
        there = {**values, "load": point.value * (1 - 1e-6)}
        shot = shoot(built(family, **there), point.state_zero, 1)
        other = _first(family, "load", Orbit(built(family, **there), shot, 0, shot.status, ""), there)
        sides.append(abs(other.value / point.value - 1.0))
    print(f"grazing load, one degree of freedom, closed form, {len(errors)} speeds   {max(errors):.1e}")
    print(f"the same from the impacting and from the clear side {'':6} {max(sides):.1e}")


def _harmonic_balance() -> None:
    family = article()
    for name, place, bracket in (
        ("omega", {"omega": 0.98}, (0.96, 0.99)),
        ("omega", {"omega": 1.09}, (1.09, 1.13)),
        ("load", {"omega": 0.98}, (0.07, 0.09)),
        ("ripple", {"omega": 0.965, "load": 0.095}, (0.1, 0.45)),
        ("error", {"omega": 0.98}, (0.27, 0.32)),
    ):

        def build(value: float, name=name, place=place):
            return family.system({**place, name: value})

        exact = closed_forms.grazing_parameter(build, *bracket, order=16)
        point = _first(family, name, orbit(family, **place), place)
        print(
            f"grazing over {name:8} {point.value:.13f}, harmonic balance {abs(point.value / exact - 1):.1e}"
        )


def _doublings() -> None:
    for place, name in (
        ({"omega": 1.3}, "omega"),
        ({"omega": 0.79}, "omega"),
        ({"omega": 0.78, "D": 0.386}, "D"),
    ):
        point = locate_multiplier(
            article(), name, orbit(article(), **place), -1, values=article().complete(place)
        )
        away = np.abs(point.multipliers + 1).min()
        print(f"doubling of {point.label} at {name} = {point.value:.12f}, |λ+1| = {away:.1e}")


if __name__ == "__main__":
    _orbits()
    _closed_forms()
    _harmonic_balance()
    _doublings()
