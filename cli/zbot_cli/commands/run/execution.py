"""Execution of a program in the process of `zbot run`.

No second process is started. So the program gets the signals and sets the exit code, also on
Windows, and `ps` shows the program.
"""

from __future__ import annotations

import importlib
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import zbot_name_clash
from zbot.errors import ZbotError
from zbot.package.ros_variables import set_ros_variables
from zbot.package.workspace import set_workspace_variable
from zbot_cli.input import keyboard_interrupt
from zbot_cli.packages.executables import is_file

if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import TracebackType

    from zbot_cli.packages.executables import Executable

_HERE = str(Path(__file__).parents[2]) + os.sep


class EntryPointError(ZbotError):
    """A package declares an entry point that does not exist."""

    def __init__(self, executable: Executable, reason: str) -> None:
        self.executable, self.reason = executable, reason
        self.hint = "run `zbot build`: it shows the entry point's line and similar names"
        where = f"{executable.package} {executable.name}"
        super().__init__(f"cannot run {where} ({executable.target}): {reason}")


def run_and_exit(executable: Executable, arguments: Sequence[str]) -> NoReturn:
    """Run a program in this process, and exit with its exit code.

    Args:
        executable: The program.
        arguments: The arguments of the program.
    """
    import zbot.compat  # noqa: F401, PLC0415 - makes `import rclpy` import zbot
    import zbot.node.node  # noqa: F401, PLC0415 - loaded before the memory is frozen
    from zbot.memory import freeze_garbage_collector  # noqa: PLC0415 - as below
    from zbot.process import at_exit, hooks, signals  # noqa: PLC0415 - during these imports, Ctrl-C ends the process

    keyboard_interrupt.raise_on_ctrl_c()
    signals.install(signals.SignalHandlerOptions.SIGINT)
    hooks.install()
    freeze_garbage_collector()
    _leave_out_own_frames()
    set_ros_variables()
    set_workspace_variable(_folder_of(executable))
    _set_path(executable)
    try:
        _run(executable, arguments)
    except ImportError as error:
        raise keyboard_interrupt.signal_behind(error)  # noqa: B904 - it is the error itself, or its cause
    except SystemExit:
        at_exit.wait_for_threads()
        raise


def _run(executable: Executable, arguments: Sequence[str]) -> NoReturn:
    if is_file(executable.target) and Path(executable.target).is_file():
        sys.argv = [executable.target, *arguments]
        _run_file(executable.target)
    sys.argv = [executable.name, *arguments]
    try:
        function = _function(executable)
    except EntryPointError as error:
        from zbot_cli.output.standard_streams import report  # noqa: PLC0415 - only for errors

        sys.exit(report(error))
    sys.exit(function())


def _folder_of(executable: Executable) -> Path:
    """Return the folder that contains a program. The search for its workspace begins there."""
    if is_file(executable.target):
        return Path(executable.target).parent
    return Path(next(iter(executable.folders), "."))


def _run_file(path: str) -> NoReturn:
    from zbot_cli.commands.run.script import NothingToRunError, run_script  # noqa: PLC0415 - not needed for packages

    try:
        sys.exit(run_script(path))
    except NothingToRunError as error:
        from zbot_cli.output.standard_streams import report  # noqa: PLC0415 - only for errors

        sys.exit(report(error))


def _set_path(executable: Executable) -> None:
    folders = list(executable.folders)
    if is_file(executable.target):
        folders.insert(0, str(_own_folder(Path(executable.target).resolve())))
    # sys.path begins with the folder of the `zbot` command or the current folder. This entry is
    # removed, because a random.py in that folder would replace Python's `random`.
    has_own_entry = not getattr(sys.flags, "safe_path", False)
    sys.path[: int(has_own_entry)] = folders
    zbot_name_clash.watch(folders)


def _own_folder(program: Path) -> Path:
    """Return the folder of a program, where it imports its own modules.

    A program `robot/robot.py` would hide the package `robot`, whose folder it is in. So the result
    is then the folder that has this package. In ROS 2, this program is alone in another folder.
    """
    folder = program.parent
    is_hiding = program.stem == folder.name and (folder / "__init__.py").is_file()
    return folder.parent if is_hiding else folder


def _function(executable: Executable) -> Any:
    if "=" in executable.target:
        raise EntryPointError(executable, "a comma is missing between two entry points in setup.py")
    module_name, _, attributes = (part.strip() for part in executable.target.partition(":"))
    if right := _right_target(module_name, attributes):
        raise EntryPointError(executable, f"write {right} in setup.py")
    try:
        found: Any = importlib.import_module(module_name)
    except ModuleNotFoundError as error:
        if not f"{module_name}.".startswith(f"{error.name}."):
            raise  # an import inside the program failed
        raise EntryPointError(executable, f"there is no module {error.name}") from None
    for name in (attributes or "main").split("."):
        if not hasattr(found, name):
            raise EntryPointError(executable, f"{module_name} has no {name}()")
        found = getattr(found, name)
    return found


def _right_target(module: str, function: str) -> str:
    """Return what to write in place of `robot/talker:main`, `robot.talker:main()` or a module.

    The result is empty if the entry point has the right form.
    """
    right = (
        module.removesuffix(".py").replace("/", ".") + f":{function.removesuffix('()') or 'main'}"
    )
    return "" if right == f"{module}:{function}" else right


def _leave_out_own_frames() -> None:
    """Remove the frames of zbot from tracebacks, so that tracebacks begin in the program."""
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
