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
        "Axis",
        "Beside",
        "BesideMotion",
        "ImpactFree",
        "Passed",
        "Path",
        "PlaneMap",
        "Point",
        "Sweep",
        "coexisting",
        "content_hash",
        "load_dataset",
        "plane_dataset",
        "same_motion",
        "save_dataset",
        "sweep_dataset",
        "table",
    },
    "studies": {
        "Interval",
        "Physical",
        "Quiet",
        "Sampled",
        "ZoneMotion",
        "Transition",
        "Zone",
        "ZoneEnd",
        "Zones",
        "transitions",
        "zones",
    },
}
