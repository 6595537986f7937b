"""Side of a bridge without a network, whose world a test sets."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from zbot.bridge.side import End, World
from zbot.qos import QoSProfile

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.bridge.errors import CallError
    from zbot.bridge.side import Answer, Format
    from zbot.wire.tokens import EntityKind


@dataclass(eq=False)
class FakeEntity:
    kind: str
    name: str
    qos: QoSProfile | None = None
    call_back: Any = None
    sent: list[bytes] = field(default_factory=list)
    is_heard: bool = True
    is_closed: bool = False

    def send(self, data: bytes) -> None:
        self.sent.append(data)

    def call(self, request: bytes, answer: Answer) -> None:
        self.sent.append(request)
        self.call_back = answer

    def close(self) -> None:
        self.is_closed = True


class FakeAnswer:
    def __init__(self) -> None:
        self.outcome: bytes | CallError | None = None

    def reply(self, data: bytes) -> None:
        self.outcome = data

    def fail(self, error: CallError) -> None:
        self.outcome = error


class FakeSide:
    def __init__(self, label: str, wire_format: Format = "cdr") -> None:
        self.label = label
        self.format: Format = wire_format
        self.present = World()
        self.entities: list[FakeEntity] = []
        self.shown_nodes: frozenset[str] = frozenset()
        self.shown: frozenset[End] = frozenset()
        self.missing_types: dict[str, str] = {}
        self.broken_kinds: set[str] = set()  #: of entities that cannot be made
        self.changed: Callable[[], None] = lambda: None

    def add(
        self,
        kind: EntityKind,
        name: str,
        type_name: str = "std_msgs/msg/String",
        *,
        node: str = "/node",
        qos: QoSProfile | None = None,
        type_hash: str = "",
    ) -> None:
        end = End(kind, node, name, type_name, type_hash, qos or QoSProfile(depth=10))
        self.present = replace(
            self.present, nodes=self.present.nodes | {node}, ends=self.present.ends | {end}
        )

    def open(self, kind: str) -> dict[str, FakeEntity]:
        """Return the entities of a kind that are not closed, by name."""
        return {
            entity.name: entity
            for entity in self.entities
            if entity.kind == kind and not entity.is_closed
        }

    def world(self) -> World:
        return self.present

    def watch(self, changed: Callable[[], None]) -> None:
        self.changed = changed

    def lack(self, type_name: str) -> str:
        return self.missing_types.get(type_name, "")

    def _entity(self, kind: str, name: str, **more: Any) -> FakeEntity:
        if kind in self.broken_kinds:
            raise OSError("too many open files")
        self.entities.append(FakeEntity(kind, name, **more))
        return self.entities[-1]

    def receiver(
        self,
        name: str,
        type_name: str,  # noqa: ARG002 - the protocol's signature
        qos: QoSProfile,
        receive: Callable[[bytes], None],
    ) -> FakeEntity:
        return self._entity("receiver", name, qos=qos, call_back=receive)

    def sender(self, name: str, type_name: str, qos: QoSProfile) -> FakeEntity:  # noqa: ARG002 - as above
        return self._entity("sender", name, qos=qos)

    def server(
        self,
        name: str,
        type_name: str,  # noqa: ARG002 - as above
        node: str,  # noqa: ARG002 - as above
        serve: Callable[[bytes, Answer], None],
    ) -> FakeEntity:
        return self._entity("server", name, call_back=serve)

    def caller(self, name: str, type_name: str) -> FakeEntity:  # noqa: ARG002 - as above
        return self._entity("caller", name)

    def show(self, nodes: frozenset[str], ends: frozenset[End]) -> None:
        self.shown_nodes, self.shown = nodes, ends

    def close(self) -> None:
        self.present = World()
