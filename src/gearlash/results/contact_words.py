"""What the rule of contact makes of the mesh force, in a plain sentence where it shows."""

from __future__ import annotations

from gearlash.system import ContactRule

_ALWAYS = (
    'The contact damping acts in the gap too (contact = "always"): the force need not be 0 without contact, '
    'and may pull. Other rules: "in-contact" (damping in contact only), "no-tension" (teeth never pull); '
    "--set contact=no-tension."
)


def damping_in_the_gap(rule: ContactRule, least: float, without_contact: float) -> str:
    """Said of a motion whose ``least`` force is below 0, or that is a share of its time ``without_contact``;
    nothing where the damping acts in contact only."""
    shows = least < 0.0 or without_contact > 0.0
    return _ALWAYS if rule is ContactRule.ALWAYS and shows else ""
