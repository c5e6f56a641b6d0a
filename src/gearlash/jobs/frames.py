"""Messages between a process and its workers: one letter, a length, that many bytes."""

from __future__ import annotations

import struct
from typing import IO

START, TASK, STOP, RESUME = b"S", b"T", b"!", b"R"
"""To a worker: what to do before anything else, a task, stop what is at work, and take that back."""
READY, DONE, RAISED = b"Y", b"D", b"E"
"""From a worker."""
FRAME_HEAD = struct.Struct("<cQ")


def send(stream: IO[bytes], kind: bytes, content: bytes = b"") -> None:
    """Raises `OSError` where nobody reads any more."""
    stream.write(FRAME_HEAD.pack(kind, len(content)) + content)
    stream.flush()


def receive(stream: IO[bytes]) -> tuple[bytes, bytes]:
    """Kind and content. Raises `EOFError` where the other side has ended."""
    kind, size = FRAME_HEAD.unpack(_exactly(stream, FRAME_HEAD.size))
    return kind, _exactly(stream, size)


def _exactly(stream: IO[bytes], size: int) -> bytes:
    content = stream.read(size)
    if len(content) < size:
        raise EOFError("the other process has ended")
    return content
