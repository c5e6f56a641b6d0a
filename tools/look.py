"""The report as pictures: `python -m tools.look` writes its pages and figures as numbered PNGs
into ./look.

Uses a Chromium of the system, and pdftoppm (poppler) for the pages where there is one; without it the pages
are sections photographed one by one. Nothing is fetched.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image, ImageChops

from gearlash.system import GearlashError

REPORT = Path("reproduce") / "report.html"
TARGET = Path("look")
BROWSERS = (
    "chromium",
    "chromium-browser",
    "google-chrome-stable",
    "google-chrome",
    "chrome",
    "microsoft-edge",
)
MISSING = (
    "no Chromium found (looked for: {names}).\n"
    "Install one (Debian and Ubuntu: apt-get install chromium) and run `make look` again."
)
DPI = 110  # of pages
WIDTH = 1500  # pixels of a figure
PAGE_WIDTH, PAGE_HEIGHT, TALLEST = 1240, 1754, 12_000  # pixels of a photographed section and of its pieces
SECONDS = 180


def main() -> int:
    """Writes ./look; returns 1 with a sentence where the report or a browser is missing."""
    if not REPORT.is_file():
        return _fail(f"{REPORT} is missing: run `make reproduce` (gearlash reproduce --out reproduce) first")
    browser = next((found for name in BROWSERS if (found := shutil.which(name))), None)
    if browser is None:
        return _fail(MISSING.format(names=", ".join(BROWSERS)))
    shutil.rmtree(TARGET, ignore_errors=True)
    TARGET.mkdir()
    with tempfile.TemporaryDirectory() as work:
        try:
            pages = write_pages(browser, REPORT, TARGET, Path(work))
            figures = write_figures(browser, REPORT.parent / "figures", TARGET, Path(work))
        except (subprocess.SubprocessError, OSError) as error:
            return _fail(f"{Path(browser).name} failed: {error}")
    print(f"{TARGET}: {pages} pages, {figures} figures")
    return 0


def write_pages(browser: str, report: Path, target: Path, work: Path) -> int:
    """Pages ``page-01.png``, ...: of the printed report, or of its sections."""
    if shutil.which("pdftoppm") is None:
        return _write_sections(browser, report, target, work)
    printed = work / "report.pdf"
    _run(browser, work, "--no-pdf-header-footer", f"--print-to-pdf={printed}", report.resolve().as_uri())
    subprocess.run(
        ["pdftoppm", "-r", str(DPI), "-png", str(printed), str(work / "page")], check=True, timeout=SECONDS
    )
    return _numbered([Image.open(path) for path in sorted(work.glob("page-*.png"))], target, "page")


def write_figures(browser: str, folder: Path, target: Path, work: Path) -> int:
    """Figures ``figure-01-name.png``, ... from the SVG files."""
    paths = sorted(folder.glob("*.svg"))
    for i, path in enumerate(paths, start=1):
        width, height = size(path.read_text(encoding="utf-8"))
        picture = work / "figure.png"
        window = f"--window-size={WIDTH},{round(WIDTH * height / width)}"
        page = work / "figure.html"
        page.write_text(
            f'<body style="margin:0"><img src="{path.resolve().as_uri()}" style="width:100%;display:block">',
            encoding="utf-8",
        )
        _run(browser, work, window, f"--screenshot={picture}", page.as_uri())
        shutil.move(picture, target / f"figure-{i:02d}-{path.stem}.png")
    return len(paths)


def size(svg: str) -> tuple[float, float]:
    """Width and height of a drawing, from its view box. Raises `ValueError` for one without."""
    found = re.search(r'viewBox="[-0-9.]+ [-0-9.]+ ([0-9.]+) ([0-9.]+)"', svg)
    if found is None:
        raise GearlashError("an SVG file without a view box")
    return float(found[1]), float(found[2])


def sections_of(html: str) -> list[str]:
    """The report as pages of one top-level section each, and one of what comes before them."""
    head, _, rest = html.partition("<main>")
    parts = re.split(r"(?=<section\b[^>]*>\s*<h2>)", rest.partition("</main>")[0])
    style = head.partition("<body>")[0]
    return [head, *(f"{style}<body><main>{part}</main>" for part in parts if part.strip())]


def _write_sections(browser: str, report: Path, target: Path, work: Path) -> int:
    pieces: list[Image.Image] = []
    for i, part in enumerate(sections_of(report.read_text(encoding="utf-8"))):
        page, picture = work / f"section-{i:02d}.html", work / f"section-{i:02d}.png"
        page.write_text(part, encoding="utf-8")
        _run(browser, work, f"--window-size={PAGE_WIDTH},{TALLEST}", f"--screenshot={picture}", page.as_uri())
        pieces += _cut(Image.open(picture).convert("RGB"))
    return _numbered(pieces, target, "page")


def _cut(picture: Image.Image) -> list[Image.Image]:
    """The part that is not blank below, in pieces of a page's height."""
    box = ImageChops.difference(picture, Image.new("RGB", picture.size, "white")).getbbox()
    bottom = min(picture.height, (box[3] if box else 0) + 24)
    return [
        picture.crop((0, top, picture.width, min(top + PAGE_HEIGHT, bottom)))
        for top in range(0, bottom, PAGE_HEIGHT)
    ]


def _numbered(pictures: list[Image.Image], target: Path, name: str) -> int:
    for i, picture in enumerate(pictures, start=1):
        picture.save(target / f"{name}-{i:02d}.png")
    return len(pictures)


def _run(browser: str, work: Path, *arguments: str) -> None:
    """One headless call with a profile of its own; the sandbox is off because containers often allow none."""
    flags = (
        "--headless=new",
        "--no-sandbox",
        "--disable-gpu",
        "--hide-scrollbars",
        "--force-device-scale-factor=1",
    )
    command = [browser, *flags, f"--user-data-dir={work / 'profile'}", *arguments]
    subprocess.run(command, check=True, timeout=SECONDS, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def _fail(message: str) -> int:
    print(f"make look: {message}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
