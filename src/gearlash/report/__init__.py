"""Reports: what a study found as one offline page, with its figures and numbers beside it.

page = Page("Title", "subtitle", (Section("one", "First part", (Text.of("A sentence."),)),))
write_report(page, [Picture("sweep", plots.diagram, (dataset,))], numbers, "folder")
"""

from .blocks import (
    Badge,
    Bullets,
    Figure,
    Marked,
    Note,
    Page,
    Ref,
    Section,
    Strong,
    Table,
    Text,
)
from .data import as_json
from .folder import write_report
from .pictures import Picture

__all__ = [
    "Badge",
    "Bullets",
    "Figure",
    "Marked",
    "Note",
    "Page",
    "Picture",
    "Ref",
    "Section",
    "Strong",
    "Table",
    "Text",
    "as_json",
    "write_report",
]
