"""Launch files in Python."""

from __future__ import annotations

import io
import sys
import traceback
from types import ModuleType
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.launch.description import LaunchDescription
from zbot.launch.errors import LaunchFileError, describe
from zbot.package.workspace import package_folders

if TYPE_CHECKING:
    from pathlib import Path

_FUNCTION = "generate_launch_description"


def load(path: Path) -> LaunchDescription:
    """Return what a launch file describes.

    Raises:
        LaunchFileError: The file cannot be read or fails, or describes nothing.
    """
    returned: Any = None
    try:
        module = load_module(path)
        function = getattr(module, _FUNCTION, None)
        if callable(function):
            returned = function()
    except SyntaxError as error:
        place = error.filename or str(path)
        raise LaunchFileError(place, error.lineno or 0, f"SyntaxError: {error.msg}") from error
    except Exception as error:
        raise _located(path, error) from error
    if function is None:
        raise LaunchFileError(str(path), 0, f"it has no function {_FUNCTION}()")
    if not isinstance(returned, LaunchDescription):
        line = getattr(getattr(function, "__code__", None), "co_firstlineno", 0)
        raise LaunchFileError(str(path), line, _complaint(returned))
    return returned


def load_module(path: str | Path) -> ModuleType:
    """Return a launch file as a module, which is not to be imported by others.

    Raises:
        OSError: It cannot be read.
        Exception: What it raises.
    """
    module = ModuleType("launch_file")
    module.__file__ = str(path)
    _import_from_workspace()
    with io.open_code(str(path)) as file:
        code = compile(file.read(), str(path), "exec")
    exec(code, module.__dict__)  # noqa: S102 - running the user's file is the whole point
    return module


def _complaint(returned: object) -> str:
    if returned is None:
        return f"{_FUNCTION}() returns nothing: end it with `return LaunchDescription([...])`"
    kind = type(returned)
    return f"{_FUNCTION}() must return a LaunchDescription, not {kind.__module__}.{kind.__name__}"


def _located(path: Path, error: Exception) -> LaunchFileError:
    """Return the error with the last line of the file that led to it."""
    if isinstance(error, LaunchFileError):
        return error
    lines = [
        frame.lineno
        for frame in traceback.extract_tb(error.__traceback__)
        if frame.filename == str(path)
    ]
    reason = str(error) if isinstance(error, ZbotError) else describe(error)
    hint = getattr(error, "hint", "") or ""
    return LaunchFileError(str(path), (lines[-1] if lines else 0) or 0, reason, hint)


def _import_from_workspace() -> None:
    """Let launch files import the packages of the workspace, as after sourcing one of ROS 2."""
    for folder in package_folders():
        if str(folder) not in sys.path:
            sys.path.append(str(folder))
