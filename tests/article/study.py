"""A small reproduction of the article, computed once a process."""

from __future__ import annotations

from functools import cache

from gearlash.article import Reproduction, Scope, reproduce
from gearlash.case import load


@cache
def small() -> Reproduction:
    """Few values on short axes: both ends of the window are in it, the events in D are not."""
    scope = Scope(omega=(0.96, 1.14, 10), backlash=(0.44, 0.5, 4), rules_backlash=(0.385, 0.44, 0.5))
    return reproduce(load("article"), scope, workers=0)
