"""Reports: what a study found as one offline page, with its figures and numbers beside it."""

from .data import as_json
from .folder import write_report

__all__ = ["as_json", "write_report"]
