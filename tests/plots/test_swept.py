"""Directions of a sweep as arrays, and where they differ."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import xarray as xr

from gearlash.plots.regimes import APERIODIC, BACK, DRIVE, FREE, UNRESOLVED, regime, short
from gearlash.plots.swept import Swept, axis_name, differs, swept
from gearlash.system import UnknownNameError, read_label
from plots.made import dataset

NAN = float("nan")


def one_way(labels: tuple[str, ...], strobes: list[list[float]]) -> Swept:
    count = len(labels)
    nothing = np.full((count, 1), NAN)
    return Swept(
        "cold",
        np.arange(count, dtype=float),
        tuple(map(read_label, labels)),
        np.zeros(count),
        np.zeros(count),
        np.array(strobes),
        nothing,
        nothing,
        nothing,
        np.zeros(count - 1, dtype=bool),
    )


def test_an_orbit_met_at_another_phase_is_the_same() -> None:
    one = one_way(("2-1-0", "1-1-0"), [[1.0, 2.0], [3.0, NAN]])
    two = one_way(("2-1-0", "1-1-0"), [[2.0, 1.0 + 1e-9], [3.0, NAN]])
    assert not differs(one, two).any()


def test_other_labels_other_points_and_missing_values_differ() -> None:
    one = one_way(("2-1-0", "1-1-0", "1-1-0"), [[1.0, 2.0], [3.0, NAN], [3.0, NAN]])
    two = one_way(("2-2-0", "1-1-0"), [[1.0, 2.0], [3.1, NAN]])
    assert differs(one, two).tolist() == [True, True, True]


def test_two_aperiodic_motions_cannot_be_told_apart() -> None:
    one, two = one_way(("aperiodic",), [[1.0, 2.0]]), one_way(("aperiodic",), [[1.3, 1.4]])
    assert not differs(one, two).any()


def test_runs_cover_the_axis_once() -> None:
    runs = one_way(("1-1-0", "1-1-0", "1-0-0"), [[1.0], [1.0], [1.0]]).runs()
    assert runs == [(0, 2, "1-1-0"), (2, 3, "1-0-0")]


def test_directions_are_read_from_a_dataset() -> None:
    made = dataset()
    found = swept(made)
    assert [b.direction for b in found] == ["cold", "up", "down"]
    assert axis_name(made) == "omega"
    assert found[1].labels == tuple(made["label"].sel(direction="up").values)
    # Going up the impact-free motion is kept where the cold start already finds another one.
    assert differs(found[1], found[0]).any()


def test_points_not_computed_are_left_out() -> None:
    made = dataset().copy(deep=True)
    made["label"].values[0, 2] = ""
    cold = swept(made)[0]
    assert len(cold.values) == len(made["omega"]) - 1
    assert made["omega"].values[2] not in cold.values


def test_a_dataset_without_directions_is_refused() -> None:
    with pytest.raises(UnknownNameError):
        swept(xr.Dataset({"label": ("omega", np.array(["1-0-0"]))}))


@pytest.mark.parametrize(
    ("label", "kind"),
    [
        ("1-0-0", FREE),
        ("1-0", FREE),
        ("3-2-0", DRIVE),
        ("6-6-1", BACK),
        ("aperiodic", APERIODIC),
        ("unresolved", UNRESOLVED),
        ("", UNRESOLVED),
    ],
)
def test_regimes(label: str, kind: object) -> None:
    assert regime(read_label(label)) is kind


def test_labels_print_as_in_the_article() -> None:
    assert [short(read_label(x)) for x in ("1-1-0", "6-6-1", "10-10-10", "aperiodic")] == [
        "1-1",
        "6-6-1",
        "10-10-10",
        "aperiodic",
    ]


def test_points_pair_values_with_finite_entries() -> None:
    one = one_way(("2-1-0", "1-1-0"), [[1.0, 2.0], [3.0, NAN]])
    x, y = one.points("strobes")
    assert x.tolist() == [0.0, 0.0, 1.0]
    assert y.tolist() == [1.0, 2.0, 3.0]
    kept, _ = replace(one).points("strobes", np.array([False, True]))
    assert kept.tolist() == [1.0]
