"""`zbot service call`: sends a request once or at a rate, and prints the responses."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from zbot.threads.deadline import Deadline
from zbot_cli.domain.client import hidden_node
from zbot_cli.domain.kinds import SERVICE
from zbot_cli.domain.waiting import (
    PeriodicSleep,
    print_hint_if_not_listed,
    wait_for_server,
)
from zbot_cli.errors import CommandError
from zbot_cli.output.listing import print_json

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.graph.snapshot import Snapshot
    from zbot.node.client import Client
    from zbot.node.node import Node
    from zbot_cli.input.message_values import Template
    from zbot_cli.input.qos_options import QosOptions


def no_server_error(name: str, timeout_s: float) -> CommandError:
    """Return the error that no server appeared in time."""
    return CommandError(f"Service '{name}' is not available after waiting {timeout_s:g} seconds")


def no_response_error(name: str, timeout_s: float) -> CommandError:
    """Return the error that the server did not answer in time."""
    return CommandError(f"Service '{name}' did not respond within {timeout_s:g} seconds")


class ServiceCall:
    """Client that waits for a server, and calls it once or until Ctrl-C.

    Args:
        name: The service's full name.
        words: A type and values. The type may be left out if the service has a server.
        qos: Quality of service options.
        rate_hz: Number of calls per second, or `None` for a single call.
        timeout_s: Seconds to wait for the server and for each response, or `None` for no limit.
        stdin: Read the values from standard input.
        as_json: Print one JSON document for each call.
    """

    def __init__(
        self,
        name: str,
        words: Sequence[str],
        qos: QosOptions,
        *,
        rate_hz: float | None,
        timeout_s: float | None,
        stdin: bool,
        as_json: bool,
    ) -> None:
        if rate_hz is not None and not rate_hz > 0:
            raise CommandError("rate must be greater than zero")
        self._name = name
        self._type, self._values = SERVICE.split(words)
        self._qos = qos
        self._rate_hz = rate_hz
        self._timeout_s = timeout_s
        self._as_json = as_json
        if stdin:
            self._values = [sys.stdin.read()]

    def run(self) -> None:
        """Check the type and the values, wait for the server, and call the service.

        Raises:
            CommandError: No server appeared in time, or the server did not answer in time, or the
                servers have another type.
            ServiceError: The server's callback failed, or the server ended before it answered.
        """
        import zbot  # noqa: F401, PLC0415 - makes the message packages importable

        template = None if self._type is None else self._template(self._type)
        deadline = Deadline(self._timeout_s)
        with hidden_node("service_call") as node:
            if not self._as_json:
                print("waiting for service to become available...", flush=True)
            type_name = self._wait_for_server(node, deadline)
            template = template or self._template(type_name)
            client = node.create_client(
                SERVICE.class_of(type_name), self._name, qos_profile=self._qos.to_publish()
            )
            if not client.wait_for_service(deadline.left_s):
                raise self._no_server()
            self._call(node, client, template)

    def _template(self, type_name: str) -> Template:
        from zbot_cli.input.message_values import Template  # noqa: PLC0415 - not needed by `list`

        return Template(SERVICE.values_class(type_name), self._values)

    def _wait_for_server(self, node: Node, deadline: Deadline) -> str:
        """Wait for a server, and return the type to call with."""
        print_hint_if_not_listed(SERVICE, node.context.graph.snapshot(), self._name)
        found = wait_for_server(node, SERVICE, self._name, self._served_type, deadline)
        if found is None:
            raise self._no_server()
        return found

    def _served_type(self, graph: Snapshot) -> str | None:
        """Return the type to call with, or `None` while the service has no server.

        Raises:
            CommandError: No server has the type on the command line, or the command line gives no
                type, and the service has several.
        """
        if self._type is None:
            return SERVICE.listed_type(graph, self._name)
        types = dict(graph.services()).get(self._name)
        if types is not None and self._type not in types:
            raise CommandError(
                f"Service '{self._name}' has the type {', '.join(types)}, not {self._type}",
                hint="leave the type out, and it is taken from the server",
            )
        return None if types is None else self._type

    def _no_server(self) -> CommandError:
        return no_server_error(self._name, self._timeout_s or 0)

    # -- calling -------------------------------------------------------------------------------

    def _call(self, node: Node, client: Client[Any, Any], template: Template) -> None:
        now_ns = lambda: node.get_clock().now().nanoseconds  # noqa: E731 - one expression
        sleep = None if self._rate_hz is None else PeriodicSleep(node.context, self._rate_hz)
        while node.context.ok():
            self._call_once(client, template.make(now_ns))
            if sleep is None:
                return
            sleep.until_next()

    def _call_once(self, client: Client[Any, Any], request: Any) -> None:
        if not self._as_json:
            print(f"requester: making request: {request!r}\n", flush=True)
        try:
            response = client.call(request, self._timeout_s)
        except TimeoutError:
            raise no_response_error(self._name, self._timeout_s or 0) from None
        if self._as_json:
            from zbot.interfaces.plain_value import json_value  # noqa: PLC0415 - seldom used

            print_json({"request": json_value(request), "response": json_value(response)})
            sys.stdout.flush()
        else:
            print(f"response:\n{response!r}\n", flush=True)
