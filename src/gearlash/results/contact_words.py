"""Words of contact: its sides where there are no teeth, and what its rule makes of the mesh force."""

from __future__ import annotations

from gearlash.system import ContactRule

_ALWAYS = (
    'The contact damping acts in the gap too (contact = "always"): the force need not be 0 without contact, '
    'and may pull. Other rules: "in-contact" (damping in contact only), "no-tension" (teeth never pull); '
    "--set contact=no-tension."
)


def damping_in_the_gap(rule: ContactRule, least: float, largest: float, without_contact: float) -> str:
    """Said of a motion whose force is of either sign, or that is a share of its time ``without_contact``;
    nothing where the damping acts in contact only. A force below 0 all the time presses the back side."""
    shows = least < 0.0 < largest or without_contact > 0.0
    return _ALWAYS if rule is ContactRule.ALWAYS and shows else ""


SIDES = {"the drive side": "side +", "the back side": "side -", "drive side": "side +", "back side": "side -"}
"""Of a gap that no teeth bound: where X is large, and where it is small."""


def sided(text: str, between_teeth: bool) -> str:
    """What is said of drive and back side, in words of any gap where no teeth meet."""
    if not between_teeth:
        for teeth, plain in SIDES.items():
            text = text.replace(teeth, plain)
    return text
