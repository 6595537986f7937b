"""Kinds of names in the graph that have a type: topics, services and actions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from zbot import interfaces  # this package imports its modules when one of its names is used
from zbot.graph.snapshot import Snapshot
from zbot.names import is_hidden
from zbot.wire.tokens import EntityKind
from zbot_cli.domain.types import (
    all_types,
    check_known,
    find_types,
    learn,
    looks_like_type,
    type_hint,
)
from zbot_cli.errors import CommandError
from zbot_cli.input.domain_names import as_typed, did_you_mean

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence, Sized

    from zbot.graph.snapshot import NamesAndTypes


@dataclass(frozen=True, repr=False, eq=False)
class Kind:
    """Kind of names that have a type. The commands of a kind differ in these facts only."""

    word: str  #: the noun of the command
    type_word: str  #: what ros2 calls a type of this kind in its errors
    folder: str  #: the part of a type's name between the package and the base name
    values: str  #: attribute of a type's class: the class of the values on the command line
    getter: str  #: function of `zbot.interfaces` that returns the class of a type
    listed: Callable[[Snapshot], NamesAndTypes]  #: what `list` shows
    used: Callable[[Snapshot], NamesAndTypes]  #: what `info` and `type` know
    #: For each end of a name (e.g. `server`), a function that returns those of one name.
    ends: dict[str, Callable[[Snapshot, str], Sized]]
    has_no_definition: str  #: error that no node has the definition of a type
    has_several: str  #: error that a name has several types
    example: str  #: what to type then
    is_another_kind: str = ""  #: error that a type is of another kind; empty: no error of its own

    def facts(self, graph: Snapshot, name: str, types: list[str]) -> dict[str, object]:
        """Return a name as `list --json` prints it."""
        counts = {f"{end}_count": len(found(graph, name)) for end, found in self.ends.items()}
        return {"name": name, "types": types, **counts}

    def with_type(self, graph: Snapshot, word: str, *, include_hidden: bool) -> list[str]:
        """Return the names that have a type.

        Raises:
            CommandError: There is no such type.
        """
        entries = self.listed(graph)
        wanted = check_known(word, self.folder, {name for _, types in entries for name in types})
        return [name for name, types in visible(entries, include_hidden) if wanted in types]

    def types_of(self, graph: Snapshot, name: str) -> list[str]:
        """Return the types of a name.

        Raises:
            CommandError: No node uses the name.
        """
        types = dict(self.used(graph)).get(name)
        if types is None:
            text = f"Unknown {self.word} '{as_typed(name)}'"
            raise CommandError(text, hint=self.suggestion(graph, name))
        return types

    def suggestion(self, graph: Snapshot, name: str, before: str = "") -> str:
        """Return that e.g. a service has the name, or the most similar name, or an empty string."""
        other = text_of_other_kind(graph, name, self.word)
        if other:
            return before + other
        return did_you_mean(name, [known for known, _ in self.listed(graph)], before=before)

    def only_type(self, graph: Snapshot, name: str) -> str | None:
        """Return the type of a name, or `None` if no node uses the name.

        Raises:
            CommandError: The name has more than one type.
        """
        return self._only(name, self.used(graph))

    def listed_type(self, graph: Snapshot, name: str) -> str | None:
        """Return the type of a name, or `None` if `list` does not show the name.

        Raises:
            CommandError: The name has more than one type.
        """
        return self._only(name, self.listed(graph))

    def _only(self, name: str, entries: NamesAndTypes) -> str | None:
        types = dict(entries).get(name)
        if types is not None and len(types) > 1:
            example = self.example.format(name=name, type=types[0])
            raise CommandError(
                self.has_several.format(name=name, types=", ".join(types)),
                hint=f"add the type that you mean, e.g. {example}",
            )
        return None if types is None else types[0]

    def split(self, words: Sequence[str]) -> tuple[str | None, list[str]]:
        """Return the type on a command line, if any, and the values after it.

        Raises:
            CommandError: The first word looks like a type, but no type has this name.
        """
        if words and looks_like_type(words[0]):
            return self.resolve_type(words[0]), list(words[1:])
        return None, list(words)

    def resolve_type(self, word: str) -> str:
        """Return the full name of a type.

        Raises:
            CommandError: No type has this name, or several types have this short name.
        """
        found = find_types(word)
        fitting = list(filter(self._is_type, found))
        if len(fitting) != 1:
            text = self.is_another_kind if found and not fitting else ""
            raise CommandError(
                text or f"The passed {self.type_word} type is invalid",
                hint=type_hint(word, fitting, self.all_types()),
            )
        return fitting[0]

    def all_types(self) -> Iterator[str]:
        """Yield the types of this kind on this machine."""
        return filter(self._is_type, all_types())

    def _is_type(self, name: str) -> bool:
        return f"/{self.folder}/" in name

    def load(self, type_name: str) -> type[Any]:
        """Return the class of a type. Raise the errors of `zbot.interfaces.get_spec`."""
        cls: type[Any] = getattr(interfaces, self.getter)(type_name)
        return cls

    def class_of(self, type_name: str) -> type[Any]:
        """Return the class of a type. If this machine lacks the definition, ask the nodes for it.

        Raises:
            CommandError: No definition of the type is on this machine or in a node.
        """
        try:
            return self.load(type_name)
        except LookupError:
            if learn(type_name):
                return self.load(type_name)
            raise CommandError(
                self.has_no_definition.format(type_name),
                hint=f"put its .{self.folder} file into a package of your workspace",
            ) from None

    def values_class(self, type_name: str) -> type[Any]:
        """Return the class of the values that a command sends: a message, a request or a goal.

        Raises:
            CommandError: No definition of the type is on this machine or in a node.
        """
        return self.values_of(self.class_of(type_name))

    def values_of(self, found: type[Any]) -> type[Any]:
        """Return the class of the values that a command sends, e.g. the request of a service."""
        return getattr(found, self.values) if self.values else found


def visible(entries: NamesAndTypes, include_hidden: bool) -> NamesAndTypes:
    """Return the entries whose names are not hidden, or all entries."""
    return [entry for entry in entries if include_hidden or not is_hidden(entry[0])]


def text_of_other_kind(graph: Snapshot, name: str, word: str) -> str:
    """Return that a name is e.g. a service and not a topic, or an empty string.

    Args:
        graph: The graph.
        name: The name.
        word: The noun of the command, e.g. `topic`.
    """
    names = {each.word: [known for known, _ in each.listed(graph)] for each in KINDS.values()}
    names["node"] = [node.full_node_name for node in graph.nodes]
    for noun, known in names.items():
        if noun != word and name in known:
            article = "an" if noun == "action" else "a"
            typed = as_typed(name)
            return f"{typed} is {article} {noun} and no {word}: type zbot {noun} info {typed}"
    return ""


def nodes_of_action(graph: Snapshot, name: str, kind: EntityKind) -> dict[str, list[str]]:
    """Return the nodes that are servers or clients of an action, and the types that they use."""
    found: dict[str, list[str]] = {}
    for node in graph.nodes:
        full = node.full_node_name
        types = dict(graph.actions(kind, node=full)).get(name)  # type: ignore[arg-type]
        if types is not None:
            found[full] = types
    return found


TOPIC: Final = Kind(
    word="topic",
    type_word="message",
    folder="msg",
    values="",
    getter="get_message",
    listed=Snapshot.topics,
    used=Snapshot.topics,
    ends={"publisher": Snapshot.publishers, "subscription": Snapshot.subscriptions},
    has_no_definition="The message type '{}' is invalid",
    has_several="Cannot echo topic '{name}', as it contains more than one type: [{types}]",
    example="zbot topic echo {name} {type}",
)
SERVICE: Final = Kind(
    word="service",
    type_word="service",
    folder="srv",
    values="Request",
    getter="get_service",
    listed=Snapshot.services,
    used=lambda graph: graph.names_and_types(EntityKind.SERVICE, EntityKind.CLIENT),
    ends={
        "server": lambda graph, name: graph.on(name, EntityKind.SERVICE),
        "client": lambda graph, name: graph.on(name, EntityKind.CLIENT),
    },
    has_no_definition="The passed service type is invalid",
    has_several="Service '{name}' has more than one type: [{types}]",
    example="{type}",
    is_another_kind="The passed type is not a service",
)
ACTION: Final = Kind(
    word="action",
    type_word="action",
    folder="action",
    values="Goal",
    getter="get_action",
    listed=Snapshot.actions,
    used=Snapshot.actions,
    ends={
        "server": lambda graph, name: nodes_of_action(graph, name, EntityKind.SERVICE),
        "client": lambda graph, name: nodes_of_action(graph, name, EntityKind.CLIENT),
    },
    has_no_definition="The passed action type is invalid",
    has_several="Action '{name}' has more than one type: [{types}]",
    example="{type}",
)
KINDS: Final = {kind.word: kind for kind in (TOPIC, SERVICE, ACTION)}
