"""How far the search for an attractor goes, from what was typed."""

from __future__ import annotations

from dataclasses import replace

from gearlash.orbits import Settings


def search_settings(periods: int | None, max_period: int | None) -> Settings:
    """The defaults, with what was given."""
    settings = Settings()
    if periods is not None:
        settings = replace(settings, budget=periods)
    if max_period is not None:
        settings = replace(settings, max_period=max_period)
    return settings
