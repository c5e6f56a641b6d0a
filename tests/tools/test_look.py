"""`make look` without a browser, and the parts of it that need none."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from PIL import Image

from article.study import small
from gearlash.article.report import document
from gearlash.report.page import html
from gearlash.system import GearlashError
from tools import look

DRAWING = b'<svg width="510pt" height="9pt" viewBox="0 0 510 9" xmlns="http://www.w3.org/2000/svg"></svg>'

FAKE = """#!/bin/sh
for argument in "$@"; do
  case "$argument" in
    --screenshot=*) cp "$PICTURE" "${argument#--screenshot=}" ;;
  esac
done
"""


def test_without_a_report_it_says_what_to_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert look.main() == 1
    assert "make reproduce" in capsys.readouterr().err


def test_without_a_browser_it_names_those_it_looked_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "reproduce").mkdir()
    (tmp_path / "reproduce" / "report.html").write_text("<main></main>")
    monkeypatch.setenv("PATH", str(tmp_path))
    assert look.main() == 1
    said = capsys.readouterr().err
    assert "no Chromium found" in said
    assert "google-chrome" in said
    assert not (tmp_path / "look").exists()


@pytest.mark.skipif(os.name == "nt", reason="the stand-in for a browser is a shell script")
def test_pages_and_figures_are_numbered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    figures = tmp_path / "reproduce" / "figures"
    figures.mkdir(parents=True)
    for name in ("b", "a"):
        (figures / f"{name}.svg").write_bytes(DRAWING)
    (tmp_path / "reproduce" / "report.html").write_text("<body><main><section><h2>One</h2></section></main>")
    picture = Image.new("RGB", (look.PAGE_WIDTH, look.TALLEST), "white")
    picture.paste("black", (10, 10, 20, look.PAGE_HEIGHT + 300))
    picture.save(tmp_path / "tall.png")
    tools = tmp_path / "bin"
    tools.mkdir()
    (tools / "chromium").write_text(FAKE)
    (tools / "chromium").chmod(0o755)
    for tool in ("cp", "sh"):
        (tools / tool).symlink_to(Path("/bin") / tool)
    monkeypatch.setenv("PATH", str(tools))
    monkeypatch.setenv("PICTURE", str(tmp_path / "tall.png"))
    assert look.main() == 0
    made = sorted(p.name for p in (tmp_path / "look").iterdir())
    pages = [f"page-{i:02d}.png" for i in range(1, 5)]  # the head and one section, two pieces each
    assert made == ["figure-01-a.png", "figure-02-b.png", *pages]
    with Image.open(tmp_path / "look" / "page-01.png") as first:
        assert first.size == (look.PAGE_WIDTH, look.PAGE_HEIGHT)


def test_a_report_falls_into_its_sections() -> None:
    page, pictures = document(small())
    parts = look.sections_of(html(page, {picture.stem: DRAWING for picture in pictures}))
    assert len(parts) == 1 + len(page.sections)
    for part, section in zip(parts[1:], page.sections, strict=True):
        assert f'<section id="{section.id}">' in part
        assert "<style>" in part


def test_the_size_of_a_drawing_is_that_of_its_view_box() -> None:
    assert look.size('<svg viewBox="0 0 510.24 -9" height="1">'.replace("-9", "300.5")) == (510.24, 300.5)
    with pytest.raises(GearlashError, match="view box"):
        look.size("<svg>")
