"""`zbot service echo`: prints the service events that servers and clients publish."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot_cli.domain.client import hidden_node
from zbot_cli.domain.kinds import SERVICE
from zbot_cli.domain.waiting import wait_for_type
from zbot_cli.output.listing import print_json
from zbot_cli.output.message_text import Formatter, event_json, event_text

if TYPE_CHECKING:
    from zbot.node.message_info import MessageInfo
    from zbot_cli.input.qos_options import QosOptions
    from zbot_cli.output.message_text import Form


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
        self._type = None if type_word is None else SERVICE.resolve_type(type_word)
        self._form = form
        self._qos = qos
        self._format = Formatter(form)

    def run(self) -> None:
        """Print events until Ctrl-C."""
        import zbot  # noqa: F401, PLC0415 - makes the message packages importable
        from zbot.runtime import spin  # noqa: PLC0415 - not needed by `list`

        with hidden_node("service_echo") as node:
            type_name = self._type or wait_for_type(node, SERVICE, self._name)
            event_type = SERVICE.class_of(type_name).Event
            publishers = node.context.graph.snapshot().publishers(self._topic)
            if not publishers:
                print(
                    f"No publishers on topic '{self._topic}'; is service introspection on the "
                    "client or server enabled?",
                    file=sys.stderr,
                    flush=True,
                )
            node.create_subscription(
                event_type, self._topic, self._show, self._qos.to_subscribe(publishers)
            )
            spin(node)

    def _show(self, event: Any, info: MessageInfo) -> None:
        if self._form.json:
            print_json(event_json(event))
        elif self._form.csv:
            sys.stdout.write(self._format.text(self._topic, event, info))
        else:
            sys.stdout.write(event_text(event, self._form))
        sys.stdout.flush()
