"""Whether something can be sent to worker processes.

What is defined in ``__main__`` is there for them only if that is a file, which they run: so it must keep its
work under `if __name__ == "__main__":`, else they would begin the same work again.
"""

from __future__ import annotations

import ast
import pickle
import sys
from pathlib import Path
from typing import Any

GUARD = 'a script that starts workers must do so under `if __name__ == "__main__":`'


def cannot_travel(thing: Any) -> str:
    """Why a thing cannot be sent to worker processes of this package; an empty text if it can."""
    content = _pickled(thing)
    if isinstance(content, str):
        return content
    return _unknown_main() if b"__main__" in content else ""


def cannot_pickle(thing: Any) -> str:
    """Why a thing cannot be pickled; an empty text if it can."""
    content = _pickled(thing)
    return content if isinstance(content, str) else ""


def _pickled(thing: Any) -> bytes | str:
    """A thing as bytes, or the reason why it cannot be pickled: a user's object may raise anything."""
    try:
        return pickle.dumps(thing)
    except Exception as error:  # noqa: BLE001
        return " ".join(str(error).split()) or type(error).__name__


def main_module() -> tuple[str, str]:
    """Module name and file of ``__main__``; both empty where workers cannot run it."""
    main = sys.modules.get("__main__")
    spec = getattr(main, "__spec__", None)
    if spec is not None and spec.name and spec.name != "__main__":
        return spec.name, ""
    file = getattr(main, "__file__", None)
    return ("", str(Path(file).resolve())) if file and Path(file).is_file() else ("", "")


def _unknown_main() -> str:
    name, file = main_module()
    if not name and not file:
        return (
            "it is defined in `__main__`, which they do not have: a notebook, an interactive session or "
            "standard input"
        )
    if file and not _guarded(Path(file)):
        return f"it is defined in {Path(file).name}, which they would run: {GUARD}"
    return ""


def _guarded(file: Path) -> bool:
    """Whether a script asks for its own name anywhere; one that cannot be read is trusted."""
    try:
        tree = ast.parse(file.read_bytes())
    except (OSError, SyntaxError, ValueError):
        return True
    return any(isinstance(node, ast.Name) and node.id == "__name__" for node in ast.walk(tree))
