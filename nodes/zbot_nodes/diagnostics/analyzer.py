"""Analyzers, which group the diagnostics of a robot and summarize each group."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.errors import WrongValueError

from diagnostic_msgs.msg import DiagnosticStatus, KeyValue

if TYPE_CHECKING:
    from collections.abc import Mapping

#: Levels are single bytes, as in rclpy. A higher value is a worse level.
OK, WARN = DiagnosticStatus.OK, DiagnosticStatus.WARN
ERROR, STALE = DiagnosticStatus.ERROR, DiagnosticStatus.STALE
_WORDS = {OK: "OK", WARN: "Warning", ERROR: "Error", STALE: "Stale"}
_PACKAGE = "diagnostic_aggregator/"
_TIMEOUT_S = 5.0


@dataclass
class Item:
    """Last received status with a certain name."""

    status: DiagnosticStatus
    received_s: float


@dataclass
class Analyzer:
    """Analyzer of the statuses whose names match its rules."""

    path: str  #: path of the analyzer's summary, e.g. `/Robot/Motors`
    timeout_s: float = _TIMEOUT_S
    count: int = -1  #: expected number of statuses; -1 is any
    discards_stale: bool = False
    startswith: tuple[str, ...] = ()
    contains: tuple[str, ...] = ()
    names: tuple[str, ...] = ()
    expected: tuple[str, ...] = ()
    patterns: tuple[re.Pattern[str], ...] = ()
    removed: tuple[str, ...] = ()  #: beginnings that are removed from names
    items: dict[str, Item] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """The last part of the path."""
        return self.path.rpartition("/")[2]

    def matches(self, name: str) -> bool:
        """Return whether a name matches the rules."""
        return (
            name.startswith(self.startswith or ("\0",))
            or any(part in name for part in self.contains)
            or name in self.names
            or name in self.expected
            or any(pattern.fullmatch(name) for pattern in self.patterns)
        )

    def analyze(self, status: DiagnosticStatus, now_s: float) -> bool:
        """Store a status if its name matches. Return whether the name matches."""
        if not self.matches(status.name):
            return False
        self.items[status.name] = Item(status, now_s)
        return True

    def report(self, now_s: float) -> list[DiagnosticStatus]:
        """Return the summary, and the statuses with the analyzer's path."""
        header = DiagnosticStatus(name=self.path, level=OK)
        found = [header]
        levels = []
        for name, item in sorted(self.items.items()):
            is_stale = self.timeout_s > 0 and now_s - item.received_s > self.timeout_s
            if is_stale and self.discards_stale:
                del self.items[name]
                continue
            shown = self._shown(item.status, is_stale=is_stale)
            levels.append(shown.level)
            header.values.append(KeyValue(key=name, value=item.status.message))
            found.append(shown)
        header.level = _summary(levels, if_empty=OK if self.discards_stale else STALE)
        header.message = _WORDS[header.level]
        self._check_count(header)
        return found + self._missing(header)

    def _shown(self, status: DiagnosticStatus, *, is_stale: bool) -> DiagnosticStatus:
        return DiagnosticStatus(
            level=STALE if is_stale else min(max(status.level, OK), STALE),
            name=f"{self.path}/{self._shortened(status.name)}",
            message=status.message,
            hardware_id=status.hardware_id,
            values=status.values,
        )

    def _shortened(self, name: str) -> str:
        """Return a name without slashes, and without a beginning that is in `removed`."""
        name = name.replace("/", " ")
        for start in (beginning.replace("/", " ") for beginning in self.removed):
            if start and name.startswith(start):
                name = name.removeprefix(start).removeprefix(":").lstrip(" ")
        return name

    def _check_count(self, header: DiagnosticStatus) -> None:
        found = len(self.items)
        if self.count == 0 and not found:
            header.level, header.message = OK, "OK"
        elif 0 < self.count != found:
            header.level = max(ERROR, header.level)
            text = f"Expected {self.count}, found {found}"
            header.message = text if found else f"No items found, expected {self.count}"

    def _missing(self, header: DiagnosticStatus) -> list[DiagnosticStatus]:
        """Return a status for each expected name that is missing. Add the names to the summary."""
        missing = [name for name in self.expected if name not in self.items]
        if missing:
            is_stale = header.level == STALE
            header.level = STALE if is_stale else ERROR
            header.message = "All Stale" if is_stale else "Error"
            header.values += [KeyValue(key=name, value="Missing") for name in missing]
        return [
            DiagnosticStatus(
                level=STALE, name=f"{self.path}/{self._shortened(name)}", message="Missing"
            )
            for name in missing
        ]


@dataclass
class DiscardAnalyzer(Analyzer):
    """Analyzer whose statuses are not reported."""

    def report(self, now_s: float) -> list[DiagnosticStatus]:
        """Return an empty list."""
        del now_s
        return []


