"""`zbot run`: finds an executable and runs it in this process.

It does not use typer, because the words after the executable belong to the node, and because
typer starts slowly.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from zbot.errors import ZbotError
from zbot.package.errors import NotRunnableError as NotRunnableError
from zbot.package.unavailable import Unavailable as Unavailable
from zbot.package.unavailable import unavailable_executable as unavailable_executable
from zbot.package.unavailable import unavailable_package as unavailable_package
from zbot_cli.commands.run.executable_search import find
from zbot_cli.commands.run.execution import run_and_exit
from zbot_cli.errors import CommandError
from zbot_cli.output.exit_status import Status
from zbot_cli.packages import executables
from zbot_cli.packages.executables import BUNDLED as BUNDLED
from zbot_cli.packages.executables import Executable
from zbot_cli.packages.executables import Package as Package

if TYPE_CHECKING:
    import subprocess
    from collections.abc import Callable, Sequence

USAGE = """\
Usage: zbot run [OPTIONS] [PACKAGE] EXECUTABLE [ARGS]...
       zbot run [OPTIONS] PATH.py [ARGS]...
       zbot run --where [PACKAGE] EXECUTABLE

  Run a node. The node gets all words after EXECUTABLE, also --ros-args.

Options:
  --prefix COMMAND  Put a command before the program, e.g. --prefix 'nice -n 5'
  --genuine         Let the program use an installed ROS 2 instead of zbot
  --where           Print the file of the program, and do not run it
  -h, --help        Print this text

Examples:
  zbot run sensor
  zbot run my_package my_node --ros-args -r __node:=other -p rate:=2.0"""
# Program that runs the `zbot` command without the current folder on Python's path.
_ZBOT = (
    "import sys; sys.path[:] = filter(None, sys.path); from zbot_cli.__main__ import main; main()"
)


def run(words: list[str]) -> int | Callable[[], NoReturn]:
    """Find the executable of a command line.

    Args:
        words: The words after `zbot run`.

    Returns:
        A function that runs the executable and ends the process, or an exit code if there is
        nothing left to run. The caller must call the function outside of its error handling.
    """
    prefix: list[str] = []
    only_where = is_genuine = False
    while words and words[0].startswith("-"):
        option, equals, value = words.pop(0).partition("=")
        if option in {"-h", "--help"}:
            print(USAGE)
            return Status.OK
        if option == "--where":
            only_where = True
            continue
        if option == "--genuine":
            is_genuine = True
            continue
        if option != "--prefix":
            _exit_with_usage_error(f"No such option: {option}")
        prefix = _split(value if equals or not words else words.pop(0))
    if not words:
        _exit_with_usage_error("name a node to run: zbot run sensor")
    executable, arguments = _find_or_advise(words)
    note = executables.note_of_others(executable)
    if note:
        print(f"note: {note}", file=sys.stderr)
        os.environ[executables.NOTED_VARIABLE] = "1"
    if only_where:
        file = executables.program_file(executable)
        print(Path(file).absolute() if executables.is_file(file) else file)
        return Status.OK
    _choose_rclpy(executable, is_genuine=is_genuine)
    if prefix:
        return _run_behind(prefix, words)
    return lambda: run_and_exit(executable, arguments)


def _choose_rclpy(executable: Executable, *, is_genuine: bool) -> None:
    if executable.target.startswith(f"{BUNDLED}."):
        return  # zbot's own nodes need no rclpy
    from zbot.package.rclpy_choice import choose_rclpy  # noqa: PLC0415 - not needed by bundled nodes

    if note := choose_rclpy(is_genuine=is_genuine):
        print(f"note: {note}", file=sys.stderr)


def _exit_with_usage_error(text: str) -> NoReturn:
    print(f"{USAGE.splitlines()[0]}\n\nError: {text}", file=sys.stderr)
    sys.exit(Status.USAGE)


def _split(prefix: str) -> list[str]:
    import shlex  # noqa: PLC0415 - seldom used

    try:
        return shlex.split(prefix, posix=os.name != "nt")
    except ValueError as exc:
        raise CommandError(f"cannot read --prefix {prefix!r}: {exc!s}") from None


def _find_or_advise(words: Sequence[str]) -> tuple[Executable, list[str]]:
    """Find an executable. The error for words of another command says what to type."""
    try:
        return find(words)
    except ZbotError as error:
        from zbot_cli.commands.wrong_command import advice_for_program  # noqa: PLC0415 - only for mistakes

        error.hint = advice_for_program(words) or error.hint
        raise


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
