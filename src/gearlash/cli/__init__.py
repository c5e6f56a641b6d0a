"""The command line. `main` is its entry point; one command a file in `commands`."""

from __future__ import annotations


def main() -> None:
    """Runs the command line of this process."""
    from .terminal import prepare_streams

    prepare_streams()
    from .app import app

    app()
