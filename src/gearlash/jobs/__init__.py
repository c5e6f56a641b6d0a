"""Work in chains of tasks, done by any executor: progress with an honest estimate, cancel, Ctrl-C.

with open_executor(workers=2) as executor:
    outcome = run(function, chains, Execution(executor, progress=show))
"""

from .chains import DIED, INTERRUPTED, Carry, Chain, Outcome, Part, run
from .execution import Execution
from .executors import Inline, open_executor
from .pool import NoWorkersError, Pool, UnfinishedError
from .progress import Progress, ProgressCallback, seconds_as_text
from .stop import Cancel, handing_on, stopping
from .travel import cannot_pickle, cannot_travel

__all__ = [
    "DIED",
    "INTERRUPTED",
    "Cancel",
    "Carry",
    "Chain",
    "Execution",
    "Inline",
    "NoWorkersError",
    "Outcome",
    "Part",
    "Pool",
    "Progress",
    "ProgressCallback",
    "UnfinishedError",
    "cannot_pickle",
    "cannot_travel",
    "handing_on",
    "open_executor",
    "run",
    "seconds_as_text",
    "stopping",
]
