"""`zbot run`: finds an executable and runs it in this process.

It does not use typer, because the words after the executable belong to the node, and because
typer starts slowly.
"""

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
from zbot_cli.commands.run.execution import run_and_exit
from zbot_cli.errors import CommandError
from zbot_cli.output.exit_status import Status
from zbot_cli.packages import executables
from zbot_cli.packages.executables import BUNDLED, Executable, Package

if TYPE_CHECKING:
    import subprocess
    from collections.abc import Callable, Iterable, Sequence

USAGE = """\
Usage: zbot run [--prefix COMMAND] [PACKAGE] EXECUTABLE [ARGS]...
       zbot run [--prefix COMMAND] PATH.py [ARGS]...
       zbot run --where [PACKAGE] EXECUTABLE

  Run a node. The node gets all words after EXECUTABLE, also --ros-args.

Options:
  --prefix COMMAND  Put a command before the program, e.g. --prefix 'nice -n 5'
  --where           Print the file of the program, and do not run it
  -h, --help        Print this text

Examples:
  zbot run sensor
  zbot run my_package my_node --ros-args -r __node:=other -p rate:=2.0"""
#: Places to search for a name, in this order. The first place that has the name is used.
_PLACES: tuple[Callable[[], list[Package]], ...] = (
    executables.workspace_packages,
    executables.bundled_packages,
    executables.installed_packages,
)
# Program that runs the `zbot` command without the current folder on Python's path.
_ZBOT = (
    "import sys; sys.path[:] = filter(None, sys.path); from zbot_cli.__main__ import main; main()"
)


class PackageNotFoundError(ZbotError):
    """No package of that name is in the workspace or installed."""

    def __init__(self, package: str, known: Sequence[str]) -> None:
        self.package = package
        self.hint = _hint(package, known, "`zbot pkg executables` lists the packages with nodes")
        super().__init__(f"Package '{package}' not found")


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
        elif package.has_module(name):
            entry = f"'{name} = {package.name}.{name}:main'"
            hint = f"add {entry} to the console_scripts in {package.name}'s setup.py"
    return CommandError("No executable found", hint=hint)


class CompiledProgramError(NotRunnableError):
    """The executable of a package of the workspace is a C++ program."""

    def __init__(self, name: str, package: str) -> None:
        kind = Unavailable("a C++ program, which needs ROS 2", "zbot runs Python programs")
        super().__init__(f"{name} of package {package}", kind)


def several_executables_error(found: Sequence[Executable]) -> CommandError:
    """Return the error that several packages have an executable of that name."""
    hint = f"name the package too: zbot run {found[0].package} {found[0].name}"
    lines = "".join(f"\n- {one.package} {one.name} ({one.target})" for one in found)
    return CommandError(f"Multiple executables found:{lines}", hint=hint)


def _hint(word: str, known: Iterable[str], otherwise: str) -> str:
    from zbot.errors.suggestion import did_you_mean  # noqa: PLC0415 - only for mistakes

    return did_you_mean(word, known) or otherwise


def run(words: list[str]) -> int | Callable[[], NoReturn]:
    """Find the executable of a command line.

    Args:
        words: The words after `zbot run`.

    Returns:
        A function that runs the executable and ends the process, or an exit code if there is
        nothing left to run. The caller must call the function outside of its error handling.
    """
    prefix: list[str] = []
    only_where = False
    while words and words[0].startswith("-"):
        option, equals, value = words.pop(0).partition("=")
        if option in {"-h", "--help"}:
            print(USAGE)
            return Status.OK
        if option == "--where":
            only_where = True
            continue
        if option != "--prefix":
            _exit_with_usage_error(f"No such option: {option}")
        prefix = _split(value if equals or not words else words.pop(0))
    if not words:
        _exit_with_usage_error("name a node to run: zbot run sensor")
    executable, arguments = find(words)
    note = executables.note_of_others(executable)
    if note:
        print(f"note: {note}", file=sys.stderr)
        os.environ[executables.NOTED_VARIABLE] = "1"
    if only_where:
        file = executables.program_file(executable)
        print(Path(file).absolute() if executables.is_file(file) else file)
        return Status.OK
    if prefix:
        return _run_behind(prefix, words)
    return lambda: run_and_exit(executable, arguments)


def _exit_with_usage_error(text: str) -> NoReturn:
    print(f"{USAGE.splitlines()[0]}\n\nError: {text}", file=sys.stderr)
    sys.exit(Status.USAGE)


def _split(prefix: str) -> list[str]:
    import shlex  # noqa: PLC0415 - seldom used

    try:
        return shlex.split(prefix, posix=os.name != "nt")
    except ValueError as exc:
        raise CommandError(f"cannot read --prefix {prefix!r}: {exc!s}") from None


def find(words: Sequence[str]) -> tuple[Executable, list[str]]:
    """Return the executable at the start of a command line, and the arguments after it.

    Raises:
        CommandError: There is no file of that path, or there is no executable of that name, or
            `words` has no package, and several packages have the executable.
        PackageNotFoundError: There is no package of that name.
    """
    first, rest = words[0], list(words[1:])
    if _is_path(first):
        return _file(first), rest
    seen: list[Package] = []
    for place in _PLACES:
        packages = place()
        seen += packages
        inside = _called(first, packages)
        if inside and rest and (found := _named(rest[0], inside)):
            return _single(found), rest[1:]
        if not inside and (found := _named(first, packages)):
            return _single(found), rest
    return _find_farther(first, rest, seen)


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
    kind = unavailable_package(first)
    if kind is not None and not inside:
        raise NotRunnableError(first, kind)
    if inside:
        _raise_not_found(rest[0] if rest else "", inside)
    if error := _file_error(first, packages):
        raise error
    if rest and not rest[0].startswith("-"):
        raise PackageNotFoundError(first, sorted({one.name for one in packages if one.executables}))
    raise executable_not_found_error(first, _names(packages))


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
    if any(name in package.compiled for package in inside):
        raise CompiledProgramError(name, inside[0].name)
    kind = unavailable_executable(inside[0].name, name)
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
    listed = [one for package in packages for one in package.executables]
    for wanted in (name, f"{name}.py"):
        found = {one.target: one for one in reversed(listed) if one.name == wanted}
        if found:
            return list(reversed(found.values()))
    return []


def _names(packages: Iterable[Package]) -> list[str]:
    return sorted({one.name for package in packages for one in package.executables})


def _single(found: list[Executable]) -> Executable:
    if len(found) > 1:
        raise several_executables_error(found)
    return found[0]


def _run_behind(prefix: list[str], words: list[str]) -> int:
    """Run a prefix such as `nice` or a debugger, which runs `zbot run` with the same words."""
    import shutil  # noqa: PLC0415 - seldom used
    import subprocess  # noqa: PLC0415 - as above

    program = shutil.which(prefix[0])
    if program is None:
        raise CommandError(f"Prefix command '{prefix[0]}' not found")
    command = [*prefix, sys.executable, "-c", _ZBOT, "run", *words]
    sys.stdout.flush()
    if os.name != "nt":
        os.execv(program, command)  # noqa: S606 - the words are the user's own
    return _wait(subprocess.Popen(command))  # noqa: S603 - as above


def _wait(child: subprocess.Popen[bytes]) -> int:
    while True:
        try:
            return child.wait()
        except KeyboardInterrupt:
            continue  # the child process got Ctrl-C too, and ends itself
