"""Report of the parts of a launch file that cannot run in zbot and are left out."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.package.errors import NotRunnableError, PackageNotFoundError
from zbot.package.unavailable import unavailable_package

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext

_KEY = "zbot_left_out"


def leave_out(context: LaunchContext, error: NotRunnableError) -> None:
    """Log one sentence about what is left out. A launch logs the same sentence only once.

    Raises:
        NotRunnableError: The launch is strict.
    """
    if context.strict:
        raise error
    said: set[str] = context.get_locals_as_dict().get(_KEY, set())
    if error.sentence not in said:
        context.extend_globals({_KEY: said | {error.sentence}})
        context.writer.warning("launch", error.sentence)


def as_not_runnable(error: PackageNotFoundError) -> NotRunnableError | None:
    """Return the error for a well-known package that does not run in zbot.

    Return None for any other package, because the launch must report that this package is missing.
    """
    kind = unavailable_package(error.package)
    return None if kind is None else NotRunnableError(error.package, kind)
