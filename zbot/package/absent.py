"""Folders for well-known ROS 2 packages that are not here, during a launch.

Launch files ask for the share folders of all packages that they name, also of packages that do not
run in zbot. Such a question must not end the launch, because the other parts of the file can run.
So the question gets the folder in which the package would be. This folder does not exist. A part of
the launch that needs a file in the folder is left out.
"""

from __future__ import annotations

import contextlib
import sys
from contextvars import ContextVar
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.package.errors import AbsentFileError, NotRunnableError
from zbot.package.unavailable import unavailable_package

if TYPE_CHECKING:
    import os
    from collections.abc import Callable, Iterator

#: Function that gets the error of each question for a package that is not here. Without a function,
#: such a question raises PackageNotFoundError, as in every program that is no launch.
_report: ContextVar[Callable[[NotRunnableError], object] | None] = ContextVar(
    "report", default=None
)


@contextlib.contextmanager
def absent_packages_reported(
    report: Callable[[NotRunnableError], object] | None = None,
) -> Iterator[None]:
    """Answer the questions for well-known packages that are not here, and report each question.

    Without `report`, the function of an outer `with` block gets the reports, if there is one.
    """
    token = _report.set(report or _report.get() or (lambda _: None))
    try:
        yield
    finally:
        _report.reset(token)


def absent_prefix(name: str) -> Path | None:
    """Return the prefix in which a package would be, or None if its absence is an error."""
    kind, report = unavailable_package(name), _report.get()
    if kind is None or report is None:
        return None
    report(NotRunnableError(name, kind))
    return Path(sys.prefix)


def absent_file(path: str | os.PathLike[str]) -> AbsentFileError | None:
    """Return an error if a path is in the share folder of a well-known package that is not here."""
    shares = Path(sys.prefix, "share")
    try:
        name, *parts = Path(path).relative_to(shares).parts
    except ValueError:  # it is not below the folder, or it is the folder itself
        return None
    kind = unavailable_package(name)
    if kind is None or (shares / name).exists():
        return None
    return AbsentFileError(name, kind, "/".join(parts))
