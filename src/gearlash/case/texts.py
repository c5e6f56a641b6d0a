"""Texts of a case (name, description, source, reasons): what may stand in them.

They reach terminals, HTML, JSON, NetCDF and figures. Each of those escapes them; characters that can only
deceive or break a reader (terminal control sequences, text that runs backwards, halves of characters) are
refused at the door.
"""

from __future__ import annotations

import re

FORBIDDEN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028-\u202e\u2066-\u2069\ud800-\udfff]")
"""Control characters but tab and line end, direction overrides and isolates, separators, surrogates."""

LONGEST_NAME = 200
EXPECTED = "a text without control characters"
EXPECTED_NAME = f"a name in one line of at most {LONGEST_NAME} characters"


def refused(text: str) -> str | None:
    """What is expected instead of this text, or None if it may stand."""
    found = FORBIDDEN.search(text.replace("\r\n", "\n"))
    return None if found is None else f"{EXPECTED} (there is U+{ord(found[0]):04X})"


def refused_name(text: str) -> str | None:
    """The same for a name."""
    if len(text) > LONGEST_NAME or "\n" in text:
        return EXPECTED_NAME
    return refused(text)


def name_of_file(stem: str) -> str:
    """A name for a case that has none, after its file, whatever that is called."""
    return FORBIDDEN.sub("\ufffd", " ".join(stem.split()))[:LONGEST_NAME] or "case"
