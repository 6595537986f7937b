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

from zbot.errors.suggestion import nearest
from zbot.package.bundled_nodes import BUNDLED_NODES
from zbot.package.errors import AbsentFileError, LackingFileError, NotRunnableError
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
    """Return an error if a path is in the share folder of a well-known package that is not here.

    A file that is not in zbot's copy of a package is an error too, unless the path has a typo.
    """
    return _of_absent_package(path) or _lacking_file(Path(path))


def _lacking_file(path: Path) -> LackingFileError | None:
    names = [name for name in path.parts if name in BUNDLED_NODES]
    if not names or path.exists():
        return None
    from zbot.package.finder import Origin, find_package  # noqa: PLC0415 - slow to import
    from zbot.package.symlink_install import share_folder  # noqa: PLC0415 - as above

    for name in names:
        package = find_package(name)
        if package is None or package.origin is not Origin.BUNDLED:
            continue
        share = share_folder(package)
        if path.is_relative_to(share) and path != share:
            others = sorted(file.name for file in path.parent.glob(f"*{path.suffix}"))
            file = path.relative_to(share).as_posix()
            return None if nearest(path.name, others) else LackingFileError(name, file, others)
    return None


def _of_absent_package(path: str | os.PathLike[str]) -> AbsentFileError | None:
    shares = Path(sys.prefix, "share")
    try:
        name, *parts = Path(path).relative_to(shares).parts
    except ValueError:  # it is not below the folder, or it is the folder itself
        return None
    kind = unavailable_package(name)
    if kind is None or (shares / name).exists():
        return None
    return AbsentFileError(name, kind, "/".join(parts))
