"""The article's sign of the mesh force: its F is −Φ, negative where the drive side is compressed."""

from gearlash.plots import ForceAxis

FORCE = ForceAxis(r"$F$", -1.0)
"""How the figures of the article's study draw the force on its sections."""
