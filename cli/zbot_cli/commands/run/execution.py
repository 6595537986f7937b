"""Where the `zbot` command turns into the program that it was asked to run.

The program takes over this very process: signals, exit code and what `ps` shows are its own, on
Windows too, and nothing is started twice.
"""

from __future__ import annotations

import importlib
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from zbot.errors import ZbotError
from zbot.package.workspace import stay_in_workspace
from zbot_cli.input import interruption
from zbot_cli.packages.executables import is_file

if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import TracebackType

    from zbot_cli.packages.executables import Executable

_HERE = str(Path(__file__).parents[2]) + os.sep


class EntryPointError(ZbotError):
    """A package declares a program that it does not have."""

    def __init__(self, executable: Executable, reason: str) -> None:
        self.executable, self.reason = executable, reason
        self.hint = "zbot build tells where, and what may have been meant"
        where = f"{executable.package} {executable.name}"
        super().__init__(f"cannot run {where} ({executable.target}): {reason}")


def become(executable: Executable, arguments: Sequence[str]) -> NoReturn:
    """Run a program in this process, and end with it.

    Args:
        executable: What to run.
        arguments: Its command line, without its own name.
    """
    import zbot.compat  # noqa: F401, PLC0415 - `import rclpy` and its like are zbot from now on
    from zbot.process import at_exit, signals  # noqa: PLC0415 - Ctrl-C may come from now on

    interruption.raise_exception()
    signals.install(signals.SignalHandlerOptions.SIGINT)
    _leave_out_own_frames()
    stay_in_workspace(_place(executable))
    _set_path(executable)
    try:
        _run(executable, arguments)
    except SystemExit:
        at_exit.wait_for_threads()
        raise


def _run(executable: Executable, arguments: Sequence[str]) -> NoReturn:
    if is_file(executable.target):
        sys.argv = [executable.target, *arguments]
        _run_file(executable.target)
    sys.argv = [executable.name, *arguments]
    try:
        function = _function(executable)
    except EntryPointError as error:
        from zbot_cli.output.report import report  # noqa: PLC0415 - only for errors

        sys.exit(report(error))
    sys.exit(function())


def _place(executable: Executable) -> Path:
    """Return a folder in the workspace that a program is from, if it is from any."""
    if is_file(executable.target):
        return Path(executable.target).parent
    return Path(next(iter(executable.folders), "."))


def _run_file(path: str) -> NoReturn:
    from zbot_cli.commands.run.script import NothingToRunError, run_script  # noqa: PLC0415 - packages do without

    try:
        sys.exit(run_script(path))
    except NothingToRunError as error:
        from zbot_cli.output.report import report  # noqa: PLC0415 - only for errors

        sys.exit(report(error))


def _set_path(executable: Executable) -> None:
    folders = list(executable.folders)
    if is_file(executable.target):
        folders.insert(0, str(Path(executable.target).resolve().parent))
    # Its first entry is the folder of the `zbot` command itself, or the current one: a random.py
    # that lies there must not become everybody's `random`.
    has_own_entry = not getattr(sys.flags, "safe_path", False)
    sys.path[: int(has_own_entry)] = folders


def _function(executable: Executable) -> Any:
    module_name, _, attributes = (part.strip() for part in executable.target.partition(":"))
    try:
        found: Any = importlib.import_module(module_name)
    except ModuleNotFoundError as error:
        if not f"{module_name}.".startswith(f"{error.name}."):
            raise  # the program's own import
        raise EntryPointError(executable, f"there is no module {error.name}") from None
    for name in (attributes or "main").split("."):
        if not hasattr(found, name):
            raise EntryPointError(executable, f"{module_name} has no {name}()")
        found = getattr(found, name)
    return found


def _leave_out_own_frames() -> None:
    """Let tracebacks begin in the program, as if Python had started it."""
    report = sys.excepthook

    def shortened(
        kind: type[BaseException], value: BaseException, trace: TracebackType | None
    ) -> None:
        value.__traceback__ = _below_own(value.__traceback__ or trace)
        report(kind, value, value.__traceback__)

    sys.excepthook = shortened


def _below_own(trace: TracebackType | None) -> TracebackType | None:
    entry, below = trace, trace
    while entry is not None:
        if entry.tb_frame.f_code.co_filename.startswith(_HERE):
            below = entry.tb_next
        entry = entry.tb_next
    while below is not None and below.tb_frame.f_code.co_filename.startswith("<frozen importlib"):
        below = below.tb_next
    return below
