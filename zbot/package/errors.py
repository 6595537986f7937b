"""Errors of packages."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.errors import ZbotError, close_matches

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path


class PackageNotFoundError(ZbotError, KeyError):
    """A package is neither in the workspace, nor bundled, nor installed.

    Attributes:
        package: The package's name.
        searched: The folders that were searched.
        hint: A question that suggests a similar name. Empty if there is no similar name.
    """

    def __init__(self, package: str, searched: Iterable[Path], known: Iterable[str] = ()) -> None:
        self.package, self.searched = package, [str(path) for path in searched]
        near = close_matches(package, known, 1)
        self.hint = f"did you mean '{near[0]}'?" if near else ""
        super().__init__(f"package '{package}' not found, searching: {self.searched}")

    def __str__(self) -> str:
        # KeyError.__str__ returns the repr of the message.
        return str(self.args[0])


class PackageNameError(ZbotError, ValueError):
    """A text is not a valid package name, e.g. because it is a path."""

    def __init__(self, package: object) -> None:
        self.package = package
        super().__init__(f"'{package}' is not a valid package name")
