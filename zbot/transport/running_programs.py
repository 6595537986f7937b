"""Registry of this user's running programs: a file for each open session, with its class.

A program reads the membership file when it starts. If the machine joins or leaves a class later,
the program does not notice this, and the class does not see the program. The registry finds such
programs. Each file is locked while its session is open. So a file without a lock belongs to a
program that was killed.
"""

from __future__ import annotations

import contextlib
import json
import os
import time
from dataclasses import asdict, dataclass, field, fields
from typing import TYPE_CHECKING, Any

from zbot.json_reader import read_json_object
from zbot.names import is_hidden
from zbot.threads.deadline import poll
from zbot.transport import background_process, environment, membership
from zbot.transport.process_facts import command_line
from zbot.transport.process_space import process_space
from zbot.transport.process_state import is_stopped

if TYPE_CHECKING:
    from pathlib import Path
    from typing import IO

    from zbot.transport.membership import Membership

_FOLDER = "programs"
_LOCK_TIMEOUT_S = 0.2  # another program may hold the lock for a moment to read the file
_PAUSE_S = 0.005
_YOUNG_S = 5.0  # a younger file may not be locked yet
_MOST_LISTED = 5


@dataclass(frozen=True)
class RunningProgram:
    """A program with an open session."""

    pid: int
    space: str  #: see `process_space`
    command: str
    domain: int
    is_tool: bool  #: whether it is a command, which may work in any domain
    in_class: bool
    class_name: str
    login: str  #: see `membership.login`
    hidden_by: str  #: settings that hide the program's nodes from the class or hub, or `""`
    nodes: list[str] = field(default_factory=list)  #: full names

    @property
    def visible_nodes(self) -> list[str]:
        """The full names of the nodes that lists show."""
        return [name for name in self.nodes if not is_hidden(name)]

    def reason(self, joined: Membership | None) -> str:
        """Return why a class or hub does not see the program's nodes, or `""` if it sees them."""
        if self.login != membership.login(joined) or self.in_class != (
            joined is not None and joined.in_class
        ):
            left = f'class "{self.class_name}"' if self.in_class else "no class"
            return f"it started when this machine was in {left}"
        if joined is not None and self.hidden_by:
            return self.hidden_by
        is_student = joined is not None and joined.role == "student"
        if is_student and not self.is_tool and joined is not None and self.domain != joined.number:
            return f"it uses domain {self.domain}"
        return ""


class Registration:
    """File of one program in the registry.

    Args:
        domain: The domain of the program's session.
        is_tool: Whether the program is a command, which may work in any domain.
    """

    def __init__(self, domain: int, *, is_tool: bool) -> None:
        joined = membership.load()
        hidden = [one.setting for one in environment.differences() if one.hides]
        self._program = RunningProgram(
            pid=os.getpid(),
            space=process_space(),
            command=command_line(),
            domain=domain,
            is_tool=is_tool,
            in_class=joined is not None and joined.in_class,
            class_name=joined.class_name if joined is not None else "",
            login=membership.login(joined),
            hidden_by=", ".join(hidden),
        )
        self._path = _folder() / f"{os.getpid()}-{os.urandom(4).hex()}.json"
        self._file: IO[str] | None = None
        with contextlib.suppress(OSError):  # the folder is read-only
            self._file = _locked_file(self._path)
            self._write()

    def add(self, node: str) -> None:
        """Add a node's full name."""
        self._program.nodes.append(node)
        self._write()

    def remove(self, node: str) -> None:
        """Remove a node's full name."""
        with contextlib.suppress(ValueError):
            self._program.nodes.remove(node)
        self._write()

    def _write(self) -> None:
        if self._file is not None:
            with contextlib.suppress(OSError):  # the disk is full
                self._file.seek(0)
                self._file.truncate()
                self._file.write(json.dumps(asdict(self._program)))
                self._file.flush()

    def leave_to_parent(self) -> None:
        """In a forked child, let go of the file. Otherwise the child would keep it locked."""
        if self._file is not None:
            os.close(self._file.fileno())

    def close(self) -> None:
        """Remove the file."""
        file, self._file = self._file, None
        if file is not None:
            with contextlib.suppress(OSError):
                file.close()
                self._path.unlink(missing_ok=True)


