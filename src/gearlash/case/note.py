"""A remark on one value of a case."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Note:
    """A remark on one value of a case, as `Case.notes` returns them; shown, never used.

    Attributes
    ----------
    path : str
        Of the value, as in a file.
    text : str
        A sentence.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.load_case("article").notes()[0].path
    'mesh.mean_stiffness'
    """

    path: str
    text: str
