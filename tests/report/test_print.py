"""A report on paper: sheets are full, and nothing is cut."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
from playwright.sync_api import sync_playwright

import gearlash as gl
from gearlash.jobs import Execution
from gearlash.orbits import Settings
from gearlash.report.pair import Contents, render
from gearlash.report.pair.planes import STAGES, plane_over
from gearlash.results import Axis
from gearlash.results.pair_question import speeds_around
from gearlash.studies.assessment import assess
from gearlash.studies.speed_run import histories, speed_run
from tools.look import BROWSERS

CASES = Path(__file__).resolve().parents[1] / "cases"
BROWSER = next(filter(None, map(shutil.which, BROWSERS)), None)
HEIGHT, MARGIN = 297.0, 14.0  # mm: of a sheet, of its margins above and below
WIDE, BESIDE = 210.0, 13.0  # mm: of a sheet, of its margins left and right
MOST_EMPTY = 0.15  # of the height between the margins
FAINTEST = 0.98  # of white: paper
HEIGHTS = "all => all.map(one => one.getBoundingClientRect().height)"

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(BROWSER is None, reason="no Chromium on this system"),
    pytest.mark.skipif(shutil.which("pdftoppm") is None, reason="no pdftoppm (poppler) on this system"),
]


def page_of(name: str, count: int, folder: Path) -> Path:
    """A whole report of a case, at fewer speeds than usual."""
    case = gl.load_case(CASES / name)
    values = speeds_around(case, count).values
    axis = Axis.even("omega", float(values[0]), float(values[-1]), count)
    found = assess(case, axis)
    run = speed_run(found.case, axis)
    maps = {}
    for each in STAGES:
        made = plane_over(found, each, Settings(), Execution(), lambda stage, progress: None)
        assert made is not None
        maps[each] = made
    return render(Contents(found, run, histories(found, run), maps), folder)


def printed(page: Path, folder: Path) -> tuple[list[np.ndarray], list[float], str]:
    """Sheets as grey pictures, heights of figures in print (mm), and all that is written."""
    pdf = folder / "report.pdf"
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=BROWSER, args=["--no-sandbox"])
        shown = browser.new_page(viewport={"width": round((WIDE - 2 * BESIDE) / 25.4 * 96), "height": 1000})
        shown.goto(page.resolve().as_uri())
        shown.emulate_media(media="print")
        heights = shown.eval_on_selector_all(
            "figure", "all => all.map(f => f.getBoundingClientRect().height)"
        )
        shown.pdf(path=pdf, prefer_css_page_size=True)
        browser.close()
    subprocess.run(["pdftoppm", "-r", "50", "-gray", "-png", str(pdf), str(folder / "sheet")], check=True)
    text = subprocess.run(["pdftotext", "-layout", str(pdf), "-"], check=True, capture_output=True).stdout
    sheets = [
        np.atleast_3d(matplotlib.image.imread(path))[..., 0] for path in sorted(folder.glob("sheet-*.png"))
    ]
    return sheets, [25.4 / 96 * height for height in heights], text.decode()


@pytest.mark.parametrize(("name", "count"), [("drive.toml", 41), ("drawing.toml", 21)])
def test_no_sheet_but_the_last_is_half_empty_and_nothing_is_cut(name: str, count: int, tmp_path: Path):
    page = page_of(name, count, tmp_path / "report")
    sheets, figures, text = printed(page, tmp_path)
    assert len(sheets) >= 4
    for number, sheet in enumerate(sheets, 1):
        ink = np.flatnonzero((sheet < FAINTEST).any(axis=1)) / sheet.shape[0] * HEIGHT
        across = np.flatnonzero((sheet < FAINTEST).any(axis=0)) / sheet.shape[1] * WIDE
        empty = (HEIGHT - MARGIN - ink.max()) / (HEIGHT - 2 * MARGIN)
        assert number == len(sheets) or empty < MOST_EMPTY, (number, empty)
        assert ink.min() > MARGIN - 1.0
        assert ink.max() < HEIGHT - MARGIN + 1.0
        assert across.min() > BESIDE - 1.0, number
        assert across.max() < WIDE - BESIDE + 1.0, number
    assert len(figures) >= 6
    assert max(figures) < HEIGHT - 2 * MARGIN  # none is higher than a sheet, where it would be cut
    written = re.findall(r"Figure (\d+)\. ", text)
    assert sorted(set(map(int, written))) == list(range(1, len(figures) + 1))
