"""The exact flow: cell propagators, contact events, marching, variational flow."""

from .events import Events, Extrema, Samples, Trace
from .march import (
    Carried,
    Hold,
    ManyStrobes,
    Strobes,
    carry,
    march,
    march_many,
    orthonormal_growth,
    trace,
    variational,
)
from .propagators import Propagators, propagators

__all__ = [
    "Carried",
    "Events",
    "Extrema",
    "Hold",
    "ManyStrobes",
    "Propagators",
    "Samples",
    "Strobes",
    "Trace",
    "carry",
    "march",
    "march_many",
    "orthonormal_growth",
    "propagators",
    "trace",
    "variational",
]
