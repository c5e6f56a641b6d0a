"""The others: each in a file of its own, used as well as one who knows it would."""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, version

PACKAGES = ("heyoka", "scipy", "scikit-sundae", "numba")
MISSING = "not installed"


def installed(package: str) -> str:
    """Version of a peer's package, or `MISSING`."""
    try:
        return version(package)
    except PackageNotFoundError:
        return MISSING
