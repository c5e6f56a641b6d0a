"""Which points are computed: fixed before the first one is."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearlash.multibody import Relief

from .inputs import Inputs
from .settings import PLANNED, Setting, sensitivity

Array = NDArray[np.float64]
WINDOW = (0.82, 1.14, 17)
"""Speeds of the window over the last one asked for: from, to, how many."""
RIGID = replace(PLANNED, name="rigid gear", flexible=False)
STATED = replace(PLANNED, name="bearings as stated", bearings_as_stated=True)
"""Of inputs that are held so that bearings grow with the mesh."""
DISTANCE_HELD = replace(PLANNED, name="centre distance held", held="centre distance")
"""Beside the planned setting it tells what the breathing of the centre distance does."""
AT_WINDOW = Setting("window", steps=128, finer=1, finest=1, settle=30, read=16, longest=1)
"""Every speed begins from the motion of its neighbour, so that less has to settle."""


@dataclass(frozen=True)
class Configuration:
    """One way to hold the inputs of both models against each other.

    Attributes
    ----------
    name : str
    told : str
        What is held.
    width : float
        Of the teeth, m.
    stiffness : float
        Of the multibody mesh at this width and torque, N/m.
    torque : float
        N·m.
    error : float
        m.
    omegas : tuple of float
        Mesh frequency over √(stiffness/m_e).
    bearings : float
        Stiffness of all bearings over that of the case.
    """

    name: str
    told: str
    width: float
    stiffness: float
    torque: float
    error: float
    omegas: tuple[float, ...]
    bearings: float = 1.0

    def numbers(self, inputs: Inputs) -> dict[str, float]:
        """The dimensionless numbers: E k/F, (b/2) k/F; k and the bearings over those of the case.

        Parameters
        ----------
        inputs : Inputs

        Returns
        -------
        dict of str to float
        """
        force = inputs.mean_force * self.torque / inputs.torque
        return {
            "error over static deflection": self.error * self.stiffness / force,
            "half backlash over static deflection": 0.5 * inputs.backlash * self.stiffness / force,
            "stiffness over that of the case": self.stiffness / inputs.mean_stiffness,
            "bearings over those of the case": self.bearings,
        }


def configurations(
    inputs: Inputs,
    matched: tuple[float, float],
    full: tuple[float, float],
    scaled: tuple[float, float],
    close: bool = True,
) -> tuple[Configuration, ...]:
    """The three configurations.

    Parameters
    ----------
    inputs : Inputs
    matched, full, scaled : (float, float)
        Face width in m and stiffness in N/m: of the width that has the stiffness of the case; of the width of
        the case under its torque; and of this width under a torque that grows with the stiffness.
    close : bool
        Whether the first stiffness is that of the case, or only the nearest that was found.

    Returns
    -------
    tuple of Configuration
    """
    grown = scaled[1] / inputs.mean_stiffness
    width = "the face width whose computed stiffness is that of the case"
    if not close:
        off = 100.0 * (matched[1] / inputs.mean_stiffness - 1.0)
        width = (
            "the face width, of those tried, whose computed stiffness comes nearest to that of the case "
            f"({off:+.2g} %)"
        )
    return (
        Configuration(
            "stiffness",
            f"{width}: all numbers of the lumped model, dimensionless and absolute, are those of the case, "
            "but the ripple of the stiffness, which is that of these narrower teeth",
            *matched,
            inputs.torque,
            inputs.error,
            inputs.speeds,
        ),
        Configuration(
            "dimensionless",
            "the face width of the case; E k/F, b k/F, the mesh frequency over that of the mesh and bearings "
            "over the mesh are held: torque, bearings and the square of the speed grow with the stiffness",
            *scaled,
            inputs.torque * grown,
            inputs.error,
            inputs.speeds,
            grown,
        ),
        Configuration(
            "absolute",
            "the face width of the case; torque, error, backlash and speed as in the case",
            *full,
            inputs.torque,
            inputs.error,
            _slower(inputs, full[1]),
        ),
    )


def reshaped(name: str, inputs: Inputs, width: float, stiffness: float) -> Configuration:
    """The case's width with other flanks, at the torque, error, backlash and speeds of the case.

    Parameters
    ----------
    name : {"modified", "unmodified"}
    inputs : Inputs
    width, stiffness : float
        m and N/m.

    Returns
    -------
    Configuration
    """
    return Configuration(
        name,
        f"the face width of the case with {name} flanks; torque, error, backlash and speed as in the case",
        width,
        stiffness,
        inputs.torque,
        inputs.error,
        _slower(inputs, stiffness),
    )


def _slower(inputs: Inputs, stiffness: float) -> tuple[float, ...]:
    """ω of a mesh of another stiffness, at the speeds of the case."""
    return tuple(omega * float(np.sqrt(inputs.mean_stiffness / stiffness)) for omega in inputs.speeds)


@dataclass(frozen=True)
class Plan:
    """All that is computed.

    Attributes
    ----------
    planned : Setting
        Of every configuration at every speed.
    everywhere : tuple of Setting
        Beside it, of every configuration at every speed.
    beside : tuple of Setting
        Of the configurations ``varied`` at every speed.
    varied : tuple of str
        Names of configurations.
    window : Setting
    window_over : (float, float, int)
        Speeds of the window over the last speed: from, to, how many; 0 for none.
    relief : Relief, optional
        A modification of the flanks, for one more configuration of the case's width.
    unmodified : bool
        Whether there is one more of plain flanks, where the case states a modification.
    """

    planned: Setting = PLANNED
    everywhere: tuple[Setting, ...] = (RIGID, DISTANCE_HELD)
    beside: tuple[Setting, ...] = ()
    varied: tuple[str, ...] = ("absolute",)
    window: Setting = AT_WINDOW
    window_over: tuple[float, float, int] = WINDOW
    relief: Relief | None = None
    unmodified: bool = False

    def settings_of(self, configuration: Configuration) -> tuple[Setting, ...]:
        """The planned setting of a configuration, and those beside it.

        Parameters
        ----------
        configuration : Configuration

        Returns
        -------
        tuple of Setting
        """
        stated = (
            (replace(STATED, flexible_pinion=self.planned.flexible_pinion),)
            if configuration.bearings != 1.0 and self.everywhere
            else ()
        )
        varied = self.beside if configuration.name in self.varied else ()
        return (self.planned, *self.everywhere, *stated, *varied)

    def window_omegas(self, configuration: Configuration) -> Array:
        """Of one configuration, ascending.

        Parameters
        ----------
        configuration : Configuration

        Returns
        -------
        ndarray
        """
        low, high, count = self.window_over
        return np.linspace(low, high, count) * configuration.omegas[-1]


def planned(
    quick: bool = False,
    flexible_pinion: bool = False,
    relief: Relief | None = None,
    unmodified: bool = False,
) -> Plan:
    """The plan of a verification.

    Parameters
    ----------
    quick : bool
        Without the window of speeds, and without the settings beside.
    flexible_pinion : bool
        Whether the body of the pinion bends in all of it.
    relief, unmodified
        As of `Plan`.

    Returns
    -------
    Plan

    Examples
    --------
    >>> from gearlash.studies.verification import planned
    >>> len(planned().beside), planned(quick=True).window_over
    (19, (0.0, 0.0, 0))
    """
    first, window, *everywhere = (
        replace(each, flexible_pinion=flexible_pinion) for each in (PLANNED, AT_WINDOW, RIGID, DISTANCE_HELD)
    )
    return Plan(
        planned=first,
        everywhere=tuple(everywhere),
        beside=() if quick else sensitivity(first),
        window=window,
        window_over=(0.0, 0.0, 0) if quick else WINDOW,
        relief=relief,
        unmodified=unmodified,
    )
