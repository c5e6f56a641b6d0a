"""Attractors and what they are: sections, signature, periodic orbits, multipliers, exponents, grazing
conditions."""

from gearlash.system import Signature

from .attractor import attractor
from .certificate import Certificate, Verdict
from .floquet import multipliers
from .grazing import GrazingCheck, GrazingConditions, grazing_checks
from .lyapunov import Exponents, lyapunov
from .results import Aperiodic, Attractor, Neutral, Orbit, Unresolved
from .sections import Section, Sections, sections
from .settings import Settings
from .shooting import Shot, shoot
from .solve import orbit_at
from .statistics import ForceStatistics, MotionStatistics, motion_statistics

__all__ = [
    "Aperiodic",
    "Attractor",
    "Certificate",
    "Exponents",
    "ForceStatistics",
    "GrazingCheck",
    "GrazingConditions",
    "MotionStatistics",
    "Neutral",
    "Orbit",
    "Section",
    "Sections",
    "Settings",
    "Shot",
    "Signature",
    "Unresolved",
    "Verdict",
    "attractor",
    "grazing_checks",
    "lyapunov",
    "motion_statistics",
    "multipliers",
    "orbit_at",
    "sections",
    "shoot",
]
