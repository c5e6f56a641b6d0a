"""Maps drawn: a look for every motion, names inside their regions."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.patches import PathPatch

from gearlash import plots
from gearlash.plots import style
from gearlash.plots.fills import NONE, fills
from gearlash.plots.plane import HEIGHT, WIDTH, rooms
from gearlash.plots.regimes import BACK, DRIVE, FREE, UNRESOLVED, Regime, regime
from gearlash.system import MotionKind, Signature, UnknownNameError, read_label
from plots.made import dataset, plane


def lightness(colour: str) -> float:
    """L* of CIE 1976, from the luminance of sRGB."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in to_rgb(colour)]
    luminance = float(np.dot([0.2126, 0.7152, 0.0722], linear))
    return 116.0 * np.cbrt(luminance) - 16.0 if luminance > 0.008856 else 903.3 * luminance


def test_the_kind_counts_all_clearances():
    def kind(label: str) -> Regime:
        return regime(read_label(label))

    assert kind("1-0-0") is kind("1-0-0/0-0") is FREE
    assert kind("2-1-0") is kind("1-0-0/1-0") is DRIVE
    assert kind("unresolved") is kind("") is UNRESOLVED
    assert kind("2-1-1") is kind("1-1-0/0-1") is BACK


@pytest.mark.parametrize("count", ["{0}-{0}-0", "{0}-{0}-1"])
def test_frequent_labels_differ_in_a_grey_print_and_the_rest_share_one_look(count: str):
    labels = [read_label(count.format(p)) for p in range(1, 9)]
    found = [fills(labels)[label] for label in labels]
    shades = sorted(lightness(fill.colour) for fill in found[:5])
    assert np.diff(shades).min() > 9.0
    assert len(set(found[5:])) == 1
    assert found[5].words.startswith("other, ")


def test_a_label_looks_the_same_in_most_maps():
    """Whatever else occurs there, and how often."""
    first, second, third, fourth = map(read_label, ("1-1-0", "2-2-0", "4-4-2", "3-3-0"))
    one, other = fills([first, second, third]), fills([fourth, second, third, first])
    for label in (first, second, third):
        assert one[label] == other[label]


def test_a_map_says_what_it_is_of():
    made = plots.plane(plane(), plots.Units())
    [legend] = made.legends
    assert "Q impacts on the drive side" in legend.get_title().get_text()
    data = plane().copy()  # one for all tests
    data.attrs |= {"case_name": "own$", "parameters": '{"load": 0.25, "mass": 3.0, "D": 1.0}', "fixed": "{}"}
    assert plots.plane(data).axes[0].get_title(loc="left") == r"own\$,  $f_m$ = 0.25"
    data["label_name"] = [
        f"{name}/0-1" if "-" in name else name for name in map(str, data["label_name"].values)
    ]
    assert "of every gap in turn" in plots.plane(data).legends[0].get_title().get_text()
    data.attrs["fixed"] = '{"mass": 3.0}'
    assert plots.plane(data).axes[0].get_title(loc="left") == r"own\$,  $f_m$ = 0.25,  mass = 3"


def test_a_map_asked_in_units_has_them_as_its_own_axes_and_marks_the_others():
    own = plots.Twin(3820.0, "pinion speed", "rpm", assumed=True)
    data = plane()
    x, y = data.attrs["x"], data.attrs["y"]
    units = plots.Units(speed=own if x == "omega" else None, others={x: own, y: own})
    asked = plots.Twin(3820.0, "pinion speed", "rpm")
    (panel,) = plots.plane(data, units, along=(asked, asked)).axes
    said = [axis.label.get_text() for child in panel.child_axes for axis in (child.xaxis, child.yaxis)]
    said = [text for text in said if text]
    assert said.count("pinion speed  [rpm]") == 2
    assert len(said) == 4
    assert sum(text.endswith("†") for text in said) == 2
    (panel,) = plots.plane(data, units).axes
    assert "†" not in panel.get_xlabel() + panel.get_ylabel()


def test_text_can_be_read_on_its_fill():
    orbits = [Signature(p, 1, r) for p in range(1, 9) for r in (0, 1)]
    everything = fills([*orbits, Signature(1, 0), MotionKind.APERIODIC])
    for fill in everything.values():
        assert abs(lightness(fill.colour) - lightness(fill.ink)) > 35.0, fill


def test_a_name_stands_inside_its_region_or_not_at_all():
    mask = np.zeros((20, 30), dtype=bool)
    mask[2:18, 3:7] = True  # tall, 4 pixels wide
    mask[10, 20] = True
    edges = np.arange(31.0), np.arange(21.0)
    wide = 4 * WIDTH / 30
    [(x, y)] = rooms(edges, mask, 0.35 * wide)
    assert 3.0 < x < 7.0
    assert y == pytest.approx(10.0, abs=1.0)
    assert list(rooms(edges, mask, 0.55 * wide)) == []
    assert HEIGHT < WIDTH


def test_failed_and_impact_free_pixels_are_hatched():
    made = plots.plane(plane(), plots.Units())
    hatches = {p.get_hatch() for p in made.axes[0].patches if isinstance(p, PathPatch)}
    assert {NONE.hatch, "////"} <= hatches
    [legend] = made.legends
    texts = [text.get_text() for text in legend.get_texts()]
    assert texts[0] == "no impacts"
    assert {"aperiodic", NONE.words} <= set(texts)
    assert len(texts) == len(set(texts))
    assert pytest.approx(made.get_figwidth() * 25.4) == style.PAGE


def test_a_sweep_is_no_map():
    with pytest.raises(UnknownNameError, match="label_name"):
        plots.plane(dataset())
