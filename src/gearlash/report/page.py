"""A page as HTML: one file, no request to any host, legible without scripts and on paper."""

from __future__ import annotations

from collections.abc import Mapping

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from .blocks import Page
from .svg import inline


def html(page: Page, figures: Mapping[str, bytes], folder: str = "figures") -> str:
    """The page with its figures (SVG files by stem) inside it; ``folder`` is where their files lie beside
    it.
    """
    environment = Environment(
        loader=PackageLoader("gearlash.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["kind"] = lambda block: type(block).__name__

    def picture(stem: str, name: str, alternative: str) -> Markup:
        return inline(figures[stem], name, alternative)

    template = environment.get_template("page.html.j2")
    return template.render(page=page, picture=picture, folder=folder)
