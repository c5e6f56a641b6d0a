"""Public names whose docstrings have not the form of numpydoc yet, by room: the list only gets shorter."""

from __future__ import annotations

UNDOCUMENTED: dict[str, set[str]] = {
    "branches": {
        "BifurcationPoint",
        "GrazingPoint",
        "locate_grazing",
        "locate_multiplier",
    },
    "results": {
        "Beside",
        "BesideMotion",
        "PlaneMap",
        "Point",
        "Sweep",
        "sweep_dataset",
    },
    "studies": {
        "Interval",
        "Physical",
        "Quiet",
        "Sampled",
        "Transition",
        "Zone",
        "ZoneEnd",
        "ZoneMotion",
        "Zones",
        "transitions",
        "zones",
    },
}
