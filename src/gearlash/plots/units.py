"""Axis labels with symbols and units, and second axes in rpm, µm, ms and N where a case has scales."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache

import numpy as np
from matplotlib.axes import Axes
from matplotlib.font_manager import findfont, get_font
from numpy.typing import ArrayLike, NDArray

from gearlash.case import Case
from gearlash.case.units import pretty
from gearlash.results.physical import backlash_words
from gearlash.system import given

Array = NDArray[np.float64]

ASSUMED_MARK = "†"  # beside a unit whose scale rests on an assumed value
ASSUMED = f"{ASSUMED_MARK}: rests on an assumed value."

X = r"displacement  $X_n$"
VELOCITY = r"velocity  $X_n'$"
FORCE = r"contact force  $\Phi$"
PHASE = r"time  $\theta/2\pi$  [cycles]"
EXPONENT = r"$\lambda_1$  [per $\tau$]"


def literal(text: str) -> str:
    """Somebody's own words as matplotlib is to draw them: a dollar sign begins no formula, and what cannot be
    printed, or has no letter in the font, is shown as such."""
    letters = _letters()
    shown = "".join(
        each if each == "\n" or (each.isprintable() and ord(each) in letters) else "\ufffd" for each in text
    )
    return shown.replace("$", r"\$")


@cache
def _letters() -> frozenset[int]:
    """Of the font that figures are set in, which comes with matplotlib."""
    return frozenset(get_font(findfont("DejaVu Sans")).get_charmap())


@dataclass(frozen=True)
class ForceAxis:
    """How a figure draws the contact force on sections.

    Φ is positive where the drive side is compressed; publications that count the force the other way round
    have a symbol of their own for it.

    Parameters
    ----------
    symbol : str
        As matplotlib takes it.
    sign : float
        +1: Φ; -1: −Φ.

    Examples
    --------
    >>> from gearlash.plots import ForceAxis
    >>> ForceAxis(r"$F$", -1.0).sign
    -1.0
    """

    symbol: str = r"$\Phi$"
    sign: float = 1.0


@dataclass(frozen=True)
class Twin:
    """A second scale of an axis, which is a multiple of the dimensionless one.

    Parameters
    ----------
    factor : float
        Physical over dimensionless values.
    words, unit : str
    assumed : bool
        Whether it rests on an assumed value: its label then carries †.
    own : bool
        Whether the parameter is this quantity itself, in SI: its values then have this scale alone.

    Examples
    --------
    >>> from gearlash.plots import Twin
    >>> speed = Twin(3820.0, "pinion speed", "rpm")
    >>> speed.label, float(speed(0.5)), float(speed.back(1910.0))
    ('pinion speed  [rpm]', 1910.0, 0.5)
    """

    factor: float
    words: str
    unit: str
    assumed: bool = False
    own: bool = False

    @property
    def label(self) -> str:
        """For an axis; carries † where the scale rests on an assumed value."""
        unit = f"  [{self.unit}]" if self.unit else ""
        return f"{self.words}{unit}{' ' + ASSUMED_MARK if self.assumed else ''}"

    def __call__(self, values: ArrayLike) -> Array:
        return np.asarray(values, dtype=np.float64) * self.factor

    def back(self, values: ArrayLike) -> Array:
        """From physical to dimensionless values.

        Parameters
        ----------
        values : array_like

        Returns
        -------
        ndarray
        """
        return np.asarray(values, dtype=np.float64) / self.factor


@dataclass(frozen=True)
class Units:
    """The second axes that a case can have; `Units()` has none.

    Parameters
    ----------
    speed, backlash, length, force, milliseconds, velocity : Twin, optional
        Pinion speed of ω, backlash b of D, length of X, normal force of Φ, time of τ, velocity of X′; None
        where the scales of the case do not reach.
    others : mapping of str to Twin
        Those of further parameters, by short name.
    teeth : bool
        Whether the first clearance is the one between two meshing gears: axes then speak of gears.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash.plots import Units
    >>> Units.of(gl.load_case("wind-turbine")).speed.unit
    'rpm'
    """

    speed: Twin | None = None
    backlash: Twin | None = None
    length: Twin | None = None
    force: Twin | None = None
    milliseconds: Twin | None = None  # of one unit of τ
    others: Mapping[str, Twin] = field(default_factory=dict)  # of further parameters, by short name
    teeth: bool = False
    velocity: Twin | None = None

    @staticmethod
    def of(case: Case) -> Units:
        """All second axes that the scales of a case give.

        Parameters
        ----------
        case : Case

        Returns
        -------
        Units
            A scale that rests on an assumed value carries †.
        """
        given.instance("case", case, Case, "a case, as from gearlash.load_case")
        scales = case.scales
        if not scales.physical:
            return Units(teeth=case.between_teeth)
        doubtful = {v.path for v in case.values() if v.uncertain}
        length, force = "model.reference_length" in doubtful, "derived.force_unit" in doubtful
        speed = "derived.omega_n" in doubtful
        rpm = float(scales.pinion_rpm(1.0)) if scales.teeth else None
        return Units(
            speed=None if rpm is None else Twin(rpm, "pinion speed", "rpm", speed),
            backlash=Twin(float(scales.backlash_um(1.0)), f"{backlash_words(case)}  $b$", "µm", length),
            length=Twin(float(scales.length_um(1.0)), "$x_n$", "µm", length),
            force=Twin(float(scales.force_N(1.0)), "$F_n$", "N", force),
            milliseconds=Twin(1e3 * float(scales.time_s(1.0)), "$t$", "ms", speed),
            others=_others(case, {"Hz": speed, "um": length, "N*m": force}),
            teeth=case.between_teeth,
            velocity=Twin(1e3 * float(scales.velocity(1.0)), r"$\dot x_n$", "mm/s", length or speed),
        )

    @property
    def assumed(self) -> bool:
        """Does any of them rest on an assumed value?"""
        own = (self.speed, self.backlash, self.length, self.force, self.milliseconds)
        return any(scale.assumed for scale in (*own, *self.others.values()) if scale is not None)

    def asked(self, parameter: str, own: Twin | None) -> Twin | None:
        """The unit that a parameter was asked in, else its physical scale; with † where that rests on more.

        Parameters
        ----------
        parameter : str
            Short name.
        own : Twin or None

        Returns
        -------
        Twin or None
        """
        usual = self.of_parameter(parameter)
        if own is None or usual is None:
            return own or usual
        return replace(own, assumed=own.assumed or usual.assumed, own=usual.own)

    def of_parameter(self, parameter: str) -> Twin | None:
        """The physical scale of a parameter.

        Parameters
        ----------
        parameter : str
            Short name.

        Returns
        -------
        Twin or None
        """
        return {"omega": self.speed, "D": self.backlash}.get(parameter) or self.others.get(parameter)

    def alone(self, parameter: str) -> Twin | None:
        """The scale of a parameter that has no other, as it is a quantity in SI.

        Parameters
        ----------
        parameter : str
            Short name.

        Returns
        -------
        Twin or None
        """
        found = self.of_parameter(parameter)
        return found if found is not None and found.own else None


def rests(*scales: Twin | None) -> bool:
    """Whether one of them rests on an assumed value."""
    return any(scale is not None and scale.assumed for scale in scales)


def _others(case: Case, assumed: Mapping[str, bool]) -> dict[str, Twin]:
    """The scale of every parameter that has one, as the case itself names it: of several, the last (Hz, not
    rpm, for which `Units.speed` is there); ``assumed``: unit → whether what it is converted with is."""
    found = {}
    for parameter in case.family()[0].defaults:
        for path, value, unit in case.physical(parameter, 1.0)[-1:]:
            table, _, leaf = path.rpartition(".")
            words = (f"{table} {leaf}" if table in ("pinion", "gear") else leaf).replace("_", " ")
            own = path == parameter
            rests_on = not own and assumed.get(unit, False)
            found[parameter] = Twin(float(value), words, pretty(unit), rests_on, own)
    return found


def second(axes: Axes, twin: Twin | None, which: str = "x", below: float = 0.0) -> None:
    """Gives the axes a second scale at the top (``x``), on the right (``y``), or ``below`` (mm) their own
    x axis; or one in place of their own (``which``: below, left).
    """
    if twin is None:
        return
    pair: tuple[Callable[[ArrayLike], Array], Callable[[ArrayLike], Array]] = (twin, twin.back)
    if which == "below" or (which == "x" and below):
        made = axes.secondary_xaxis(0.0, functions=pair)
        made.spines["bottom"].set_position(("outward", below / 25.4 * 72.0))
        made.tick_params(which="both", top=False, bottom=True)
        made.set_xlabel(twin.label)
    elif which == "x":
        axes.tick_params(which="both", top=False)
        made = axes.secondary_xaxis("top", functions=pair)
        made.set_xlabel(twin.label)
    elif which == "left":
        made = axes.secondary_yaxis("left", functions=pair)
        made.set_ylabel(twin.label)
    else:
        axes.tick_params(which="both", right=False)
        made = axes.secondary_yaxis("right", functions=pair)
        made.set_ylabel(twin.label)
