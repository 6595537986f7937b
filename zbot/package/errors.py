"""What can go wrong with packages."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.errors import ZbotError, close_matches

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path


class PackageNotFoundError(ZbotError, KeyError):
    """No package of that name is in the workspace, bundled or installed.

    Attributes:
        package: The name.
        searched: Where it was looked for.
        hint: What may have been meant, if anything is near.
    """

    def __init__(self, package: str, searched: Iterable[Path], known: Iterable[str] = ()) -> None:
        self.package, self.searched = package, [str(path) for path in searched]
        near = close_matches(package, known, 1)
        self.hint = f"did you mean '{near[0]}'?" if near else ""
        super().__init__(f"package '{package}' not found, searching: {self.searched}")

    def __str__(self) -> str:
        # KeyError would print the sentence as a quoted key.
        return str(self.args[0])


class PackageNameError(ZbotError, ValueError):
    """A text cannot be the name of a package, e.g. because it is a path."""

    def __init__(self, package: object) -> None:
        self.package = package
        super().__init__(f"'{package}' is not a valid package name")
