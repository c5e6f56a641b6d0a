"""What the contact rule changes, and bearings in resonance."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.system import Label, Status


@dataclass(frozen=True)
class RuleGrazing:
    """A grazing that was solved for.

    Attributes
    ----------
    value, error : float
        Of the parameter, and its error estimate.
    label_below, label_above : label or None
    kind : str
        Loss of contact or engagement, drive or back side.
    surface : str
        What is touched: ``gap`` (X = ±D) or ``force`` (Φ = 0).
    exponent : float
        Largest exponent of the touching orbit, per unit of τ.
    """

    value: float
    error: float
    label_below: Label | None
    label_above: Label | None
    kind: str
    surface: str
    exponent: float


@dataclass(frozen=True)
class RuleLabel:
    """The motion at one value of a parameter.

    Attributes
    ----------
    parameter : str
    value : float
    label : label or str
        The status where there is no motion.
    back_hit : bool
        Whether the back side is hit in it.
    certificate : str
    """

    parameter: str
    value: float
    label: Label | Status
    back_hit: bool
    certificate: str


@dataclass(frozen=True)
class RuleEffect:
    """The small study under one contact rule.

    Attributes
    ----------
    rule : str
    stated : bool
        Whether it is the rule of the case itself.
    lower, upper : RuleGrazing or None
        Ends in ω of the motion without impacts; None where they were not found.
    speeds : tuple of RuleLabel
        Cold starts at the article's two multibody speeds.
    backlash : tuple of RuleLabel
        Points of a sweep over D, followed down.
    back_side : tuple of RuleGrazing
        Back-side grazings along it.
    """

    rule: str
    stated: bool
    lower: RuleGrazing | None
    upper: RuleGrazing | None
    speeds: tuple[RuleLabel, ...]
    backlash: tuple[RuleLabel, ...]
    back_side: tuple[RuleGrazing, ...]


@dataclass(frozen=True)
class BearingMode:
    """A bearing direction in resonance inside the window without impacts, and the motion there.

    Attributes
    ----------
    bearing : str
    frequency : float
        Of the body on its bearing, over ω_n.
    motion, force : float
        Of the bearing, peak to peak, over D_c and over k_m D_c.
    mesh_force, mesh_mean : float
        Mesh force, peak to peak and mean, over k_m D_c.
    """

    bearing: str
    frequency: float
    motion: float
    force: float
    mesh_force: float
    mesh_mean: float
