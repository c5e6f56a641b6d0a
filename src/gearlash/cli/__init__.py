"""The command line. `main` is its entry point; one command a file in `commands`."""

from __future__ import annotations


def main() -> None:
    """Runs the command line of this process. Nothing is imported from the folder it is called in."""
    _end_without_words()

    from gearlash import current_folder

    current_folder.leave_out()

    from .interrupt import end_early, ignore_late

    end_early()

    from .terminal import prepare_streams

    prepare_streams()
    import errno

    from .app import app
    from .exits import ExitCode, not_written

    full = errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO

    try:
        app()
    except OSError as error:  # while printing help; commands see to it themselves
        if error.errno not in full:
            raise
        raise SystemExit(int(not_written(error))) from None
    except SystemExit as ended:
        if isinstance(ended.__context__, BrokenPipeError):  # its reader has seen enough, too
            raise SystemExit(int(ExitCode.OK)) from None
        raise
    finally:
        ignore_late()


def _end_without_words() -> None:
    """Until signals are answered, Ctrl-C ends this process as if it were no Python: without a traceback. By
    the part of `signal` that belongs to Python itself, and loads nothing."""
    import _signal  # pyright: ignore[reportMissingImports]

    if _signal.getsignal(_signal.SIGINT) is _signal.default_int_handler:
        _signal.signal(_signal.SIGINT, _signal.SIG_DFL)
