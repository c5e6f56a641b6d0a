"""From a start to the attractor that it runs into."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.flow import Propagators, propagators_of
from gearlash.flow.march import LONGEST_STRETCH, start_state
from gearlash.system import GearlashError, System, given, shown

from .results import Attractor
from .search import Search
from .settings import Settings

Array = NDArray[np.float64]
DEFAULT = Settings()


def attractor(
    system: System | Propagators,
    start: ArrayLike,
    settings: Settings = DEFAULT,
    trial: tuple[ArrayLike, int] | None = None,
) -> Attractor:
    """The attractor that a motion runs into.

    A periodic orbit is accepted only if it is stable and the motion is seen to approach it. So a slow
    transient goes on: it is neither called periodic with a wrong P nor aperiodic.

    Parameters
    ----------
    system : System or Propagators
    start : array_like of shape (n,)
        State at phase zero from which the motion starts.
    settings : Settings
        How the attractor is looked for, and for how long.
    trial : (array_like of shape (n,), int), optional
        State and base periods of a periodic orbit to try first: the neighbour's, where an attractor is
        followed in a parameter. If it is stable it is the answer.

    Returns
    -------
    Orbit, Aperiodic, Neutral or Unresolved
        A periodic orbit with its least period (residual at most 1e-11, stable); a motion that does not
        repeat; one of a continuum of motions, none of which attracts; or what is known where nothing was
        settled within the budget. Each has a ``status``, which is to be read first.

    Raises
    ------
    GearlashError
        For arguments that do not fit, and for a system whose tables would not fit the memory.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> found = gl.attractor(family.system({"omega": 0.8}), family.start())
    >>> str(found.status), str(found.label), round(abs(found.leading), 4)
    ('ok', '1-0-0', 0.6752)
    """
    props = propagators_of(system)
    given.instance("settings", settings, Settings, "Settings, such as gearlash.Settings(max_period=128)")
    search = Search(props, settings, start_state(props, start))
    if trial is not None:
        found = search.attempt(*_trial(props, trial, settings))
        if found is not None and found.attracts:
            return found
    return search.run()


def _trial(props: Propagators, trial: Any, settings: Settings) -> tuple[Array, int]:
    """A state and the base periods after which it is expected back."""
    parts = given.items("trial", trial, "a state and a number of base periods")
    if len(parts) != 2:
        raise GearlashError(f"trial = {shown(trial)}: expected a state and a number of base periods")
    return start_state(props, parts[0]), given.whole("period of the trial", parts[1], 1, LONGEST_STRETCH)
