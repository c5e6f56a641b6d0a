"""What a user writes: case files with units, provenance and named problems, and the cases that come along.

case = load("article", {"pinion_speed": "3600 rpm"})
family, scales = case.family()
"""

from .case import Case, load, loads
from .entries import Entry
from .errors import CaseError, Problem
from .note import Note
from .read import bundled
from .scales import Scales
from .stated import Provenance
from .value import Value

__all__ = [
    "Case",
    "CaseError",
    "Entry",
    "Note",
    "Problem",
    "Provenance",
    "Scales",
    "Value",
    "bundled",
    "load",
    "loads",
    "schema",
]


def schema() -> dict[str, object]:
    """JSON Schema (2020-12) of case files."""
    from .fileschema import schema as built  # late: needs pydantic

    return built()
