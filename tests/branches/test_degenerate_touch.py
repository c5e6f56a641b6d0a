"""Where an extremum merges with a crossing."""

from __future__ import annotations

import numpy as np
import pytest

from branches.curved import swallowtail, two_harmonics
from gearlash.branches.curves import CodimTwoKind


@pytest.mark.parametrize("which", [0, 1])
def test_an_excursion_grows_with_the_power_four_thirds(which):
    """In 80 bits: over a crossing with X′ = X″ = 0 the map is linear but for |q|^{4/3}; over one with X″ = 0
    alone it would be smooth, over an extremum 3/2."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle

    cusp = swallowtail().of_kind(CodimTwoKind.DEGENERATE)[which]
    values = {**swallowtail().values, **dict(zip(swallowtail().names, cusp.values, strict=True))}
    system = two_harmonics(1.0, 1.0)[0].system(values)
    (touch,) = cusp.point.touches
    length = 0.02
    before = region_oracle.run(system, np.array([values["D"], 0.0]), -length, touch.phase).state
    push = np.array([1.0, 0.0])

    def end(away: float) -> np.ndarray:
        return region_oracle.run(system, before + away * push, 2.0 * length, touch.phase - length).state

    sizes = np.logspace(-10, -8, 5)
    bends = [float(np.abs(end(size) + end(-size) - 2.0 * end(0.0)).max()) for size in sizes]
    assert np.polyfit(np.log(sizes), np.log(bends), 1)[0] == pytest.approx(4.0 / 3.0, abs=0.03)
