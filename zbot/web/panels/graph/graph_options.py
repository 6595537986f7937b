"""Options of the graph's panel. The page's address and the `zbot graph` command contain them."""

from __future__ import annotations

import shlex
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from zbot.graph.filters import Filters, Grouping, InvalidFilterError, compile_filter
from zbot.graph.view import Mode, view
from zbot.text.whole_number import whole_number

if TYPE_CHECKING:
    from collections.abc import Mapping

    from zbot.graph.snapshot import Snapshot
    from zbot.graph.view import GraphView

MOST_NAMESPACES = 9
_NAMESPACES = "group-namespaces"
_TEXTS = ("nodes", "topics")

#: Options of `zbot graph`. Each sets a field of `filters` or of `grouping` to a value.
FLAGS: dict[str, tuple[str, str, bool]] = {
    "debug-topics": ("filters", "debug", False),
    "params": ("filters", "params", False),
    "no-tf": ("filters", "tf", True),
    "no-dead-sinks": ("filters", "dead_sinks", True),
    "no-leaf-topics": ("filters", "leaf_topics", True),
    "no-actions": ("filters", "actions", True),
    "include-hidden": ("filters", "hidden", False),
    "no-group-actions": ("grouping", "actions", False),
    "no-group-tf": ("grouping", "tf", False),
    "no-group-images": ("grouping", "images", False),
}


@dataclass(frozen=True)
class GraphOptions:
    """Mode, filters and grouping of the drawn graph."""

    mode: Mode = Mode.ALL
    filters: Filters = field(default_factory=Filters)
    grouping: Grouping = field(default_factory=Grouping)

    @classmethod
    def from_query(cls, query: Mapping[str, str]) -> GraphOptions:
        """Return the options of an address. Unknown parameters and values are ignored."""
        found = cls()
        for flag in FLAGS:
            if flag in query:
                found = found.flagged(flag, is_set=True)
        for name in _TEXTS:
            if filter_problem(query.get(name, "/")) is None:
                found = found.filtered(name, query.get(name, "/"))
        levels = whole_number(query.get(_NAMESPACES, ""))
        if levels is not None and levels <= MOST_NAMESPACES:
            found = found.framed(levels)
        modes = [mode for mode in Mode if mode.value == query.get("show")]
        return replace(found, mode=modes[0]) if modes else found

    @property
    def query(self) -> dict[str, str]:
        """The parameters of the address, which are the options that differ from their defaults."""
        found = {} if self.mode is Mode.ALL else {"show": self.mode.value}
        for name in _TEXTS:
            if getattr(self.filters, name).strip() not in {"", "/"}:
                found[name] = getattr(self.filters, name)
        if self.grouping.namespaces != Grouping().namespaces:
            found[_NAMESPACES] = str(self.grouping.namespaces)
        return found | {flag: "1" for flag in FLAGS if self.has(flag)}

    @property
    def command(self) -> str:
        """The command that prints the same graph."""
        words = ["zbot", "graph"]
        for name, value in self.query.items():
            words += [f"--{name}"] if name in FLAGS else [f"--{name}", shlex.quote(value)]
        return " ".join(words)

    def has(self, flag: str) -> bool:
        """Return whether an option of `zbot graph` is set."""
        part, name, value = FLAGS[flag]
        return bool(getattr(getattr(self, part), name) is value)

    def flagged(self, flag: str, *, is_set: bool) -> GraphOptions:
        """Return a copy in which an option of `zbot graph` is set or not set."""
        part, name, value = FLAGS[flag]
        changed: dict[str, Any] = {name: value if is_set else not value}
        if part == "filters":
            return replace(self, filters=replace(self.filters, **changed))
        return replace(self, grouping=replace(self.grouping, **changed))

    def filtered(self, name: str, text: str) -> GraphOptions:
        """Return a copy that has another filter for `nodes` or `topics`."""
        filters = self.filters
        if name == "nodes":
            return replace(self, filters=replace(filters, nodes=text))
        return replace(self, filters=replace(filters, topics=text))

    def framed(self, namespaces: int) -> GraphOptions:
        """Return a copy that has frames for this number of namespace levels."""
        return replace(self, grouping=replace(self.grouping, namespaces=namespaces))

    def view(self, snapshot: Snapshot) -> GraphView:
        """Return the view of a snapshot that these options select."""
        return view(snapshot, self.mode, self.filters, self.grouping)


def filter_problem(text: str | None) -> str | None:
    """Return a sentence about a wrong filter, or None if the filter is valid."""
    try:
        compile_filter(text or "")
    except InvalidFilterError as exc:
        return str(exc)
    return None
