"""Services of the domain, which clients of the server for Foxglove can call."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.bag.definition import ENCODING, definition_text
from zbot.errors import ZbotError
from zbot.log import get_logger
from zbot.names import is_hidden
from zbot.wire.serialization import deserialize_message, serialize_message

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from zbot.graph.snapshot import Snapshot
    from zbot.observer.system import System
    from zbot.web.foxglove.type_search import TypeSearch

_OF_EVERY_NODE = ("rcl_interfaces/", "type_description_interfaces/")
_PATIENCE_S = 10.0


class Services:
    """Services that the server offers.

    The standard services that every node has, e.g. for parameters, are left out.

    Args:
        system: The running system.
        server: The SDK's server.
        types: The search for the types of services.
    """

    def __init__(self, system: System, server: Any, types: TypeSearch) -> None:
        self._system = system
        self._server = server
        self._types = types
        self._offered: dict[str, str] = {}
        self._unknown: dict[str, str] = {}  #: types that are not found, by service

    def update(self, graph: Snapshot) -> None:
        """Offer the services of a graph.

        This call may ask other machines for types, which takes a while.
        """
        found = _wanted(graph)
        gone = [name for name, kind in self._offered.items() if found.get(name) != kind]
        if gone:
            self._server.remove_services(gone)
        for name in gone:
            del self._offered[name]
        self._unknown = {name: kind for name, kind in self._unknown.items() if name in found}
        for name, kind in found.items():
            if name not in self._offered:
                self._offer(name, kind)

    def _offer(self, name: str, kind: str) -> None:
        from foxglove import Service, ServiceSchema  # noqa: PLC0415 - an extra

        try:
            service: Any = self._types.find(kind)
            schema = ServiceSchema(
                name=kind,
                request=_schema(f"{kind}_Request"),
                response=_schema(f"{kind}_Response"),
            )
        except ZbotError as error:
            if self._unknown.get(name) != kind:  # the warning comes once
                self._unknown[name] = kind
                get_logger("zbot.foxglove").warning(f"{name} cannot be called: {error}")
            return
        self._unknown.pop(name, None)
        self._offered[name] = kind
        handler = self._handler(name, kind, service)
        self._server.add_services([Service(name, schema=schema, handler=handler)])

    def _handler(self, name: str, kind: str, service: Any) -> Callable[[Any], bytes]:
        def call(request: Any) -> bytes:
            message = deserialize_message(request.payload, service.Request)
            with self._system.client(name, kind) as reference:
                return serialize_message(reference.entity.call(message, timeout_sec=_PATIENCE_S))

        return call


def _wanted(graph: Snapshot) -> Mapping[str, str]:
    return {
        name: types[0]
        for name, types in graph.services()
        if not is_hidden(name) and not types[0].startswith(_OF_EVERY_NODE)
    }


def _schema(type_name: str) -> Any:
    from foxglove import MessageSchema, Schema  # noqa: PLC0415 - an extra

    data = definition_text(type_name).encode()
    return MessageSchema(
        encoding="cdr", schema=Schema(name=type_name, encoding=ENCODING, data=data)
    )
