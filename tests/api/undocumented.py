"""Public names whose docstrings have not the form of numpydoc yet, by room: the list only gets shorter."""

from __future__ import annotations

UNDOCUMENTED: dict[str, set[str]] = {
    "results": {
        "Beside",
        "BesideMotion",
        "PlaneMap",
        "Point",
        "Sweep",
        "sweep_dataset",
    },
}
