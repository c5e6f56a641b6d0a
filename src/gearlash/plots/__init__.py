"""Figures fit for a publication: vector, labelled with units, legible in grey print.

Each function returns a matplotlib `Figure`, and `save` writes it as SVG and PDF. The same data give the same
bytes.
"""

from .around_point import around_point
from .atlas_diagram import atlas_diagram
from .bifurcation import diagram
from .branch_diagram import branch_diagram
from .curve_diagram import curve_diagram
from .draw import draw
from .force_beside import ForcePanel, force_beside
from .histories import history
from .histories import triple as history_triple
from .intervals import Bar, Panel, zones
from .marks import Mark
from .mesh_drawing import mesh_drawing
from .orders_beside import OrderPanel, orders_beside
from .overlay import overlay
from .plane import plane
from .plane_lines import PlaneLine
from .plane_zoned import zone_in_plane
from .poincare import sections
from .portraits import gallery, portrait
from .portraits import triple as portrait_triple
from .stated_curves import StatedCurve, stated_curves
from .style import save, to_bytes
from .tolerated import tolerance_bands
from .units import ForceAxis, Twin, Units
from .zoned import zone_bands

__all__ = [
    "Bar",
    "ForceAxis",
    "ForcePanel",
    "Mark",
    "OrderPanel",
    "Panel",
    "PlaneLine",
    "StatedCurve",
    "Twin",
    "Units",
    "around_point",
    "atlas_diagram",
    "branch_diagram",
    "curve_diagram",
    "diagram",
    "draw",
    "force_beside",
    "gallery",
    "history",
    "history_triple",
    "mesh_drawing",
    "orders_beside",
    "overlay",
    "plane",
    "portrait",
    "portrait_triple",
    "save",
    "sections",
    "stated_curves",
    "to_bytes",
    "tolerance_bands",
    "zone_bands",
    "zone_in_plane",
    "zones",
]
