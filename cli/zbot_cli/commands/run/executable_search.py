"""Search for the executable that the words after `zbot run` name."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from zbot.errors import ZbotError
from zbot.package.errors import NotRunnableError
from zbot.package.unavailable import Unavailable, unavailable_executable, unavailable_package
from zbot_cli.commands.run import missing_file
from zbot_cli.errors import CommandError
from zbot_cli.packages import executables
from zbot_cli.packages.executables import BUNDLED, Executable, Package

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

#: Places to search for a name, in this order. The first place that has the name is used.
_PLACES: tuple[Callable[[], list[Package]], ...] = (
    executables.workspace_packages,
    executables.bundled_packages,
    executables.installed_packages,
)


def package_not_found_error(package: str, known: Sequence[str]) -> CommandError:
    """Return the error that no package of that name is in the workspace or installed."""
    from zbot.errors.suggestion import correction  # noqa: PLC0415 - only for mistakes

    # Most names end like others, e.g. with `_bringup`. So only a typo is a similar name.
    hint = correction(package, known) or "`zbot pkg executables` lists the packages with nodes"
    return CommandError(f"Package '{package}' not found", hint=hint, package=package)


def executable_not_found_error(
    name: str, known: Sequence[str], packages: Sequence[Package] = ()
) -> CommandError:
    """Return the error that the given package, or any package, has no such executable."""
    otherwise = "`zbot pkg executables` lists the nodes"
    if packages:
        otherwise = f"{packages[0].name} has {', '.join(known) or 'no nodes'}"
        if packages[0].compiled and not known:
            names = ", ".join(sorted(packages[0].compiled))
            otherwise = f"its programs are C++, which zbot does not run: {names}"
    hint = _hint(name, known, otherwise)
    for package in packages:
        if package.fault:
            hint = package.fault
        elif any("=" in executable.target for executable in package.executables):
            hint = "put a comma between the entry points in setup.py"
        elif package.has_module(name):
            entry = f"'{name} = {package.name}.{name}:main'"
            hint = f"add {entry} to the console_scripts in {package.name}'s setup.py"
    return CommandError("No executable found", hint=hint)


def several_executables_error(found: Sequence[Executable]) -> CommandError:
    """Return the error that several packages have an executable of that name."""
    hint = f"name the package too: zbot run {found[0].package} {found[0].name}"
    lines = "".join(
        f"\n- {executable.package} {executable.name} ({executable.target})" for executable in found
    )
    return CommandError(f"Multiple executables found:{lines}", hint=hint)


def _hint(word: str, known: Iterable[str], otherwise: str) -> str:
    from zbot.errors.suggestion import did_you_mean  # noqa: PLC0415 - only for mistakes

    return did_you_mean(word, known) or otherwise


def find(words: Sequence[str]) -> tuple[Executable, list[str]]:
    """Return the executable at the start of a command line, and the arguments after it.

    Raises:
        CommandError: There is no file of that path, or no package or executable of that name, or
            `words` has no package, and several packages have the executable.
    """
    first, rest = words[0], list(words[1:])
    if _is_path(first):
        return _file(first), rest
    # The search for a program reads every package of the workspace. So it is left out for a package
    # of zbot, e.g. for each node that a launch starts.
    is_package = bool(rest) and rest[0][:1] != "-" and executables.is_bundled(first)
    seen: list[Package] = []
    for place in _PLACES:
        packages = place()
        seen += packages
        inside = _called(first, packages)
        if inside and rest and (found := _named(rest[0], inside)):
            return _single(found), rest[1:]
        if not (inside or is_package) and (found := _named(first, packages)):
            return _single(found), rest
    return _find_farther(first, rest, seen)


def find_in_package(package: str, name: str) -> Executable:
    """Return an executable of a package.

    Raises:
        CommandError: There is no package of that name, or it has no executable of that name.
        NotRunnableError: The package or the program is known, and does not run in zbot.
    """
    packages: list[Package] = []
    for place in _PLACES:
        packages += place()
        if found := _named(name, _called(package, packages)):
            return _single(found)
    inside = [*_called(package, packages), *executables.installed_package(package)]
    if found := _named(name, inside):
        return _single(found)
    _raise_if_known(package, name, inside)
    raise _package_missing(package, packages)


def _find_farther(
    first: str, rest: list[str], packages: list[Package]
) -> tuple[Executable, list[str]]:
    inside = [*_called(first, packages), *executables.installed_package(first)]
    if rest and (found := _named(rest[0], inside)):
        return _single(found), rest[1:]
    is_meant = bool(inside and rest and rest[0].isidentifier())  # rest[0] means an executable
    # Otherwise the first word means an executable, even if a package has the same name.
    if not is_meant and (found := _named(first, packages)):
        return _single(found), rest
    _raise_if_known(first, rest[0] if rest else "", inside)
    if error := _file_error(first, packages):
        raise error
    if rest and not rest[0].startswith("-"):
        raise _package_missing(first, packages)
    raise executable_not_found_error(first, _names(packages))


def _raise_if_known(package: str, name: str, inside: list[Package]) -> None:
    """Raise an error if a package exists without the executable, or does not run in zbot."""
    kind = unavailable_package(package)
    if kind is not None and not inside:
        raise NotRunnableError(package, kind)
    if inside:
        _raise_not_found(name, inside)


def _package_missing(name: str, packages: list[Package]) -> CommandError:
    known = {package.name for package in packages if package.executables}
    return package_not_found_error(name, sorted(known))


def _file_error(word: str, packages: list[Package]) -> ZbotError | None:
    """Return an error if a word is no executable, but a file, a folder, or two words in one."""
    match = re.fullmatch(r"(\w+)[.:](\w+)", word)
    if match and _called(match[1], packages):
        hint = f"a package and its program are two words: zbot run {match[1]} {match[2]}"
        return CommandError(f"'{word}' is not a program", hint=hint)
    if Path(f"{word}.py").is_file():
        return CommandError(f"'{word}' is a file", hint=f"type: zbot run {word}.py")
    if Path(word).is_dir():
        return missing_file.folder(Path(word))
    return missing_file.launch_file(word)


def _raise_not_found(name: str, inside: list[Package]) -> NoReturn:
    if missing_file.launch_file(name):
        hint = f"type: zbot launch {inside[0].name} {name}"
        raise CommandError(f"'{name}' is a launch file", hint=hint)
    kind = unavailable_executable(inside[0].name, name)
    if any(name in package.compiled for package in inside):
        kind = Unavailable("a C++ program, which needs ROS 2", "zbot runs Python programs")
    if kind is not None:
        raise NotRunnableError(f"{name} of package {inside[0].name}", kind)
    raise executable_not_found_error(name, _names(inside), inside)


def _called(name: str, packages: Iterable[Package]) -> list[Package]:
    names = {name, BUNDLED} if name == "zbot" else {name}
    return [package for package in packages if package.name in names]


def _is_path(word: str) -> bool:
    return word.endswith(".py") or os.sep in word or (sys.platform == "win32" and "/" in word)


def _file(word: str) -> Executable:
    path = Path(word)
    if not path.is_file():
        raise missing_file.missing_file(word)
    if path.suffix not in {"", ".py"} and (error := missing_file.launch_file(word)):
        raise error
    if path.suffix and not executables.is_python(path):
        raise missing_file.not_python(word)
    # Without a separator, the name of a program that does not end in .py would mean a module.
    target = path if executables.is_file(str(path)) else path.absolute()
    return Executable("", path.name, str(target))


def _named(name: str, packages: Iterable[Package]) -> list[Executable]:
    """Return the executables with a name, each program once.

    If no executable has this name, return the executables that are called `name.py`.
    """
    listed = [executable for package in packages for executable in package.executables]
    for wanted in (name, f"{name}.py"):
        found = {
            executable.target: executable
            for executable in reversed(listed)
            if executable.name == wanted
        }
        if found:
            return list(reversed(found.values()))
    return []


def _names(packages: Iterable[Package]) -> list[str]:
    return sorted({executable.name for package in packages for executable in package.executables})


def _single(found: list[Executable]) -> Executable:
    if len(found) > 1:
        raise several_executables_error(found)
    return found[0]
