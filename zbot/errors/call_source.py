"""Source of the call by which a program called zbot. An error quotes it."""

from __future__ import annotations

import ast
import linecache
import os
import re
import sys
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator
    from types import FrameType

#: Begin of the paths of this library's files. The separator excludes `zbot_cli` and `zbot_nodes`.
OWN_FILES = str(Path(__file__).parents[1]) + os.sep
_TARGET = re.compile(r"\btarget\s*=\s*([\w.]+)\(([^()]*)\)")


def argument_source(function: str, keyword: str, position: int | None) -> ast.expr | None:
    """Return what the program wrote for an argument of its call, or `None` if that is unknown.

    The first call for a line parses the program's file, which takes milliseconds.

    Args:
        function: Name of the function or class that has the argument. The result is `None` if the
            program has called another function of zbot, which calls this one.
        keyword: Name of the argument.
        position: Index of the argument if it is given without its name. `None` if it never is.
    """
    frame, called = _calling_frame()
    if frame is None or called not in {function, "__init__", "__post_init__"}:
        return None
    return _source(frame.f_code.co_filename, frame.f_lineno, called, keyword, position)


@lru_cache(maxsize=64)
def _source(
    file: str, line: int, function: str, keyword: str, position: int | None
) -> ast.expr | None:
    found = [
        (call.lineno, call.col_offset, argument)
        for call in _calls_at(file, line)
        if function == "__init__" or _last_name(call.func) == function
        if (argument := _argument(call, keyword, position)) is not None
    ]
    # The innermost call begins last.
    return max(found, key=lambda place: place[:2])[2] if found else None


def calling_line() -> str:
    """Return the file and the line of the program's call, e.g. `talker.py:12`.

    The result is empty for a call of the `zbot` command or of a bundled node.
    """
    frame, _ = _calling_frame()
    if frame is None or str(frame.f_globals.get("__name__")).startswith(("zbot_cli", "zbot_nodes")):
        return ""
    return f"{frame.f_code.co_filename}:{frame.f_lineno}"


def called_function() -> str:
    """Return the name of zbot's function that the program has called, which calls this one."""
    return _calling_frame()[1]


def called_target() -> str:
    """Return what the program should write for a thread that gets the result of its present call.

    For `Thread(target=rclpy.spin(node))`, this is `target=rclpy.spin, args=(node,)`. The result is
    empty if the program's line has no such call.
    """
    frame, function = _calling_frame()
    if frame is None:
        return ""
    found = _TARGET.search(linecache.getline(frame.f_code.co_filename, frame.f_lineno))
    if found is None or found[1].rpartition(".")[2] != function:
        return ""
    return f"target={found[1]}" + (f", args=({found[2]},)" if found[2] else "")


def field_read_from(function: str) -> str:
    """Return the field that the program's line reads from a call, e.g. `x` for `position().x`.

    The result is empty if the line reads no field, or different fields, from calls of the function.
    """
    frame, called = _calling_frame()
    if frame is None or called != function:
        return ""
    line = linecache.getline(frame.f_code.co_filename, frame.f_lineno)
    fields = set(re.findall(rf"\.{function}\(\)\.(\w+)", line))
    return fields.pop() if len(fields) == 1 else ""


def _calling_frame() -> tuple[FrameType | None, str]:
    """Return the frame of the program that called zbot, and the name of the called function."""
    frame: FrameType | None = sys._getframe(1)  # noqa: SLF001 - Python has no quick public way
    function = ""
    while frame is not None and frame.f_code.co_filename.startswith(OWN_FILES):
        function, frame = frame.f_code.co_name, frame.f_back
    return frame, function


def _calls_at(file: str, line: int) -> Iterator[ast.Call]:
    try:
        tree = ast.parse("".join(linecache.getlines(file)))
    except (SyntaxError, ValueError):
        return
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and node.lineno <= line <= (node.end_lineno or 0):
            yield node


def _last_name(function: ast.expr) -> str:
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def _argument(call: ast.Call, keyword: str, position: int | None) -> ast.expr | None:
    named = {word.arg: word.value for word in call.keywords}
    if keyword in named:
        return named[keyword]
    if position is None:
        return None
    given = call.args[: position + 1]
    if len(given) <= position or any(isinstance(value, ast.Starred) for value in given):
        return None
    return given[position]
