"""No module imports a module that imports the first one again.

All `import` statements count, also those in functions and those for type hints: a circle of them
means that a reader cannot understand one module before the other.
"""

from __future__ import annotations

import ast
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Iterator

ROOT = Path(__file__).parents[2]
FOLDERS = ("zbot", "cli/zbot_cli", "nodes/zbot_nodes")
GENERATED = "zbot/compat/packages"
#: The room that counts as one module. `zbot/launch/__init__.py` says why.
LAUNCH = "zbot.launch"


@cache
def sources() -> dict[str, Path]:
    """Return the hand-written files by the names of their modules."""
    found = {}
    for folder in map(ROOT.joinpath, FOLDERS):
        for path in folder.rglob("*.py"):
            if not path.is_relative_to(ROOT / GENERATED):
                parts = path.relative_to(folder.parent).with_suffix("").parts
                found[".".join(parts).removesuffix(".__init__")] = path
    return found


def imported(path: Path) -> Iterator[str]:
    """Yield the modules that a file imports. `from a import b` is `a.b` if `b` is a module."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            for alias in node.names:
                name = f"{node.module}.{alias.name}"
                yield name if name in sources() else str(node.module)


def room(module: str) -> str:
    return LAUNCH if module.startswith(f"{LAUNCH}.") else module


def test_no_module_is_in_a_circle_of_imports() -> None:
    graph: dict[str, set[str]] = {}
    for module, path in sources().items():
        needed = graph.setdefault(room(module), set())
        needed |= {room(name) for name in imported(path) if name in sources()} - {room(module)}
    assert len(graph) > 500
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(" imports ".join(reversed(error.args[1])))