def _folder() -> Path:
    return membership.folder() / _FOLDER


def _locked_file(path: Path) -> IO[str]:
    # The import of `make_private_folder` would take 8 ms.
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)
    file = os.fdopen(descriptor, "w+", encoding="utf-8")
    poll(lambda: background_process.lock(file), _LOCK_TIMEOUT_S, _PAUSE_S)
    return file


def running() -> list[RunningProgram]:
    """Return this user's running programs on this machine, without this process."""
    try:
        paths = sorted(_folder().glob("*.json"))
    except OSError:
        return []
    found = [_read(path) for path in paths]
    here = process_space()
    return [one for one in found if one and one.space == here and one.pid != os.getpid()]


def _read(path: Path) -> RunningProgram | None:
    """Return the program of a file. If the program has ended, remove the file."""
    try:
        with path.open("r+", encoding="utf-8") as file:
            is_over = background_process.lock(file)
            document: dict[str, Any] = read_json_object(file.read()) if not is_over else {}
        if is_over and time.time() - path.stat().st_mtime > _YOUNG_S:
            path.unlink()
        known = {one.name for one in fields(RunningProgram)}
        return (
            None if is_over else RunningProgram(**{k: document[k] for k in known & set(document)})
        )
    except (OSError, ValueError, TypeError):
        return None  # the program ends or writes the file at this moment


def outside() -> list[RunningProgram]:
    """Return the running programs whose nodes this machine's class or hub does not see.

    If the machine has left a class, these are the programs that still use the class.
    """
    joined = membership.load()
    return [one for one in running() if one.nodes and one.reason(joined)]


def outside_text() -> str:
    """Return a sentence about the programs of `outside()` and what to do, or `""` if none run."""
    programs, joined = outside(), membership.load()
    if not programs:
        return ""
    count = sum(len(one.nodes) for one in programs)
    place = f"outside {environment.place(joined)}" if joined else "in a class that was left"
    listed = [_described(one, joined) for one in programs]
    more = f"; and {len(listed) - _MOST_LISTED} more" if len(listed) > _MOST_LISTED else ""
    return (
        f"{count} node{'' if count == 1 else 's'} of this machine run{'s' * (count == 1)} {place}: "
        f"{'; '.join(listed[:_MOST_LISTED])}{more}. End them and start them again"
    )


def _described(program: RunningProgram, joined: Membership | None) -> str:
    names = ", ".join(program.visible_nodes[:_MOST_LISTED]) or program.command
    return f"{names} (process {program.pid}: {program.reason(joined)})"


def stopped_text(domain: int, node: str = "") -> str:
    """Return a sentence about programs that Ctrl-Z has stopped, and what to do, or `""`.

    Args:
        domain: The domain of the programs.
        node: The full name of a node. If it is given, only programs with this node count.
    """
    found = [
        one
        for one in running()
        if one.domain == domain
        and (node in one.nodes if node else one.visible_nodes)
        and is_stopped(one.pid)
    ]
    if not found:
        return ""
    listed = (f"{', '.join(one.visible_nodes)} (process {one.pid})" for one in found)
    return (
        f"{'; '.join(listed)} {'is' if len(found) == 1 else 'are'} stopped, e.g. by Ctrl-Z: type "
        f"`fg` in the terminal, or `kill -9 {' '.join(str(one.pid) for one in found)}`"
    )


def elsewhere_text(domain: int) -> str:
    """Return a sentence about this machine's nodes of other domains, or `""` if there are none."""
    found: dict[int, list[str]] = {}
    for one in running():
        if one.domain != domain:
            found.setdefault(one.domain, []).extend(one.visible_nodes)
    places = [
        f"{', '.join(names[:_MOST_LISTED])} in domain {number}: set ZBOT_DOMAIN_ID={number}"
        for number, names in sorted(found.items())
        if names
    ]
    return f"this machine runs {'; '.join(places[:_MOST_LISTED])}" if places else ""
