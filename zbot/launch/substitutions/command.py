"""Substitutions for the output of a command and for the path of a program."""

from __future__ import annotations

import os
import shlex
import signal
import subprocess
from typing import TYPE_CHECKING, Final

from zbot.launch.errors import SubstitutionError
from zbot.launch.process_group import send
from zbot.launch.substitution import Substitution, describe, normalize, perform
from zbot.package.absent import absent_file
from zbot.package.errors import PACKAGE_NOT_FOUND, AbsentFileError
from zbot.package.unavailable import unavailable_package
from zbot.package.zbot_command import find_on_path
from zbot.threads.foreign_call import without_interruption

if TYPE_CHECKING:
    from zbot.launch.context import LaunchContext
    from zbot.launch.substitution import SomeSubstitutionsType


_SIGKILL: Final = int(getattr(signal, "SIGKILL", signal.SIGTERM))


class Command(Substitution):
    """The text that a command prints to stdout.

    Args:
        command: The command line.
        on_stderr: What to do with text on stderr: `fail`, `ignore`, `warn` or `capture`.
    """

    def __init__(
        self, command: SomeSubstitutionsType, *, on_stderr: SomeSubstitutionsType = "fail"
    ) -> None:
        self.command, self.on_stderr = normalize(command), normalize(on_stderr)

    def perform(self, context: LaunchContext) -> str:
        """Run the command and return its output.

        Raises:
            AbsentFileError: The command fails because it needs a file of a well-known package that
                does not run in zbot.
            SubstitutionError: The command cannot start, or it fails. With `fail`, output on stderr
                is an error too.
        """
        line = perform(context, self.command)
        mode = perform(context, self.on_stderr)
        done = self._run(line, context)
        if done.returncode:
            output = done.stderr.strip() or done.stdout.strip()
            absent = _absent_file(line, output)
            if absent is not None:
                raise absent
            reason = _without_traceback(output)
            raise SubstitutionError(f"command '{line}' failed with {done.returncode}: {reason}")
        if done.stderr and mode == "capture":
            return done.stdout + done.stderr
        if done.stderr and mode == "fail":
            raise SubstitutionError(f"command '{line}' printed to stderr: {done.stderr.strip()}")
        if done.stderr and mode == "warn":
            context.writer.warning("launch", f"command '{line}': {done.stderr.strip()}")
        return done.stdout

    def _run(self, line: str, context: LaunchContext) -> subprocess.CompletedProcess[str]:
        try:
            words = shlex.split(line, posix=os.name != "nt")
            words[0] = find_on_path(words[0], context.environment) or words[0]
            return _run_to_end(words, context)
        except (OSError, ValueError, IndexError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            raise SubstitutionError(f"cannot run command '{line}': {reason}") from error

    def describe(self) -> str:
        """Return the command line."""
        return f"Command({describe(self.command)})"


def _run_to_end(words: list[str], context: LaunchContext) -> subprocess.CompletedProcess[str]:
    """Run a command. If a signal ends the launch meanwhile, end the command and its children."""
    # Ctrl-C in a terminal reaches the children of the command, and they may ask the user.
    has_group = context.noninteractive and os.name != "nt"
    # An interruption would leave a child that nobody ends.
    child = without_interruption(
        subprocess.Popen,
        words,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=context.environment,
        start_new_session=has_group,
    )
    with child:
        try:
            output, errors = child.communicate()
        except BaseException:
            if has_group:
                send(child.pid, _SIGKILL)
            else:
                child.kill()
            raise
    return subprocess.CompletedProcess(words, child.returncode, output, errors)


def _without_traceback(output: str) -> str:
    """Return the output of a command. Of Python's traceback, return only the error at its end."""
    begin = "Traceback (most recent call last):"
    if begin not in output:
        return output
    lines = output.rpartition(begin)[2].splitlines()
    return "\n".join(line for line in lines if line and not line.startswith(" "))


def _absent_file(line: str, output: str) -> AbsentFileError | None:
    """Return the file of an absent package that a failed command needed, or None."""
    for word in line.split():
        found = absent_file(word)
        if found is not None:
            return found
    # The command may be `xacro`, and its file may use the share folder of a package.
    named = PACKAGE_NOT_FOUND.search(output)
    kind = unavailable_package(named[1]) if named else None
    return AbsentFileError(named[1], kind) if named and kind else None


class FindExecutable(Substitution):
    """The path of a program on the PATH. If `ros2` is missing, a script that runs zbot is used."""

    def __init__(self, *, name: SomeSubstitutionsType) -> None:
        self.name = normalize(name)

    def perform(self, context: LaunchContext) -> str:
        """Return the path.

        Raises:
            SubstitutionError: The program does not exist.
        """
        name = perform(context, self.name)
        path = find_on_path(name, context.environment)
        if path is None:
            raise SubstitutionError(f"executable '{name}' not found on the PATH")
        return path

    def describe(self) -> str:
        """Return the name."""
        return f"FindExec({describe(self.name)})"
