"""Ctrl-C: the first ends the work, and what was computed is kept; one more must not end the keeping."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from types import FrameType

NOTICE = b"\nstopping, and keeping what was computed (Ctrl-C once more gives it up)\n"


@contextmanager
def first_ctrl_c_counts() -> Iterator[None]:
    """The first Ctrl-C raises KeyboardInterrupt, the second is answered with a line on standard error, any
    later one raises again. Where Ctrl-C does something else already, it is left alone."""
    alone = threading.current_thread() is threading.main_thread()
    if not alone or signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        yield
        return
    count = 0

    def handle(_number: int, _frame: FrameType | None) -> None:
        nonlocal count
        count += 1
        if count == 2:
            with suppress(OSError):
                os.write(2, NOTICE)  # unbuffered: the handler may have come in the middle of a print
            return
        raise KeyboardInterrupt

    signal.signal(signal.SIGINT, handle)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
