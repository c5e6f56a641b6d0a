"""The packages of the extra `multibody`: there, or said how to get."""

from __future__ import annotations

from gearlash.system import GearlashError

INSTALL = 'python -m pip install "gearlash[multibody]"'


class MissingExtraError(GearlashError):
    """A package that the multibody model needs is not installed; the text says how to install it."""


def require_extra() -> None:
    """Make sure that Exudyn and scikit-fem can be imported.

    Raises
    ------
    MissingExtraError
        If one of them is not installed.

    Examples
    --------
    >>> require_extra()
    """
    try:
        import exudyn as exudyn
        import skfem as skfem
    except ModuleNotFoundError as error:
        raise MissingExtraError(
            f"the multibody model needs {error.name}, which is not installed; install it with: {INSTALL}"
        ) from error
