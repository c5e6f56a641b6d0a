"""Drawn figures made ready to stand inside a page."""

from __future__ import annotations

import re

from markupsafe import Markup, escape

from gearlash.plots import style

_PROLOG = re.compile(r"^.*?(?=<svg\b)", re.DOTALL)
_METADATA = re.compile(r"<metadata>.*?</metadata>", re.DOTALL)
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_ID = re.compile(r'\bid="([^"]+)"')
_USED = re.compile(r'(href="#|url\(#)([^")]+)')


_WIDTH = re.compile(r'<svg\b[^>]*?\bwidth="([0-9.]+)pt"')


def inline(svg: bytes, name: str, alternative: str) -> Markup:
    """An SVG file as an element of a page.

    Without prolog, with ids of its own (``name`` in front), a role and words for screen readers; as wide as
    it is on paper, in per cent of a page's text.
    """
    text = _METADATA.sub("", _PROLOG.sub("", svg.decode("utf-8"), count=1))
    text = _COMMENT.sub("", text)
    text = _ID.sub(lambda found: f'id="{name}-{found[1]}"', text)
    text = _USED.sub(lambda found: f"{found[1]}{name}-{found[2]}", text)
    width = _WIDTH.match(text)
    share = min(100.0, 100.0 * float(width[1]) / (style.PAGE * style.MM * 72.0)) if width else 100.0
    head = f'<svg role="img" aria-label="{escape(alternative)}" style="width: {share:.4g}%" '
    return Markup(text.replace("<svg ", head, 1))
