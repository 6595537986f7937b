"""`zbot run`: start a node and become it.

No typer here: the words after the executable belong to the node, and the node should start at once.
"""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from zbot.errors import ZbotError
from zbot_cli.executables import (
    BUNDLED,
    Executable,
    all_executables,
    console_scripts,
    is_path,
)
from zbot_cli.status import Status

if TYPE_CHECKING:
    from collections.abc import Sequence

_USAGE = """\
Usage: zbot run [--prefix COMMAND] [PACKAGE] EXECUTABLE [ARGS]...
       zbot run [--prefix COMMAND] PATH.py [ARGS]...

  Run a node. Everything after the executable is handed to it, --ros-args too.

Options:
  --prefix COMMAND  Put a command before the program, e.g. --prefix 'nice -n 5'
  -h, --help        Print this text

Examples:
  zbot run sensor
  zbot run my_package my_node --ros-args -r __node:=other -p rate:=2.0"""


class PackageNotFoundError(ZbotError):
    """No package of that name is installed or in the workspace."""

    def __init__(self, package: str, known: Sequence[str]) -> None:
        self.package = package
        self.hint = _hint(package, known, f"the packages are: {', '.join(known)}")
        super().__init__(f"Package '{package}' not found")


class ExecutableNotFoundError(ZbotError):
    """A package has no such executable."""

    def __init__(self, name: str, package: str | None, known: Sequence[str]) -> None:
        self.name = name
        where = f"{package} has" if package else "there are"
        self.hint = _hint(name, known, f"{where}: {', '.join(known) or 'none'}")
        super().__init__("No executable found")


class SeveralExecutablesError(ZbotError):
    """A name stands for more than one program."""

    def __init__(self, found: Sequence[Executable]) -> None:
        self.hint = f"name the package too: zbot run {found[0].package} {found[0].name}"
        lines = "".join(f"\n- {one.package} {one.name} ({one.target})" for one in found)
        super().__init__(f"Multiple executables found:{lines}")


class ProgramNotFoundError(ZbotError):
    """A file or prefix command is not there."""

    def __init__(self, what: str, name: str) -> None:
        super().__init__(f"{what} '{name}' not found")


def _hint(word: str, known: Sequence[str], otherwise: str) -> str:
    from zbot.names import nearest  # noqa: PLC0415 - only for mistakes

    guess = nearest(word, known)
    return f"did you mean '{guess}'? {otherwise}" if guess else otherwise


def run(words: list[str]) -> int:
    """Run a node in place of this process; on Windows as a child that is waited for.

    Args:
        words: The words after `zbot run`.

    Returns:
        The node's exit code, where this process lives on.
    """
    prefix: list[str] = []
    while words and words[0].startswith("-"):
        word = words.pop(0)
        if word in {"-h", "--help"}:
            print(_USAGE)
            return Status.OK
        if word != "--prefix" and not word.startswith("--prefix="):
            _refuse(f"No such option: {word}")
        value = word.partition("=")[2] or (words.pop(0) if words else "")
        prefix = shlex.split(value, posix=os.name != "nt")
    if not words:
        _refuse("name a node to run: zbot run sensor")
    executable, arguments = _choose(words)
    return _start([*prefix, *_command(executable), *arguments], bool(prefix))


def _refuse(text: str) -> NoReturn:
    print(f"{_USAGE.splitlines()[0]}\n\nError: {text}", file=sys.stderr)
    sys.exit(Status.USAGE)


def _choose(words: list[str]) -> tuple[Executable, list[str]]:
    if is_path(words[0]):
        return _file(words[0]), words[1:]
    known = all_executables()
    packages = sorted({one.package for one in known})
    if words[0] in packages:
        if len(words) > 1 and not words[1].startswith("-"):
            return _in_package(words[0], words[1], known), words[2:]
        # A package that is named like its only or main node: `zbot run turtlesim`.
        same = [one for one in known if one.name == words[0]]
        if not same:
            names = sorted({one.name for one in known if one.package == words[0]})
            raise ExecutableNotFoundError("", words[0], names)
    named = _distinct(one for one in known if one.name == words[0])
    if named:
        return _single(named), words[1:]
    if len(words) > 1 and not words[1].startswith("-"):
        scripts = console_scripts(words[0])
        if not scripts:
            raise PackageNotFoundError(words[0], packages)
        return _in_package(words[0], words[1], scripts), words[2:]
    names = sorted({one.name for one in known})
    raise ExecutableNotFoundError(words[0], None, names)


def _file(word: str) -> Executable:
    path = Path(word)
    if not path.is_file():
        raise ProgramNotFoundError("File", word)
    return Executable("", path.name, str(path))


def _in_package(package: str, name: str, known: Sequence[Executable]) -> Executable:
    inside = [one for one in known if one.package == package]
    found = [one for one in inside if name in {one.name, one.name.removesuffix(".py")}]
    if not found:
        found = [one for one in console_scripts(package) if one.name == name]
    if not found:
        raise ExecutableNotFoundError(name, package, sorted({one.name for one in inside}))
    return _single(_distinct(found))


def _distinct(found: object) -> list[Executable]:
    by_target: dict[tuple[str, str], Executable] = {}
    for one in sorted(found, key=lambda one: one.package != BUNDLED):  # type: ignore[call-overload]
        by_target.setdefault((one.target, one.folder), one)
    return list(by_target.values())


def _single(found: list[Executable]) -> Executable:
    if len(found) > 1:
        raise SeveralExecutablesError(found)
    return found[0]


def _command(executable: Executable) -> list[str]:
    # -u: what a node prints is on the screen at once, also through a pipe.
    return [sys.executable, "-u", "-m", "zbot_cli.launchpad", executable.target, executable.folder]


def _start(command: list[str], has_prefix: bool) -> int:
    program = shutil.which(command[0])
    if program is None:
        raise ProgramNotFoundError("Prefix command" if has_prefix else "Program", command[0])
    sys.stdout.flush()
    if os.name != "nt":
        os.execv(program, command)  # noqa: S606 - the words are the user's own
    return _wait(subprocess.Popen(command))  # noqa: S603 - as above


def _wait(child: subprocess.Popen[bytes]) -> int:
    while True:
        try:
            return child.wait()
        except KeyboardInterrupt:
            continue  # the child got Ctrl-C too; it decides when to end
