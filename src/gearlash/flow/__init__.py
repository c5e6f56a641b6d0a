"""The exact flow: cell propagators, contact events, marching, variational flow."""

from ._tables import FREE, MINUS, PLUS, ROUGH, TERMS
from .carried import Carried, Hold, Strobes
from .events import Events
from .growth import Growth, growth
from .laps import Lap, chain, lap
from .linear import LinearMotion, linear_motion
from .many import ManyStrobes, march_many
from .march import carry, march, orthonormal_growth, trace, variational
from .propagators import Propagators, propagators, propagators_of
from .traces import Extrema, Samples, Trace

__all__ = [
    "FREE",
    "MINUS",
    "PLUS",
    "ROUGH",
    "TERMS",
    "Carried",
    "Events",
    "Extrema",
    "Growth",
    "Hold",
    "Lap",
    "LinearMotion",
    "ManyStrobes",
    "Propagators",
    "Samples",
    "Strobes",
    "Trace",
    "carry",
    "chain",
    "growth",
    "lap",
    "linear_motion",
    "march",
    "march_many",
    "orthonormal_growth",
    "propagators",
    "propagators_of",
    "trace",
    "variational",
]
