"""Error of bundles."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.classroom.errors import ClassroomError

if TYPE_CHECKING:
    from pathlib import Path


class BundleError(ClassroomError):
    """A bundle cannot be made, read or served. The message says why."""


def file_error(path: Path | str, error: OSError) -> BundleError:
    """Return the error that the system cannot read or write a file of a bundle."""
    return BundleError(f"{path}: {error.strerror or error}")
