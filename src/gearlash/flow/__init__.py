"""The exact flow: cell propagators, contact events, marching, variational flow."""

from .events import Events, Extrema, Samples, Trace
from .march import Carried, Hold, Strobes, carry, march, trace, variational
from .propagators import Propagators, propagators

__all__ = [
    "Carried",
    "Events",
    "Extrema",
    "Hold",
    "Propagators",
    "Samples",
    "Strobes",
    "Trace",
    "carry",
    "march",
    "propagators",
    "trace",
    "variational",
]
