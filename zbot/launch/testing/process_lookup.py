"""Which processes a test means: by their action, or by a part of their name."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from zbot.errors import ArgumentTypeError
from zbot.launch.actions.execute import ExecuteLocal
from zbot.launch.substitution import TextSubstitution
from zbot.launch.testing.error import NoMatchingProcessError, SeveralProcessesError

if TYPE_CHECKING:
    from collections.abc import Collection

#: As `cmd_args`: a process that was started without arguments.
NO_CMD_ARGS: Any = object()


class Records(Protocol):
    """What is known of some processes."""

    def processes(self) -> Collection[ExecuteLocal]:
        """Return the processes of which something is known."""
        ...


def resolve_processes(
    info_obj: Records,
    *,
    process: ExecuteLocal | str | None = None,
    cmd_args: Any = None,
    strict_proc_matching: bool = True,
) -> list[ExecuteLocal]:
    """Return the processes that are meant, at least one.

    Args:
        info_obj: Where to look.
        process: An action, a part of a process's name, or `None` for all.
        cmd_args: Arguments that the process must have been started with, or `NO_CMD_ARGS`.
        strict_proc_matching: Refuse a name that several processes match.

    Raises:
        NoMatchingProcessError: Nothing is known of such a process.
        SeveralProcessesError: It is not clear which is meant.
        ArgumentTypeError: `process` is none of the above.
    """
    known = list(info_obj.processes())
    if process is None:
        found = known
    elif isinstance(process, ExecuteLocal):
        found = [one for one in known if one is process]
    elif isinstance(process, str):
        found = [one for one in known if process in name_of(one) and _has_args(one, cmd_args)]
    else:
        raise ArgumentTypeError("process", "an ExecuteProcess or a name", process)
    if not found:
        raise NoMatchingProcessError(_said(process), map(name_of, known))
    if strict_proc_matching and isinstance(process, str) and len(found) > 1:
        raise SeveralProcessesError(_said(process), map(name_of, found))
    return found


def name_of(process: ExecuteLocal) -> str:
    """Return the name of a process, `talker-1`; what it is to run if it has not started."""
    told = process.process_details.get("name")
    if told:
        return str(told)
    if all(isinstance(part, TextSubstitution) for word in process.cmd for part in word):
        return " ".join(part.text for word in process.cmd for part in word)
    return "Unknown"  # what substitutions become is known when it starts


def _said(process: ExecuteLocal | str | None) -> str:
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
