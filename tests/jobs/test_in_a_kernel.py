"""Cells of a notebook: one process without a script, whose group an interrupt reaches, workers included."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
import threading

import pytest

pytestmark = pytest.mark.skipif(os.name == "nt", reason="signals of process groups are those of POSIX")

KERNEL = """
import sys
space = {"__name__": "__main__"}  # no file behind it, as in a kernel
for cell in sys.stdin.read().split("# next cell\\n"):
    try:
        exec(compile(cell, "<cell>", "exec"), space)
    except KeyboardInterrupt:
        print("not kept", flush=True)
"""
CELLS = """
import os, subprocess, threading
import gearlash as gl
case = gl.load_case("article")
began = threading.Event()
def told(progress):
    if progress.done and not began.is_set():
        began.set()
        print("begun", flush=True)
# next cell
speeds, gaps = gl.Axis.even("omega", 0.5, 1.4, 300), gl.Axis.even("D", 0.2, 1.2, 200)
{opened}
    plane = gl.map_plane(case, speeds, gaps, execution=gl.Execution(workers, progress=told))
print("complete", plane.complete, plane.message, plane.statuses["ok"] > 0, flush=True)
# next cell
{opened}
    more = gl.map_plane(case, gl.Axis.even("omega", 1.0, 1.05, 3), gaps[:2], execution=gl.Execution(workers))
print("after", more.complete, flush=True)
# next cell
mine = subprocess.run(["ps", "-o", "pid=,args=", "--ppid", str(os.getpid())], capture_output=True, text=True)
left = [line for line in mine.stdout.splitlines() if " ps " not in line and "<defunct>" not in line]
print("left", left, flush=True)
"""


@pytest.mark.slow
@pytest.mark.parametrize("opened", ["with gl.open_workers(case, 2) as workers:", "for workers in (None,):"])
def test_an_interrupted_cell_keeps_what_it_has_and_the_next_one_runs(opened: str):
    cells = CELLS.format(opened=opened).replace("gaps[:2]", 'gl.Axis.even("D", 0.9, 1.0, 2)')
    with subprocess.Popen(
        [sys.executable, "-c", textwrap.dedent(KERNEL)],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, start_new_session=True,
    ) as kernel:  # fmt: skip
        assert kernel.stdin is not None
        assert kernel.stdout is not None
        limit = threading.Timer(240.0, kernel.kill)
        limit.start()
        kernel.stdin.write(cells)
        kernel.stdin.close()
        assert kernel.stdout.readline() == "begun\n"
        os.killpg(kernel.pid, signal.SIGINT)
        rest = kernel.stdout.read().splitlines()
        limit.cancel()
    assert rest == ["complete False interrupted True", "after True", "left []"]
