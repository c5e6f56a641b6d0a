"""How the motions of a map are filled: a colour family for each regime, a shade for each frequent label."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gearlash.system import Label, Signature

from . import style
from .regimes import APERIODIC, BACK, BACK_ONLY, DRIVE, FREE, UNRESOLVED, regime, short

# Neighbours in a family differ by at least 9 in lightness (CIE L*); regions carry their label, too.
SHADES = {
    DRIVE: ("#74c0ee", "#2f80b9", "#bfe3f7", "#4fa3d6", "#1b5e8e"),
    BACK: ("#e69f00", "#a85a00", "#fbdc9a", "#cd7f00", "#7a3e00"),
}
OTHER_HATCH = "\\\\\\"  # a grey print has it as light as a shade
FAMILY = {BACK_ONLY: BACK}  # all motions that hit the back side share its shades
OTHERS = {DRIVE: ("#9fb6c6", "other, drive-side impacts"), BACK: ("#cbb59a", "other, with back-side impacts")}
DARK = ("#2f80b9", "#1b5e8e", "#a85a00", "#7a3e00", APERIODIC.colour)
FREE_HATCH = "////"
MISSING = "none computed"


@dataclass(frozen=True)
class Fill:
    """Fill colour, hatch, words of the legend, colour of text on it."""

    colour: str
    words: str
    hatch: str = ""

    @property
    def ink(self) -> str:
        return "white" if self.colour in DARK else style.INK


NONE = Fill("white", MISSING, "....")


def fills(labels: Sequence[Label | None]) -> dict[Label | None, Fill]:
    """A fill for every label; the most frequent ones come first and get the shades, that of their period
    where it is left: so most labels look the same in every map."""
    left = {kind: list(shades) for kind, shades in SHADES.items()}
    found = {}
    for label in labels:
        kind = FAMILY.get(regime(label), regime(label))
        if kind not in SHADES or not isinstance(label, Signature):
            hatch = FREE_HATCH if kind is FREE else kind.hatch
            found[label] = Fill(kind.colour, kind.words, hatch)
        elif left[kind]:
            shades = SHADES[kind]
            own = shades[(label.period - 1) % len(shades)]
            colour = own if own in left[kind] else left[kind][0]
            left[kind].remove(colour)
            found[label] = Fill(colour, short(label))
        else:
            found[label] = Fill(*OTHERS[kind], OTHER_HATCH)
    return found


def legend_order(used: Sequence[Fill]) -> list[Fill]:
    """Fills as a legend lists them, each once: no impacts, shades by family, the rest."""
    families = [FREE.colour, *SHADES[DRIVE], OTHERS[DRIVE][0], *SHADES[BACK], OTHERS[BACK][0]]
    order = {colour: i for i, colour in enumerate([*families, APERIODIC.colour, UNRESOLVED.colour])}
    return sorted(dict.fromkeys(used), key=lambda fill: (order[fill.colour], fill is NONE))
