"""Errors of packages."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.errors.suggestion import nearest, question
from zbot.package.unavailable import Unavailable, unavailable_package, unavailable_packages

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path


#: Pattern of the text of PackageNotFoundError, for the output of other processes.
PACKAGE_NOT_FOUND = re.compile(r"package '(\w+)' not found, searching")


class NotRunnableError(ZbotError):
    """A program is known, but zbot cannot run it, e.g. because it is written in C++.

    A launch leaves the program out and goes on.

    Attributes:
        name: The program.
        sentence: What is left out, why, and what does the same in zbot.
        needed: What a line of a launch file needs and does not get. It is empty if the line itself
            names the program.
    """

    needed = ""

    def __init__(self, name: str, kind: Unavailable) -> None:
        self.name = name
        what, instead, why = kind
        self.sentence = f"{name} is left out: it is {what}, which {why}; {instead}"
        super().__init__(f"{name} {why}: it is {what}; {instead}")


class AbsentFileError(NotRunnableError):
    """A part of a launch needs a file of a well-known package that is not here.

    Args:
        package: The package.
        kind: What it is, and what to use in its place.
        file: The path in the share folder of the package. It is empty if the file is not known.
        name: What the sentence is about, if it is not about the package.
    """

    def __init__(self, package: str, kind: Unavailable, file: str = "", name: str = "") -> None:
        self.file = file
        self.needed = f"{file or 'a file'} of {package}"
        super().__init__(name or package, kind)


class LackingFileError(AbsentFileError):
    """A part of a launch needs a file that zbot's copy of a package does not have.

    Args:
        package: The package.
        file: The path in the share folder of the package.
        others: The names of similar files that the copy has.
    """

    def __init__(self, package: str, file: str, others: Iterable[str]) -> None:
        instead = f"put the sources of {package} into the folder src of your workspace"
        names = ", ".join(others)
        if names:
            instead += f", or use one of {names}"
        kind = Unavailable(f"a file of ROS 2's {package}", instead, "zbot does not have")
        super().__init__(package, kind, file, f"{file} of {package}")


class PackageNotFoundError(ZbotError, KeyError):
    """No package with this name is in the workspace, bundled with zbot, or installed.

    Attributes:
        package: The package's name.
        searched: The folders that were searched.
        hint: Advice for the user, e.g. a similar name.
    """

    def __init__(self, package: str, searched: Iterable[Path], known: Iterable[str] = ()) -> None:
        self.package, self.searched = package, [str(path) for path in searched]
        # Most names end like others, e.g. with `_description`. So only a typo is a similar name.
        near = nearest(package, known) or nearest(package, unavailable_packages(), 1)
        sources = f"put the sources of {package} into the folder src of your workspace"
        self.hint = question([near]) if near else sources
        kind = unavailable_package(package)
        if kind is not None:
            self.hint = f"{package} is {kind.what}, which {kind.why}; {kind.instead}"
        super().__init__(f"package '{package}' not found, searching: {self.searched}")

    def __str__(self) -> str:
        # KeyError.__str__ returns the repr of the message.
        return str(self.args[0])


class PackageNameError(ZbotError, ValueError):
    """A text is not a valid package name, e.g. because it is a path."""

    def __init__(self, package: object) -> None:
        self.package = package
        super().__init__(f"'{package}' is not a valid package name")


class SetupFileError(ZbotError):
    """A package's setup file cannot be read.

    Attributes:
        path: The file.
        reason: What is wrong.
        line: The line, counted from 1. It is 0 if the error is about the whole file.
    """

    def __init__(self, path: Path, reason: str, line: int = 0) -> None:
        self.path, self.reason, self.line = path, reason, line
        where = f"line {line}: " if line else ""
        super().__init__(f"cannot read {path}: {where}{reason}")


class NoGenuineRclpyError(ZbotError):
    """The user wants a genuine rclpy, but this Python has none."""

    def __init__(self) -> None:
        super().__init__(
            "this Python has no genuine rclpy: source ROS 2's setup script, or leave out --genuine"
        )


class WrapperError(ZbotError):
    """The script that stands for a missing program cannot be written."""

    def __init__(self, path: Path, reason: OSError) -> None:
        self.path, self.reason = path, reason
        super().__init__(f"cannot write {path}: {reason.strerror}")
