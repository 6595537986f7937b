"""Registry of this user's running programs: a file for each open session, with its class.

A program reads the membership file when it starts. If the machine joins or leaves a class later,
the program does not notice this, and the class does not see the program. The registry finds such
programs.
"""

from __future__ import annotations

import os
import threading
from dataclasses import asdict, dataclass, field, fields
from typing import TYPE_CHECKING, Any

from zbot.names import is_hidden
from zbot.transport import environment, membership, router_process
from zbot.transport.other_version import other_versions_text
from zbot.transport.process_facts import command_line, process_space
from zbot.transport.program_file import ProgramFile, program_documents
from zbot.version import __version__

if TYPE_CHECKING:
    from collections.abc import Set
    from pathlib import Path

    from zbot.transport.membership import Membership

_FOLDER = "programs"
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
    version: str = ""  #: of zbot; empty if the program does not say it

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
        hidden = [
            difference.setting for difference in environment.differences() if difference.hides
        ]
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
            version=__version__,
        )
        self._file = ProgramFile(_folder())
        self._lock = threading.RLock()  # re-entrant, because a signal handler may make a node
        self._write()

    def add(self, node: str) -> None:
        """Add a node's full name."""
        with self._lock:
            self._program.nodes.append(node)
            self._write()

    def remove(self, node: str) -> None:
        """Remove a node's full name."""
        with self._lock:
            if node in self._program.nodes:
                self._program.nodes.remove(node)
            self._write()

    def _write(self) -> None:
        self._file.write(asdict(self._program))

    def leave_to_parent(self) -> None:
        """In a forked child, let go of the file. Otherwise the child would keep it locked."""
        self._file.leave_to_parent()

    def close(self) -> None:
        """Remove the file."""
        self._file.close()


def _folder() -> Path:
    return membership.folder() / _FOLDER


def running() -> list[RunningProgram]:
    """Return this user's running programs on this machine, without this process."""
    found = [_program(document) for document in program_documents(_folder())]
    here = process_space()
    return [
        program
        for program in found
        if program and program.space == here and program.pid != os.getpid()
    ]


def _program(document: dict[str, Any]) -> RunningProgram | None:
    known = {part.name for part in fields(RunningProgram)}
    try:
        return RunningProgram(**{name: document[name] for name in known & set(document)})
    except TypeError:
        return None  # another version of zbot wrote the file


def outside() -> list[RunningProgram]:
    """Return the running programs whose nodes this machine's class or hub does not see.

    If the machine has left a class, these are the programs that still use the class.
    """
    joined = membership.load()
    return [program for program in running() if program.nodes and program.reason(joined)]


def outside_text() -> str:
    """Return a sentence about the programs of `outside()` and what to do, or `""` if none run."""
    programs, joined = outside(), membership.load()
    if not programs:
        return ""
    count = sum(len(program.nodes) for program in programs)
    place = f"outside {environment.place(joined)}" if joined else "in a class that was left"
    listed = [_described(program, joined) for program in programs]
    more = f"; and {len(listed) - _MOST_LISTED} more" if len(listed) > _MOST_LISTED else ""
    return (
        f"{count} node{'' if count == 1 else 's'} of this machine run{'s' * (count == 1)} {place}: "
        f"{'; '.join(listed[:_MOST_LISTED])}{more}. End them and start them again"
    )


def _described(program: RunningProgram, joined: Membership | None) -> str:
    names = ", ".join(program.visible_nodes[:_MOST_LISTED]) or program.command
    return f"{names} (process {program.pid}: {program.reason(joined)})"


def stopped(domain: int, nodes: Set[str] | None = None) -> list[RunningProgram]:
    """Return the programs of a domain that Ctrl-Z has stopped.

    Args:
        domain: The domain.
        nodes: Full names of nodes. Only programs with one of them count. `None` means programs with
            any visible node.
    """
    return [
        program
        for program in running()
        if program.domain == domain
        and (program.visible_nodes if nodes is None else not nodes.isdisjoint(program.nodes))
        and router_process.is_stopped(program.pid)
    ]


def stopped_text(programs: list[RunningProgram]) -> str:
    """Return a sentence about stopped programs and what to do, or `""` if there are none."""
    if not programs:
        return ""
    listed = (f"{', '.join(program.visible_nodes)} (process {program.pid})" for program in programs)
    return (
        f"{'; '.join(listed)} {'is' if len(programs) == 1 else 'are'} stopped, e.g. by Ctrl-Z: "
        "type `fg` in the terminal, or "
        f"`kill -9 {' '.join(str(program.pid) for program in programs)}`"
    )


def versions_text(domain: int) -> str:
    """Return a sentence about this machine's programs with another version of zbot, or `""`."""
    versions = {}
    for program in running():
        if program.domain == domain and program.visible_nodes:
            names = ", ".join(program.visible_nodes[:_MOST_LISTED])
            versions[f"{names} (process {program.pid})"] = program.version
    return other_versions_text(versions)


def elsewhere_text(domain: int) -> str:
    """Return a sentence about this machine's nodes of other domains, or `""` if there are none."""
    found: dict[int, list[str]] = {}
    for program in running():
        if program.domain != domain:
            found.setdefault(program.domain, []).extend(program.visible_nodes)
    joined = membership.load()
    is_student = joined is not None and joined.role == "student"  # the number is the domain
    places = [
        f"{', '.join(names[:_MOST_LISTED])} in domain {number}"
        f"{'' if is_student else f': set ZBOT_DOMAIN_ID={number}'}"
        for number, names in sorted(found.items())
        if names
    ]
    return f"this machine runs {'; '.join(places[:_MOST_LISTED])}" if places else ""
