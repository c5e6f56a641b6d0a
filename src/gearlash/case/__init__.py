"""What a user writes: case files with units, provenance and named problems, and the bundled cases.

case = load("article", {"pinion_speed": "3600 rpm"})
family, scales = case.family()
"""

from .case import Case
from .entries import Entry
from .errors import CaseError, Problem
from .loading import load, loads
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
    """JSON Schema of case files, for editors and for tests of generated files.

    Returns
    -------
    dict
        JSON Schema 2020-12 with one variant a kind of case, registered kinds among them.

    Examples
    --------
    >>> from gearlash.case import schema
    >>> sorted(schema()["discriminator"]["mapping"])
    ['helical-pair', 'piecewise-linear', 'spur-1dof']
    """
    from .fileschema import schema as built  # late: needs pydantic

    return built()
