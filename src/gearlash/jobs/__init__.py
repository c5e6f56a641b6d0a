"""Work in chains of tasks, done by any executor: progress with an honest estimate, cancel, Ctrl-C.

with open_executor(workers=2) as executor:
    outcome = run(function, chains, executor, progress=show)
"""

from .chains import Carry, Chain, Outcome, Part, run
from .executors import Inline, Pool, open_executor
from .progress import Progress, ProgressCallback, seconds_as_text
from .stop import Cancel, stopping

__all__ = [
    "Cancel",
    "Carry",
    "Chain",
    "Inline",
    "Outcome",
    "Part",
    "Pool",
    "Progress",
    "ProgressCallback",
    "open_executor",
    "run",
    "seconds_as_text",
    "stopping",
]
