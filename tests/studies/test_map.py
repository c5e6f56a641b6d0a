"""Maps: the same bytes however they are computed, what a pixel is, flags, early ends, memory."""

from __future__ import annotations

import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from gearlash import case, studies
from gearlash.jobs import Execution, Progress
from gearlash.results import (
    CERTIFICATES,
    NO_LABEL,
    STATUSES,
    Axis,
    PlaneMap,
    content_hash,
    load,
    plane_dataset,
    save,
)
from gearlash.studies import Settings, map_plane
from gearlash.studies.model import Source
from gearlash.studies.pixels import Stretch, record_kind, work
from gearlash.system import Family, GearlashError, Parameter, Signature, Status

ARTICLE = case.load("article-first-harmonic")
CLASSICAL = case.load("kahraman-singh")
SPEEDS, GAPS = Axis.even("omega", 0.7, 0.86, 5), Axis.even("D", 0.33, 0.62, 6)
SETTINGS = Settings(patience=300, budget=2_000, exponent_periods=400)
GIB = 2**30


@pytest.fixture(scope="module")
def plane() -> PlaneMap:
    return map_plane(ARTICLE, SPEEDS, GAPS, settings=SETTINGS)


def digest(found: PlaneMap) -> str:
    return content_hash(plane_dataset(ARTICLE, found))


def test_a_pixel_is_the_point_of_the_study(plane: PlaneMap):
    """Label, counts, exponent, certificate: as `point` has them, which keeps far more and traces for it."""
    family = ARTICLE.family()[0]
    assert plane.shape == (6, 5)
    assert plane.complete
    assert "aperiodic" in plane.labels
    assert plane.back.any()
    for row, column in product(range(6), range(5)):
        values = {"omega": SPEEDS.values[column], "D": GAPS.values[row]}
        point = studies.point(family, values, settings=SETTINGS)
        at = row, column
        assert plane.label_at(*at) == point.label, values
        counts = tuple(int(a[at]) for a in (plane.period, plane.drive, plane.back, plane.others))
        assert counts == (point.period, point.drive, point.back, 0)
        assert plane.periods[at] == point.periods_used
        assert STATUSES[plane.status[at]] == point.status
        assert CERTIFICATES[plane.certificate[at]] == point.certificate
        assert plane.exponent[at] == point.largest_exponent


@pytest.mark.parametrize("chunk", [1, 4, 100])
def test_any_cut_gives_the_same_bytes(plane: PlaneMap, chunk: int):
    assert digest(
        map_plane(ARTICLE, SPEEDS, GAPS, settings=SETTINGS, execution=Execution(chunk=chunk))
    ) == digest(plane)


def test_threads_give_the_same_bytes(plane: PlaneMap):
    with ThreadPoolExecutor(3) as executor:
        again = map_plane(ARTICLE, SPEEDS, GAPS, settings=SETTINGS, execution=Execution(executor, chunk=2))
    assert digest(again) == digest(plane)


def test_processes_give_the_same_bytes(plane: PlaneMap):
    seen: list[Progress] = []
    with studies.open_workers(ARTICLE, 2) as executor:
        for chunk in (None, 5):
            again = map_plane(
                ARTICLE,
                SPEEDS,
                GAPS,
                settings=SETTINGS,
                execution=Execution(executor, chunk=chunk, progress=seen.append),
            )
            assert digest(again) == digest(plane)
    assert (seen[-1].done, seen[-1].remaining) == (30, 0.0)


def test_axes_may_change_places(plane: PlaneMap):
    """Lines run along D, where propagators are used again, whichever axis it is."""
    turned = map_plane(ARTICLE, GAPS, SPEEDS, settings=SETTINGS)
    assert turned.labels == plane.labels
    for name, array in turned.arrays.items():
        assert array.T.tobytes() == plane.arrays[name].tobytes(), name


def test_a_million_pixels_stay_below_a_gibibyte(plane: PlaneMap):
    """The arrays, a table of records of the same kind, and every pixel as it waits to be put into them."""
    each = plane.nbytes / (plane.shape[0] * plane.shape[1])
    assert each == 2 + 4 * 4 + 8 + 4 + 1 + 1
    part = work(Stretch(Source.of(ARTICLE), (("omega", 1.0),), "D", (0.5,), None, SETTINGS), None)
    pixel = part.results[0]
    waiting = sys.getsizeof(pixel) + sys.getsizeof(pixel.record)
    placed = (
        sys.getsizeof((0, 0)) + 2 * sys.getsizeof(1) + 100
    )  # its place and its entry in a table of places
    assert 1_000_000 * (each + record_kind(1).itemsize + waiting + placed) < GIB


def test_a_pixel_that_fails_is_flagged_and_the_map_goes_on():
    gaps = Axis("D", np.array([-0.5, 0.5, 1.0]))
    found = map_plane(CLASSICAL, Axis.even("omega", 0.6, 0.9, 4), gaps)
    assert found.complete
    assert [STATUSES[code] for code in found.status[:, 2]] == [Status.FAILED, "ok", "ok"]
    assert found.statuses == {Status.FAILED: 4, "ok": 8}
    assert found.certificates["failed"] == 4
    assert set(found.reasons) == {(0, column) for column in range(4)}
    assert "D" in found.reasons[0, 3]
    assert (found.label[0] == NO_LABEL).all()
    assert np.isnan(found.exponent[0]).all()
    assert np.isfinite(found.exponent[1:]).all()


