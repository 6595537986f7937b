"""Lookup of processes by their action or by a part of their name."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from zbot.errors import ArgumentTypeError
from zbot.launch.actions.execute import ExecuteLocal
from zbot.launch.substitution import TextSubstitution
from zbot.launch.testing.error import NoMatchingProcessError, SeveralProcessesError

if TYPE_CHECKING:
    from collections.abc import Collection

#: Value of `cmd_args` that selects processes without arguments.
NO_CMD_ARGS: Any = object()


class Records(Protocol):
    """Interface of objects that store the output or the exits of processes."""

    def processes(self) -> Collection[ExecuteLocal]:
        """Return the processes that were started."""
        ...


def resolve_processes(
    info_obj: Records,
    *,
    process: ExecuteLocal | str | None = None,
    cmd_args: Any = None,
    strict_proc_matching: bool = True,
) -> list[ExecuteLocal]:
    """Return the matching processes. The list has at least one process.

    Args:
        info_obj: The records to search.
        process: An action, a part of a process's name, or `None` for all processes.
        cmd_args: If `process` is a name: arguments that the process must have, or `NO_CMD_ARGS`.
        strict_proc_matching: Whether it is an error if several processes match a name.

    Raises:
        NoMatchingProcessError: No process matches.
        SeveralProcessesError: Several processes match the name.
        ArgumentTypeError: `process` has another type.
    """
    known = list(info_obj.processes())
    if process is None:
        found = known
    elif isinstance(process, ExecuteLocal):
        found = [action for action in known if action is process]
    elif isinstance(process, str):
        found = [
            action for action in known if process in name_of(action) and _has_args(action, cmd_args)
        ]
    else:
        raise ArgumentTypeError("process", "an ExecuteProcess or a name", process)
    if not found:
        raise NoMatchingProcessError(_described(process), map(name_of, known))
    if strict_proc_matching and isinstance(process, str) and len(found) > 1:
        raise SeveralProcessesError(_described(process), map(name_of, found))
    return found


def name_of(process: ExecuteLocal) -> str:
    """Return the label of a process, e.g. `talker-1`. Before its start, return the command line."""
    name = process.process_details.get("name")
    if name:
        return str(name)
    if all(isinstance(part, TextSubstitution) for word in process.cmd for part in word):
        return " ".join(part.text for word in process.cmd for part in word)
    return "Unknown"  # substitutions have no text before the start


def _described(process: ExecuteLocal | str | None) -> str:
    if process is None:
        return ""
    return repr(process) if isinstance(process, str) else name_of(process)


def _has_args(process: ExecuteLocal, cmd_args: Any) -> bool:
    given = process.process_details["cmd"][1:]
    if cmd_args is None:
        return True
    if cmd_args is NO_CMD_ARGS:
        return not given
    wanted = [cmd_args] if isinstance(cmd_args, str) else cmd_args
    return all(word in given for word in wanted)
