"""The report of the article's study: its parts, in the order they are read."""

from .document import document

__all__ = ["document"]
