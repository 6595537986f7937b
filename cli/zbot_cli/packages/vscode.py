"""Files for VS Code in a new package: tasks, a matcher of errors, and ways to start nodes."""

from __future__ import annotations

import json
from typing import Any

#: The Python that the user chose in VS Code. `python -m zbot` works where `zbot` is refused.
_PYTHON = "${command:python.interpreterPath}"
#: Lines such as `src/robot/setup.py:24: 'n' names mian()`, also without a line number.
_MATCHER = {
    "owner": "zbot",
    "fileLocation": ["autoDetect", "${workspaceFolder}"],
    "pattern": {
        "regexp": r"^(\S.*?\.\w+):(?:(\d+):)? (?:(warning): )?(.+)$",
        "file": 1,
        "line": 2,
        "severity": 3,
        "message": 4,
    },
}


def files(package: str, node: str) -> dict[str, str]:
    """Return the texts of the files by their names in the folder `.vscode`.

    Args:
        package: The package.
        node: A program of the package. It may be empty.
    """
    nodes = [_start(node, package, node)] if node else []
    return {
        "tasks.json": _json(
            {
                "version": "2.0.0",
                "tasks": [
                    {**_task("build"), "problemMatcher": _MATCHER, "group": _default("build")},
                    {**_task("test"), "problemMatcher": [], "group": _default("test")},
                    {**_task("doctor"), "problemMatcher": []},
                ],
            }
        ),
        "launch.json": _json(
            {
                "version": "0.2.0",
                "configurations": [*nodes, _start("this file", "${file}")],
            }
        ),
        "extensions.json": _json({"recommendations": ["ms-python.python", "ms-python.debugpy"]}),
    }


def _task(noun: str) -> dict[str, Any]:
    words = ["-m", "zbot", noun]
    return {"label": f"zbot {noun}", "type": "process", "command": _PYTHON, "args": words}


def _default(kind: str) -> dict[str, Any]:
    return {"kind": kind, "isDefault": True}


def _start(name: str, *words: str) -> dict[str, Any]:
    return {
        "name": f"zbot run {name}",
        "type": "debugpy",
        "request": "launch",
        "module": "zbot",
        "args": ["run", *words],
        "console": "integratedTerminal",
    }


def _json(value: dict[str, Any]) -> str:
    return json.dumps(value, indent=4) + "\n"
