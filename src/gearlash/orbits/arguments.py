"""What callers of this room hand over."""

from __future__ import annotations

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.system import System


def propagators_of(system: System | Propagators) -> Propagators:
    """The propagators of a system, made unless they are what was given."""
    return system if isinstance(system, Propagators) else flow.propagators(system)