def test_a_map_of_failures_only():
    found = map_plane(CLASSICAL, SPEEDS, Axis("D", np.array([-2.0, -1.0])))
    assert found.complete
    assert found.statuses == {Status.FAILED: 10}
    assert (found.labels, found.shares) == ((), {})


def test_cancel_keeps_what_was_computed():
    cancel = threading.Event()

    def after_nine(progress: Progress) -> None:
        if progress.done >= 9:
            cancel.set()

    found = map_plane(
        CLASSICAL, SPEEDS, GAPS, execution=Execution(progress=after_nine, cancel=cancel, chunk=3)
    )
    assert (found.complete, found.message, found.computed) == (False, "cancelled", 9)
    assert found.statuses == {Status.NOT_COMPUTED: 21, "ok": 9}
    assert plane_dataset(CLASSICAL, found).attrs["complete"] == 0


def test_ctrl_c_keeps_what_was_computed():
    def interrupt(progress: Progress) -> None:
        if progress.done == 3:
            raise KeyboardInterrupt

    found = map_plane(CLASSICAL, SPEEDS, GAPS, execution=Execution(progress=interrupt, chunk=3))
    assert (found.complete, found.message, found.computed) == (False, "interrupted", 3)


def test_names_and_starts_are_checked_before_anything_runs():
    with pytest.raises(GearlashError, match="did you mean 'omega'"):
        map_plane(CLASSICAL, Axis("omgea", np.array([1.0])), GAPS)
    with pytest.raises(GearlashError, match="cannot be fixed as well"):
        map_plane(CLASSICAL, SPEEDS, GAPS, values={"D": 1.0})
    with pytest.raises(GearlashError, match="two different parameters"):
        map_plane(CLASSICAL, SPEEDS, SPEEDS)
    with pytest.raises(GearlashError, match="expected an Axis"):
        map_plane(CLASSICAL, "omega", GAPS)  # pyright: ignore[reportArgumentType]
    with pytest.raises(GearlashError, match="or a Family, not a str"):
        map_plane("article", SPEEDS, GAPS)  # pyright: ignore[reportArgumentType]
    with pytest.raises(GearlashError, match=r"expected \(2,\) \(states: X"):
        map_plane(CLASSICAL, SPEEDS, GAPS, start=[1.0])
    wide, high = Axis("omega", np.linspace(0.9, 1.0, 1_001)), Axis("D", np.linspace(0.5, 1.0, 1_000))
    with pytest.raises(GearlashError, match="1001 × 1000 pixels: a map takes 1,000,000"):
        map_plane(CLASSICAL, wide, high)
    with pytest.raises(GearlashError, match="chunk"):
        map_plane(CLASSICAL, SPEEDS, GAPS, execution=Execution(chunk=0))


def test_several_gaps_have_all_their_counts():
    two = case.load("two-stage")
    names = list(two.family()[0].defaults)
    ends = {name: value for name, value in two.family()[0].defaults.items() if value > 0.0}
    first, second = [name for name in names if name in ends][:2]
    axes = (Axis.even(n, 0.9 * ends[n], 1.1 * ends[n], 3) for n in (first, second))
    found = map_plane(two, *axes)
    periodic = found.period > 0
    assert periodic.any()
    for row, column in np.argwhere(periodic):
        label = found.label_at(row, column)
        assert isinstance(label, Signature)
        assert len(label.others) == 1
        assert found.others[row, column] == sum(map(sum, label.others))


def test_dataset_has_units_codes_and_provenance_and_comes_back(plane: PlaneMap, tmp_path: Path):
    data = plane_dataset(ARTICLE, plane)
    assert dict(data.sizes) == {"omega": 5, "D": 6, "label_name": len(plane.labels)}
    assert data["label"].dims == ("D", "omega")
    named = data["label_name"].values[data["label"].values]
    assert named[2, 3] == plane.label_at(2, 3)
    meanings = data["status"].attrs["flag_meanings"].split()
    assert meanings[int(data["status"].sel(omega=0.7, D=0.33))] == "ok"
    np.testing.assert_allclose(data["pinion_speed"], ARTICLE.scales.pinion_rpm(SPEEDS.values), rtol=1e-14)
    assert data["backlash"].dims == ("D",)
    assert data.attrs["case_hash"] == ARTICLE.hash
    back = load(save(data, tmp_path / "map.nc"))
    assert content_hash(back) == content_hash(data)


def test_a_family_of_ones_own():
    base = CLASSICAL.family()[0]
    family = Family(
        (Parameter("omega", 0.6), Parameter("D", 1.0)),
        base.states,
        base.system,
        lambda values: base.start(values),
    )
    found = map_plane(family, SPEEDS, GAPS)
    whole = map_plane(CLASSICAL, SPEEDS, GAPS)
    assert [a.tobytes() for a in found.arrays.values()] == [a.tobytes() for a in whole.arrays.values()]
    assert "case_hash" not in plane_dataset(family, found).attrs
