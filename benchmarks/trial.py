"""`python -m benchmarks.trial FOLDER [--seeds 0:20] [--commands report,tolerance,zones]`: random drawings
(see `drawings`) from `gearlash new` to the report, one after the other, and a table with what they took: of
each command the seconds until its first line and in all, those of processors in brackets.

Seconds by the clock mean something on a machine that does nothing else, those of processors (of all processes
of a command) nearly anywhere. A row is printed as soon as it is there; FOLDER keeps cases and reports."""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import threading
from dataclasses import dataclass, field
from pathlib import Path
from time import perf_counter

from .drawings import RandomDrawing, random_drawing

COMMANDS = "check", "report", "tolerance", "zones"
GEARLASH = Path(sys.executable).parent / "gearlash"
TICKS = os.sysconf("SC_CLK_TCK")
SESSION, TIMES = 3, slice(11, 15)  # fields of /proc/PID/stat behind the name
LONGEST = 1800.0  # seconds that a command may take


@dataclass
class Ran:
    """One command: its exit code, seconds until its first line and in all (by the clock, of processors), and
    what it printed."""

    code: int
    first: tuple[float, float]
    whole: tuple[float, float]
    lines: list[str] = field(default_factory=list)
    errors: str = ""

    @property
    def text(self) -> str:
        """Both times, until the first line and in all."""
        until, whole = ("{:.0f} ({:.0f})".format(*one) for one in (self.first, self.whole))
        done = "" if self.code == 0 else f" exit {self.code}"
        return f"{until}, {whole}{done}"


def ran(arguments: list[str]) -> Ran:
    """Runs gearlash in a session of its own."""
    began = perf_counter()
    process = subprocess.Popen(
        [str(GEARLASH), *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
    )  # fmt: skip
    assert process.stdout is not None
    assert process.stderr is not None
    errors: list[str] = []
    reader = threading.Thread(target=lambda stream: errors.append(stream.read()), args=(process.stderr,))
    clock = threading.Timer(LONGEST, process.terminate)
    reader.start()
    clock.start()
    lines: list[str] = []
    first = 0.0, 0.0
    for line in process.stdout:
        if not lines:
            first = perf_counter() - began, processor_time(process.pid)
        lines.append(line.rstrip("\n"))
    reader.join()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    clock.cancel()
    whole = perf_counter() - began, used.ru_utime + used.ru_stime
    return Ran(process.returncode, first, whole, lines, errors[0])


def processor_time(session: int) -> float:
    """Seconds of all processes of a session, with those of children that have ended."""
    spent = 0
    for folder in Path("/proc").iterdir():
        if folder.name.isdecimal():
            try:
                fields = (folder / "stat").read_text().rpartition(")")[2].split()
            except OSError:  # it has just ended
                continue
            if int(fields[SESSION]) == session:
                spent += sum(map(int, fields[TIMES]))
    return spent / TICKS


def asked(name: str, file: Path, drawing: RandomDrawing) -> list[str]:
    """The arguments of a command on the case of a drawing."""
    around = f"{0.5 * drawing.speed:.1f}:{1.5 * drawing.speed:.1f}rpm"
    return {
        "new": ["new", str(file), "--overwrite", *drawing.options],
        "check": ["check", str(file), "--json"],
        "report": ["report", str(file), "--out", str(file.with_suffix(""))],
        "tolerance": ["tolerance", str(file), "--over", f"pinion_speed={around}:61"],
        "zones": ["zones", str(file), "--over", f"pinion_speed={around}:21"],
    }[name]


def trial(seed: int, folder: Path, commands: list[str]) -> str:
    """One row of the table."""
    drawing, file = random_drawing(seed), folder / f"drawing-{seed}.toml"
    cells = [str(seed), str(drawing)]
    for name in ["new", *commands]:
        found = ran(asked(name, file, drawing))
        file.with_suffix(f".{name}.txt").write_text("\n".join([*found.lines, found.errors]))
        if name in ("new", "check"):
            cells += [] if name == "check" and found.code == 0 else [f"{name} {found.code}"][: found.code]
        else:
            cells.append(found.text)
        if found.code not in (0, 3):
            cells.append(found.errors.strip().splitlines()[-1][:120] if found.errors.strip() else "")
    return f"| {' | '.join(cells)} |"


def main(arguments: list[str] | None = None) -> int:
    """Prints the table."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.trial", description=__doc__)
    parser.add_argument("folder", type=Path, metavar="FOLDER")
    parser.add_argument("--seeds", default="0:20", metavar="FROM:TO", help="the last one is left out")
    parser.add_argument("--commands", default=",".join(COMMANDS), metavar="NAMES")
    given = parser.parse_args(arguments)
    first, last = map(int, given.seeds.split(":"))
    commands = given.commands.split(",")
    given.folder.mkdir(parents=True, exist_ok=True)
    timed = [name for name in commands if name != "check"]
    print(f"| seed | drawing | {' | '.join(timed)} |", f"|{'---|' * (2 + len(timed))}", sep="\n", flush=True)
    for seed in range(first, last):
        print(trial(seed, given.folder, commands), flush=True)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
