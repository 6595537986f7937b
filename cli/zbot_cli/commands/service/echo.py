"""`zbot service echo`: prints the service events that servers and clients publish."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot_cli.domain.client import hidden_node
from zbot_cli.domain.service_types import (
    known_services,
    resolve_service_type,
    service_class,
    several_service_types_error,
    suggestion,
)
from zbot_cli.output.listing import print_json
from zbot_cli.output.message_text import Formatter
from zbot_cli.output.service_event import event_json, event_text

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.node.message_info import MessageInfo
    from zbot.node.node import Node
    from zbot_cli.input.qos_options import QosOptions
    from zbot_cli.output.message_text import Form

_STEP_S = 0.5  # Ctrl-C cannot interrupt waiting for the graph, so the command waits in steps


class ServiceEcho:
    """Printer of the calls of servers and clients whose introspection is on.

    Args:
        name: The service's full name.
        type_word: The service's type, or `None` to take it from the graph.
        form: How to show events.
        qos: Quality of service options.

    Raises:
        CommandError: `type_word` is not the name of a service type.
    """

    def __init__(self, name: str, type_word: str | None, form: Form, qos: QosOptions) -> None:
        self._name = name
        self._topic = f"{name}/_service_event"
        self._type = None if type_word is None else resolve_service_type(type_word)
        self._form = form
        self._qos = qos
        self._format = Formatter(form)

    def run(self) -> None:
        """Print events until Ctrl-C."""
        import zbot  # noqa: F401, PLC0415 - makes the message packages importable
        from zbot.runtime import spin  # noqa: PLC0415 - not needed by `list`

        with hidden_node("service_echo") as node:
            event_type = service_class(self._type or self._wait_for_type(node)).Event
            publishers = node.context.graph.snapshot().publishers(self._topic)
            if not publishers:
                _print_note(
                    f"No publishers on topic '{self._topic}'; is service introspection on the "
                    "client or server enabled?"
                )
            node.create_subscription(
                event_type, self._topic, self._show, self._qos.to_subscribe(publishers)
            )
            spin(node)

    def _wait_for_type(self, node: Node) -> str:
        graph = node.context.graph
        found = _known_type(graph.snapshot(), self._name)
        if found is None:
            hint = suggestion(self._name, graph.snapshot(), "; ")
            _print_note(f"waiting for {self._name} to appear{hint}")
        while found is None:
            graph.wait_for(lambda snapshot: _known_type(snapshot, self._name) is not None, _STEP_S)
            found = _known_type(graph.snapshot(), self._name)
        return found

    def _show(self, event: Any, info: MessageInfo) -> None:
        if self._form.json:
            print_json(event_json(event))
        elif self._form.csv:
            sys.stdout.write(self._format.text(self._topic, event, info))
        else:
            sys.stdout.write(event_text(event, self._form))
        sys.stdout.flush()


def _known_type(graph: Snapshot, name: str) -> str | None:
    types = dict(known_services(graph)).get(name)
    if types is not None and len(types) > 1:
        raise several_service_types_error(name, types)
    return None if types is None else types[0]


def _print_note(text: str) -> None:
    print(text, file=sys.stderr, flush=True)
