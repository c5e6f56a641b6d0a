"""The report of a gear pair of one's own: a verdict first, then what it rests on."""

from .contents import Contents
from .document import document
from .files import data_files, file_names
from .rendering import render
from .verdict import Line, Verdict, verdict
from .whole import PairReport, pair_report

__all__ = [
    "Contents",
    "Line",
    "PairReport",
    "Verdict",
    "data_files",
    "document",
    "file_names",
    "pair_report",
    "render",
    "verdict",
]
