"""Log of a topic of diagnostics: the newest status of each name, its history, and the tree."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from enum import IntEnum
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator

#: A status that does not come again for this time is stale, as in rqt_robot_monitor.
STALE_S = 5.0
_MOST_CHANGES = 100
_MOST_NAMES = 2000
# Longest parts of a status. Names, messages and values come from other programs.
_MOST_PARTS = 10
_LONGEST_NAME = 100
_LONGEST_TEXT = 500
_LONGEST_PATH = 2 * _MOST_PARTS * _LONGEST_NAME  # before the parts are cut
_MOST_VALUES = 200
_S_TO_NS = 10**9


class Level(IntEnum):
    """Level of a status. A worse level has a higher number. See `of` for ROS 2's numbers."""

    OK = 0
    WARN = 1
    STALE = 2
    ERROR = 3

    @classmethod
    def of(cls, status: Any) -> Level:
        """Return the level of a `DiagnosticStatus`. An unknown number is an error."""
        known = (cls.OK, cls.WARN, cls.ERROR, cls.STALE)
        number = status.level[0] if status.level else 0
        return known[number] if number < len(known) else cls.ERROR


@dataclass(frozen=True, slots=True)
class Status:
    """The parts of a `DiagnosticStatus` that are shown. Long texts and lists are cut."""

    level: Level
    message: str
    hardware_id: str
    values: tuple[tuple[str, str], ...]  #: keys and values; a key may occur twice

    @classmethod
    def of(cls, status: Any) -> Status:
        """Return the parts of a `DiagnosticStatus`."""
        return cls(
            Level.of(status),
            status.message[:_LONGEST_TEXT],
            status.hardware_id[:_LONGEST_NAME],
            tuple(
                (one.key[:_LONGEST_NAME], one.value[:_LONGEST_TEXT])
                for one in status.values[:_MOST_VALUES]
            ),
        )


def path_of(name: str) -> str:
    """Return the path of a status in the tree: its name without outer slashes.

    Long parts and the parts after the tenth are cut: each part has a branch with its own path.
    """
    parts = [part[:_LONGEST_NAME] for part in name[:_LONGEST_PATH].split("/") if part]
    return "/".join(parts[:_MOST_PARTS]) or "(no name)"


@dataclass(frozen=True, slots=True)
class Change:
    """Begin of a level or a message of a status."""

    time_ns: int
    level: Level
    message: str


@dataclass(slots=True)
class Entry:
    """The newest status of a name."""

    status: Status
    received_ns: int
    changes: deque[Change] = field(default_factory=lambda: deque(maxlen=_MOST_CHANGES))

    def age_s(self, now_ns: int) -> float:
        """Return the seconds since the status has arrived."""
        return max(0.0, (now_ns - self.received_ns) / _S_TO_NS)

    def level(self, now_ns: int) -> Level:
        """Return the level of the status, or STALE if the status is too old."""
        return Level.STALE if self.age_s(now_ns) > STALE_S else self.status.level


@dataclass(slots=True)
class Branch:
    """Line of the tree: a status, or a group without a status of its own."""

    path: str  #: e.g. `Motors/left`
    name: str  #: the last part of the path
    depth: int
    entry: Entry | None = None
    level: Level = Level.OK  #: that of the status, or the worst of the group
    branches: dict[str, Branch] = field(default_factory=dict)

    def worst_first(self) -> Iterator[Branch]:
        """Yield all branches below this one. In each group, the worst comes first."""
        for branch in sorted(self.branches.values(), key=lambda one: (-one.level, one.name)):
            yield branch
            yield from branch.worst_first()


class DiagnosticsLog:
    """Statuses of one topic. It keeps at most 2000 names and 100 changes of each."""

    def __init__(self) -> None:
        self.entries: dict[str, Entry] = {}  #: by path, see `path_of`

    def take(self, message: Any, received_ns: int) -> None:
        """Keep the statuses of a `DiagnosticArray`.

        Args:
            message: The message.
            received_ns: Its time of arrival, in nanoseconds since the epoch.
        """
        for status in message.status:
            path = path_of(status.name)
            entry = self.entries.get(path)
            if entry is None and len(self.entries) >= _MOST_NAMES:
                continue
            self._keep(path, entry, Status.of(status), received_ns)

    def _keep(self, path: str, entry: Entry | None, status: Status, received_ns: int) -> None:
        if entry is None:
            entry = self.entries[path] = Entry(status, received_ns)
        elif entry.age_s(received_ns) > STALE_S:
            since_ns = entry.received_ns + int(STALE_S * _S_TO_NS)
            entry.changes.append(Change(since_ns, Level.STALE, f"no status for {STALE_S:g} s"))
        entry.status, entry.received_ns = status, received_ns
        last = entry.changes[-1] if entry.changes else None
        change = Change(received_ns, status.level, status.message)
        if last is None or (last.level, last.message) != (change.level, change.message):
            entry.changes.append(change)

    def tree(self, now_ns: int) -> Branch:
        """Return the root of the tree of all names."""
        root = Branch("", "", -1)
        for path, entry in self.entries.items():
            branch = root
            for name in path.split("/"):
                inner = f"{branch.path}/{name}".lstrip("/")
                branch = branch.branches.setdefault(name, Branch(inner, name, branch.depth + 1))
            branch.entry = entry
        _set_levels(root, now_ns)
        return root

    def counts(self, now_ns: int) -> dict[Level, int]:
        """Return how many names without names below them have each level, the worst first."""
        groups = {path.rpartition("/")[0] for path in self.entries}
        found = dict.fromkeys(sorted(Level, reverse=True), 0)
        for path, entry in self.entries.items():
            if path not in groups:
                found[entry.level(now_ns)] += 1
        return found


def _set_levels(branch: Branch, now_ns: int) -> None:
    for inner in branch.branches.values():
        _set_levels(inner, now_ns)
    if branch.entry is not None:
        branch.level = branch.entry.level(now_ns)
    else:
        branch.level = max((inner.level for inner in branch.branches.values()), default=Level.OK)
