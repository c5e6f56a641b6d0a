"""`python -m recorded.record` (in `tests`): runs every command of `recorded.commands`, keeps the answers.

A recording is the answer of `--json` and the arrays of the NetCDF file, number by number; of arrays with
more than `LARGEST` numbers the digest, and the count. Prose and what tells of the run (versions, hashes,
seconds) stay in it: `recorded.compare` knows what to pass over.
"""

from __future__ import annotations

import hashlib
import json
import lzma
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np

from .commands import COMMANDS, Recorded

HERE = Path(__file__).parent
CASES = HERE.parent / "cases"
DATA = HERE / "data"
LARGEST = 3000


def main(names: Iterable[str]) -> None:
    """Records the commands of these names, or all."""
    wanted = set(names)
    chosen = [command for command in COMMANDS if not wanted or command.name in wanted]
    with ThreadPoolExecutor(2) as pool:
        for command, content in zip(chosen, pool.map(record, chosen), strict=True):
            keep(command.name, content, DATA)
            print(command.name, content["code"], flush=True)


def record(command: Recorded) -> dict[str, Any]:
    """One command in a process of its own: exit code, answer, arrays.

    Those of `run` are left out: they draw the motion whose numbers the answer has.
    """
    with tempfile.TemporaryDirectory() as folder:
        arguments = [part.replace("{cases}", str(CASES)) for part in command.arguments]
        writes = ["--out", folder] if command.result != "check" else []
        line = [str(Path(sys.executable).parent / "gearlash"), *arguments, "--json", *writes]
        done = subprocess.run(line, capture_output=True, text=True, check=False, cwd=folder)
        files = [] if command.result == "run" else sorted(Path(folder).rglob("*.nc"))
        arrays = {path.relative_to(folder).as_posix(): decoded(path) for path in files}
    return {"code": done.returncode, "answer": json.loads(done.stdout), "arrays": arrays}


def decoded(path: Path) -> dict[str, Any]:
    """The arrays of a NetCDF file by name, read without this program."""
    import xarray as xr

    found: dict[str, Any] = {}
    with xr.open_datatree(path, engine="h5netcdf") as tree:
        for node in tree.subtree:
            for name, array in node.to_dataset(inherit=False).variables.items():
                found[f"{node.path}/{name}"] = _numbers(np.asarray(array.values))
    return found


def _numbers(array: np.ndarray[Any, Any]) -> dict[str, Any]:
    kind = array.dtype.kind
    plain = array.astype(str) if kind in "OSU" else array
    shown: dict[str, Any] = {"shape": list(array.shape), "kind": "text" if kind in "OSU" else kind}
    if plain.size <= LARGEST:
        return shown | {"values": plain.ravel().tolist()}
    content = "\0".join(plain.ravel().tolist()).encode() if kind in "OSU" else plain.tobytes()
    return shown | {"digest": hashlib.sha256(content).hexdigest()}


def keep(name: str, content: dict[str, Any], folder: Path) -> None:
    """Writes a recording, packed."""
    folder.mkdir(parents=True, exist_ok=True)
    text = json.dumps(content, ensure_ascii=False, separators=(",", ":"))
    (folder / f"{name}.json.xz").write_bytes(lzma.compress(text.encode(), preset=9))


def kept(name: str, folder: Path = DATA) -> dict[str, Any]:
    """A recording that was kept."""
    return json.loads(lzma.decompress((folder / f"{name}.json.xz").read_bytes()))


if __name__ == "__main__":
    main(sys.argv[1:])
