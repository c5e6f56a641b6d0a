"""Reports: what a study found as one offline page, with its figures and numbers beside it."""

from .data import as_json
from .render import render

__all__ = ["as_json", "render"]
