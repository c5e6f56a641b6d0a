"""Which figure of a signal a column holds, as its name or its unit says: ``TE rms [um]``, ``µm p-p``."""

from __future__ import annotations

import re

FIGURES = {
    "peak-to-peak": r"peak[\s-]*to[\s-]*peak|p(?:ea)?k?\s*[-–/]\s*p(?:ea)?k?|pk\s?pk|p2p|ptp|pp"
    r"|spitze[\s-]*(?:zu[\s-]*)?spitze",
    "rms": r"rms|r\.m\.s\.?|eff(?:ektiv(?:wert)?)?\.?|quadratic mean",
    "mean": r"mean|average|avg|mittel(?:wert)?",
    "peak": r"(?:0|zero)[\s-]*(?:to[\s-]*)?p(?:ea)?k|peak|pk|spitze(?:nwert)?|scheitel(?:wert)?",
}
"""Words by figure; the first that fits holds."""
_WORDS = {
    figure: re.compile(rf"(?<![^\W_])(?:{words})(?![^\W_])", re.IGNORECASE)
    for figure, words in FIGURES.items()
}


def figure_in(text: str) -> str:
    """The figure that a text names; empty where it names none."""
    return next((figure for figure, words in _WORDS.items() if words.search(text)), "")


def without_figure(unit: str) -> str:
    """A unit without the figure beside it: ``µm`` of ``µm p-p``."""
    for words in _WORDS.values():
        bare = words.sub("", unit).strip(" ,;()")
        if bare and bare != unit:
            return bare
    return unit
