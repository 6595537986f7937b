"""Report of the parts of a launch file that cannot run in zbot and are left out."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from zbot.package.absent import absent_file
from zbot.package.errors import AbsentFileError, NotRunnableError
from zbot.package.unavailable import unavailable_package

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import Origin

_KEY = "zbot_left_out"


def leave_out(
    context: LaunchContext, error: NotRunnableError, origin: Origin | None = None
) -> None:
    """Log what is left out and why. A launch logs the same sentence only once.

    Args:
        context: The launch.
        error: What cannot run in zbot.
        origin: The line of the launch file that is left out.

    Raises:
        NotRunnableError: The launch is strict.
    """
    if context.strict:
        raise error
    _say(context, error.sentence)
    if error.needed and origin is not None:
        where = f"{origin.path}:{origin.line}"
        _say(context, f"{where}: this line is left out, because it needs {error.needed}")


def _say(context: LaunchContext, sentence: str) -> None:
    said: set[str] = context.get_locals_as_dict().get(_KEY, set())
    if sentence not in said:
        context.extend_globals({_KEY: said | {sentence}})
        context.writer.warning("launch", sentence)


def missing_file(error: BaseException | None) -> AbsentFileError | None:
    """Return the file of an absent package whose absence caused an error, or None."""
    while error is not None:
        if isinstance(error, AbsentFileError):
            return error
        found = next(filter(None, map(absent_file, _missing_paths(error))), None)
        found = found or _missing_module(error)
        if found is not None:
            return found
        error = error.__cause__ or error.__context__
    return None


def _missing_paths(error: BaseException) -> Iterator[str]:
    """Yield the paths that an error may be about."""
    if isinstance(error, OSError) and isinstance(error.filename, str):
        yield error.filename
    if isinstance(error, ModuleNotFoundError) and error.name:
        # A launch file may add the share folder of a package to Python's path.
        yield from (f"{folder}/{error.name}.py" for folder in sys.path)


def _missing_module(error: BaseException) -> AbsentFileError | None:
    name = error.name if isinstance(error, ModuleNotFoundError) else None
    package = (name or "").partition(".")[0]
    kind = unavailable_package(package)
    return None if kind is None else AbsentFileError(package, kind, f"the module {name}")
