"""A page as HTML: one file, no request to any host, legible without scripts and on paper."""

from __future__ import annotations

import re
from collections.abc import Mapping

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from .blocks import Page
from .svg import inline

_INDEX = re.compile(r"(?<![\w.])([A-Za-zΑ-ω])_([A-Za-zα-ω0-9]{1,2}|red)(?![A-Za-z0-9_])")


def subscripts(text: str) -> Markup:
    """Plain text, escaped, with the index of a symbol such as σ_t set low."""
    return Markup(_INDEX.sub(r"\1<sub>\2</sub>", str(escape(text))))


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
    environment.filters["subscripts"] = subscripts

    def picture(stem: str, name: str, alternative: str) -> Markup:
        return inline(figures[stem], name, alternative)

    template = environment.get_template("page.html.j2")
    return template.render(page=page, picture=picture, folder=folder)
