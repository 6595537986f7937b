"""Assertions about the processes of a launch, with the same names as in launch_testing."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

from zbot.errors import ArgumentTypeError
from zbot.launch.testing.process_lookup import name_of, resolve_processes

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from zbot.launch.actions.execute import ExecuteLocal
    from zbot.launch.testing.record import ExitRecord, OutputRecord

# Exit codes as in a shell: after a signal, the code is 128 + the number of the signal.
EXIT_OK, EXIT_SIGINT, EXIT_SIGQUIT, EXIT_SIGKILL, EXIT_SIGSEGV = 0, 130, 131, 137, 139


def assertInStdout(  # noqa: N802 - launch_testing's name
    proc_output: OutputRecord,
    expected_output: Any,
    process: ExecuteLocal | str | None,
    cmd_args: Any = None,
    **options: Any,
) -> None:
    """Assert that stdout of a process contains a text. The options are those of `OutputRecord.has`.

    Raises:
        AssertionError: The text is missing.
    """
    _assert_in(proc_output, expected_output, process, cmd_args, stream="stdout", **options)


def assertInStderr(  # noqa: N802 - launch_testing's name
    proc_output: OutputRecord,
    expected_output: Any,
    process: ExecuteLocal | str | None,
    cmd_args: Any = None,
    **options: Any,
) -> None:
    """Assert that stderr of a process contains a text. The options are those of `OutputRecord.has`.

    Raises:
        AssertionError: The text is missing.
    """
    _assert_in(proc_output, expected_output, process, cmd_args, stream="stderr", **options)


def _assert_in(
    proc_output: OutputRecord, expected: Any, process: Any, cmd_args: Any, **options: Any
) -> None:
    if not proc_output.has(expected, process, cmd_args, **options):
        names = ", ".join(sorted(proc_output.process_names()))
        who = process if isinstance(process, str) else (process and name_of(process)) or names
        raise AssertionError(f"{expected!r} is not in the {options['stream']} of {who}")


def assertExitCodes(  # noqa: N802 - launch_testing's name
    proc_info: ExitRecord,
    allowable_exit_codes: Sequence[int] = (EXIT_OK,),
    process: ExecuteLocal | str | None = None,
    cmd_args: Any = None,
    *,
    strict_proc_matching: bool = True,
) -> None:
    """Assert that the exit codes of processes are allowed.

    If a signal ended a process, its exit code is the negative number of the signal. An allowed
    code of 128 + the number of the signal, as in a shell, matches too.

    Raises:
        AssertionError: A process has another exit code.
        ArgumentTypeError: An allowed exit code is not an integer.
    """
    for allowed in allowable_exit_codes:
        if not isinstance(allowed, int):
            raise ArgumentTypeError("an exit code", "an int", allowed)
    found = resolve_processes(
        proc_info, process=process, cmd_args=cmd_args, strict_proc_matching=strict_proc_matching
    )
    for action in found:
        code: int | None = getattr(proc_info[action], "returncode", None)
        if code not in allowable_exit_codes and _as_shell(code) not in allowable_exit_codes:
            raise AssertionError(f"process {name_of(action)} exited with code {code}")


def _as_shell(code: int | None) -> int | None:
    return 128 - code if code is not None and code < 0 else code


class SequentialTextChecker:
    """Finds texts in an output. Each text must come after the previous text.

    Args:
        output: The output, in pieces.
    """

    def __init__(self, output: Sequence[str]) -> None:
        self._text = "".join(output)
        self._place = 0

    def assertInStdout(self, msg: str) -> None:  # noqa: N802 - launch_testing's name
        """Assert that a text comes after the texts that were found before.

        Raises:
            AssertionError: The text is missing.
        """
        found = self._text.find(msg, self._place)
        if found < 0:
            near = self.get_nearby_lines()
            raise AssertionError(f"{msg!r} does not come after the texts found before:\n{near}")
        self._place = found + len(msg)

    def get_nearby_lines(self) -> str:
        """Return the line where the last found text ends, two lines before it and two after it."""
        lines = self._text.splitlines()
        reached = self._text[: self._place].count("\n")
        # If the found text ends at the end of a line, use the next line, or else the last line.
        if self._text[self._place : self._place + 1] == "\n":
            reached += 1
        reached = min(reached, len(lines) - 1)
        return "\n".join(lines[max(reached - 2, 0) : reached + 3])

    assertInText = assertInStdout  # noqa: N815 - launch_testing's name


@contextlib.contextmanager
def assertSequentialStdout(  # noqa: N802 - launch_testing's name
    proc_output: OutputRecord, process: ExecuteLocal | str, cmd_args: Any = None
) -> Iterator[SequentialTextChecker]:
    """Yield a `SequentialTextChecker` for the output of one process."""
    found = resolve_processes(proc_output, process=process, cmd_args=cmd_args)[0]
    yield SequentialTextChecker([proc_output.text_of(found)])
