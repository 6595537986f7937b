"""Loader of launch files in Python."""

from __future__ import annotations

import io
import traceback
from types import ModuleType
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.launch.description import LaunchDescription
from zbot.launch.errors import LaunchFileError, describe
from zbot.launch.left_out import missing_file
from zbot.launch.python_mistakes import FUNCTION, advice, corrected_import, missing_function
from zbot.package import python_finder
from zbot.terminal.typographic import advise_of_syntax

if TYPE_CHECKING:
    from pathlib import Path

#: Modules that launch files import, and the extra of zbot that installs each module.
_EXTRAS = {"numpy": "numpy", "xacro": "robot"}


def load(path: Path) -> LaunchDescription:
    """Return the launch description of a launch file.

    Raises:
        LaunchFileError: The file cannot be read, raises an error, or returns no description.
    """
    returned: Any = None
    try:
        module = load_module(path)
        function = getattr(module, FUNCTION, None)
        if callable(function):
            returned = function()
    except SyntaxError as error:
        advise_of_syntax(error)
        place = error.filename or str(path)
        raise LaunchFileError(place, error.lineno or 0, f"SyntaxError: {error.msg}") from error
    except (Exception, SystemExit) as error:
        raise _with_line(path, error) from error
    if function is None:
        reason = f"the file has no function {FUNCTION}()"
        raise LaunchFileError(str(path), 0, reason, missing_function(module))
    if not isinstance(returned, LaunchDescription):
        line = getattr(getattr(function, "__code__", None), "co_firstlineno", 0)
        raise LaunchFileError(str(path), line, _wrong_result(returned))
    return returned


def load_module(path: str | Path) -> ModuleType:
    """Load a launch file as a module, without adding it to `sys.modules`.

    Raises:
        OSError: The file cannot be read.
        Exception: The error that the file raises.
    """
    module = ModuleType("launch_file")
    module.__file__ = str(path)
    python_finder.install(searches_always=True)
    with io.open_code(str(path)) as file:
        code = compile(file.read(), str(path), "exec")
    exec(code, module.__dict__)  # noqa: S102 - running the user's file is the purpose
    return module


def _wrong_result(returned: object) -> str:
    if returned is None:
        return f"{FUNCTION}() returns nothing: end it with `return LaunchDescription([...])`"
    what = "the class itself" if returned is LaunchDescription else f"a {type(returned).__name__}"
    return f"{FUNCTION}() returns {what}: write `return LaunchDescription([...])`"


def _with_line(path: Path, error: Exception | SystemExit) -> LaunchFileError:
    """Return an error that shows the line of the launch file that raised `error`."""
    if isinstance(error, LaunchFileError):
        return error
    lines = [
        frame.lineno
        for frame in traceback.extract_tb(error.__traceback__)
        if frame.filename == str(path)
    ]
    line = (lines[-1] if lines else 0) or 0
    absent = missing_file(error)
    if absent is not None:
        return LaunchFileError(str(path), line, str(absent))
    reason = str(error) if isinstance(error, ZbotError) else describe(error)
    hint = getattr(error, "hint", "") or ""
    if not isinstance(error, ZbotError):
        hint = advice(error)
    elif isinstance(error, ImportError):
        reason, hint = corrected_import(reason)
    if isinstance(error, ModuleNotFoundError) and error.name in _EXTRAS:
        hint = f'pip install "zbot[{_EXTRAS[error.name]}]"'
    elif isinstance(error, ModuleNotFoundError) and not (hint or isinstance(error, ZbotError)):
        hint = "`zbot pkg deps` shows what is missing, and where it is"
    return LaunchFileError(str(path), line, reason, hint)