@dataclass
class OtherAnalyzer(Analyzer):
    """Analyzer of the statuses that match no other analyzer."""

    as_errors: bool = False  #: whether such a status is an error

    def matches(self, name: str) -> bool:
        """Return True."""
        del name
        return True

    def report(self, now_s: float) -> list[DiagnosticStatus]:
        """Return the summary and the statuses, or an empty list if there is no status."""
        found = super().report(now_s)
        if len(found) == 1:
            return []
        if self.as_errors:
            for status in found:
                status.level = ERROR
        return found


@dataclass
class AnalyzerGroup:
    """Analyzers with a common summary."""

    path: str
    analyzers: list[Analyzer | AnalyzerGroup] = field(default_factory=list)

    @property
    def name(self) -> str:
        """The last part of the path."""
        return self.path.rpartition("/")[2]

    def analyze(self, status: DiagnosticStatus, now_s: float) -> bool:
        """Give a status to every analyzer. Return whether it matches at least one analyzer."""
        wanted = [analyzer.analyze(status, now_s) for analyzer in self.analyzers]
        return any(wanted)

    def report(self, now_s: float) -> list[DiagnosticStatus]:
        """Return the reports of the analyzers, and the summary."""
        header = DiagnosticStatus(name=self.path)
        found: list[DiagnosticStatus] = []
        levels = []
        for analyzer in self.analyzers:
            report = analyzer.report(now_s)
            found += report
            for status in report:
                if status.name == analyzer.path:
                    header.values.append(KeyValue(key=analyzer.name, value=status.message))
                    levels.append(status.level)
        header.level = _summary(levels, if_empty=OK)
        header.message = _WORDS[header.level]
        if self.path.strip("/"):
            found.append(header)
        return found


def _summary(levels: list[bytes], *, if_empty: bytes) -> bytes:
    """Return the worst level. If only some statuses are stale, the result is ERROR, not STALE."""
    if not levels:
        return if_empty
    worst = max(levels)
    return ERROR if worst == STALE and min(levels) != STALE else worst


def read_group(path: str, settings: Mapping[str, Any]) -> AnalyzerGroup:
    """Return the analyzers of parameters such as `motors.type` and `motors.path`.

    Raises:
        WrongValueError: An analyzer has an unknown type, or no rule for names.
    """
    group = AnalyzerGroup(path)
    for prefix, own in _by_analyzer(settings).items():
        kind = str(own["type"]).removeprefix(_PACKAGE)
        own_path = f"{path.rstrip('/')}/{own.get('path', prefix)}"
        if kind == "AnalyzerGroup":
            group.analyzers.append(read_group(own_path, own))
        elif kind in {"GenericAnalyzer", "DiscardAnalyzer"}:
            group.analyzers.append(_generic(prefix, kind, own_path, own))
        elif kind != "IgnoreAnalyzer":
            raise WrongValueError(
                f"the analyzer '{prefix}' has the type '{kind}': there are GenericAnalyzer, "
                "AnalyzerGroup, DiscardAnalyzer and IgnoreAnalyzer"
            )
    return group


def _by_analyzer(settings: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    """Return the parameters of each analyzer. The prefix `analyzers.` may be left out."""
    found: dict[str, dict[str, Any]] = {}
    for name, value in settings.items():
        prefix, dot, rest = name.removeprefix("analyzers.").partition(".")
        if dot:
            found.setdefault(prefix, {})[rest] = value
    return {prefix: own for prefix, own in found.items() if "type" in own}


def _generic(prefix: str, kind: str, path: str, own: Mapping[str, Any]) -> Analyzer:
    def strings(name: str) -> tuple[str, ...]:
        value = own.get(name, ())
        return (value,) if isinstance(value, str) else tuple(str(item) for item in value)

    removed = strings("remove_prefix") or strings("find_and_remove_prefix")
    analyzer = (DiscardAnalyzer if kind == "DiscardAnalyzer" else Analyzer)(
        path,
        float(own.get("timeout", _TIMEOUT_S)),
        int(own.get("num_items", -1)),
        bool(own.get("discard_stale", False)),
        (*strings("startswith"), *strings("find_and_remove_prefix")),
        strings("contains"),
        strings("name"),
        strings("expected"),
        tuple(_pattern(prefix, pattern) for pattern in strings("regex")),
        removed,
    )
    rules = (analyzer.startswith, analyzer.contains, analyzer.names, analyzer.expected)
    if not any(rules) and not analyzer.patterns:
        raise WrongValueError(
            f"the analyzer '{prefix}' has no rule for names: set startswith, contains, name, "
            "expected or regex"
        )
    return analyzer


def _pattern(prefix: str, text: str) -> re.Pattern[str]:
    try:
        return re.compile(text)
    except (re.error, OverflowError, RecursionError) as error:
        raise WrongValueError(f"the regex '{text}' of '{prefix}' is not valid: {error}") from None
