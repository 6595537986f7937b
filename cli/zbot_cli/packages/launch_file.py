"""Functions that find the launch file of a command line, and complete the command line."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.errors.suggestion import did_you_mean
from zbot.launch.errors import LaunchFileNotFoundError
from zbot.launch.source import AnyLaunchDescriptionSource, check_template
from zbot.package import PackageNameError, PackageNotFoundError, package_share, packages
from zbot.package.symlink_install import files_below

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

_BUNDLED = "zbot"
_ENDINGS = (".py", ".xml", ".yaml", ".yml", ".launch")
_MARKS = (".launch.", "_launch.")


def find(words: Sequence[str]) -> tuple[Path, list[str]]:
    """Return the launch file at the start of a command line, and the arguments after it.

    The command line begins with a path, or with a package and the name of a file in the package, or
    with the name of a launch file of zbot.

    Raises:
        LaunchFileNotFoundError: There is no such file, or there are several.
        TemplateError: There is only the template of the file.
        PackageNotFoundError: There is no such package.
    """
    first, rest = words[0], list(words[1:])
    check_template(Path(first).absolute())
    if Path(first).is_file():
        return Path(first).absolute(), rest
    if rest and ":=" not in rest[0]:
        return in_package(first, rest[0]), rest[1:]
    bundled = [path for path in launch_files(_BUNDLED) if stem(path) == first]
    if bundled:
        return bundled[0], rest
    raise _not_found(first)


def in_package(package: str, name: str) -> Path:
    """Return the launch file of this name from the share folder of a package.

    Raises:
        LaunchFileNotFoundError: The package has no file or several files of that name.
        TemplateError: The package has only the template of the file.
        PackageNotFoundError: There is no such package.
    """
    share = package_share(package)
    files = list(files_below(share))
    found = sorted(path for path in files if path.name == name)
    for path in found or (path for path in files if path.name == f"{name}.in"):
        check_template(path)
    if len(found) > 1:
        listed = ", ".join(f"'{path}'" for path in found)
        raise LaunchFileNotFoundError(
            f"file '{name}' was found more than once in the share directory of package "
            f"'{package}': [{listed}]"
        )
    if not found:
        known = sorted({path.name for path in launch_files(package)})
        raise LaunchFileNotFoundError(
            f"file '{name}' was not found in the share directory of package '{package}' "
            f"which is at '{share}'",
            did_you_mean(name, known) or f"it has {', '.join(known) or 'no launch files'}",
        )
    return found[0]


def launch_files(package: str) -> list[Path]:
    """Return the launch files of a package.

    Raises:
        PackageNotFoundError: There is no such package.
        PackageNameError: The name is not valid for a package.
    """
    return sorted(path for path in files_below(package_share(package)) if _is_launch_file(path))


def _command_for(name: str) -> str:
    """Return how to launch a file of a package that was named without its package."""
    for package in ("zbot_nodes", *packages()):
        with contextlib.suppress(PackageNameError):  # a folder's name need not be valid, e.g. `c`
            if any(path.name == name for path in launch_files(package)):
                return f"type: zbot launch {package} {name}"
    return ""


def stem(path: Path) -> str:
    """Return the name of a launch file without its suffixes, e.g. `temperature`."""
    name = path.name.removesuffix(path.suffix)
    return name.removesuffix(".launch").removesuffix("_launch")


def candidates(done: Sequence[str]) -> Iterable[str]:
    """Return the possible next words of a command line.

    Raises:
        ZbotError: There is no such package, or the launch file is invalid.
    """
    if not done:
        return [*(stem(path) for path in launch_files(_BUNDLED)), *packages()]
    try:
        path, _ = find(done)
    except LaunchFileNotFoundError:
        return [path.name for path in launch_files(done[0])] if len(done) == 1 else []
    from zbot.launch.arguments import declared_arguments  # noqa: PLC0415 - reads launch files

    source = AnyLaunchDescriptionSource(str(path))
    description = source.try_get_launch_description_without_context()
    if description is None:
        return []
    return [
        f"{argument.action.name}:=" for argument in declared_arguments(description, path=str(path))
    ]


def paths(unfinished: str) -> Iterable[str]:
    """Return the paths of launch files, and of folders, that begin with an unfinished word."""
    typed, slash, _ = unfinished.rpartition("/")
    folder = Path(typed or "/") if slash else Path()
    for entry in sorted(folder.iterdir() if folder.is_dir() else ()):
        if entry.is_dir() and not entry.name.startswith("."):
            yield f"{typed}{slash}{entry.name}/"
        elif _is_launch_file(entry.absolute()):
            yield f"{typed}{slash}{entry.name}"


def _is_launch_file(path: Path) -> bool:
    if path.suffix not in _ENDINGS:
        return False
    return any(mark in path.name for mark in _MARKS) or path.parent.name == "launch"


def _not_found(word: str) -> LaunchFileNotFoundError:
    if os.sep in word or word.endswith(_ENDINGS):
        folder, slash, _ = word.rpartition("/")
        hint = _command_for(word) or did_you_mean(word, paths(f"{folder}{slash}"))
        return LaunchFileNotFoundError(f"launch file '{word}' not found", hint=hint)
    try:
        inside = [path.name for path in launch_files(word)]
    except PackageNotFoundError:
        known = [stem(path) for path in launch_files(_BUNDLED)]
        text = f"'{word}' is not a path, a package or the name of a launch file of zbot"
        hint = did_you_mean(word, known) or f"zbot has {', '.join(known)}"
        return LaunchFileNotFoundError(text, hint)
    hint = f"it has {', '.join(inside) or 'none'}"
    return LaunchFileNotFoundError(f"no launch file of package '{word}' is given", hint)
