"""Drawn figures made ready to stand inside a page."""

from __future__ import annotations

import re

from markupsafe import Markup, escape

_PROLOG = re.compile(r"^.*?(?=<svg\b)", re.DOTALL)
_METADATA = re.compile(r"<metadata>.*?</metadata>", re.DOTALL)
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_ID = re.compile(r'\bid="([^"]+)"')
_USED = re.compile(r'(href="#|url\(#)([^")]+)')


def inline(svg: bytes, name: str, alternative: str) -> Markup:
    """An SVG file as an element of a page.

    Without prolog, with ids of its own (``name`` in front), a role and words for screen readers.
    """
    text = _METADATA.sub("", _PROLOG.sub("", svg.decode("utf-8"), count=1))
    text = _COMMENT.sub("", text)
    text = _ID.sub(lambda found: f'id="{name}-{found[1]}"', text)
    text = _USED.sub(lambda found: f"{found[1]}{name}-{found[2]}", text)
    label = escape(alternative)
    return Markup(text.replace("<svg ", f'<svg role="img" aria-label="{label}" ', 1))
