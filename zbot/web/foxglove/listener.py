"""Listener of the server for Foxglove. It handles the requests of the server's clients."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.interfaces.set_fields import set_message_fields
from zbot.json_reader import read_json_object
from zbot.log import get_logger
from zbot.observer.errors import ViewerError
from zbot.wire.serialization import deserialize_message

if TYPE_CHECKING:
    from zbot.observer.system import System
    from zbot.web.foxglove.channels import Channels
    from zbot.web.foxglove.parameters import Parameters


class Listener:
    """Methods that the SDK calls in its own threads. They have the SDK's names and arguments.

    Args:
        system: The running system.
        channels: The topics that clients can subscribe to.
        parameters: The parameters of all nodes.
    """

    def __init__(self, system: System, channels: Channels, parameters: Parameters) -> None:
        self._system = system
        self._channels = channels
        self._parameters = parameters
        self._lock = threading.Lock()
        self._published: dict[tuple[int, int], tuple[Any, Any, str]] = {}

    def on_subscribe(self, client: Any, channel: Any) -> None:
        """Subscribe to a topic."""
        self._channels.subscribe(channel.topic, client.id)

    def on_unsubscribe(self, client: Any, channel: Any) -> None:
        """End the subscription to a topic if no other client shows it."""
        self._channels.unsubscribe(channel.topic, client.id)

    def on_client_advertise(self, client: Any, channel: Any) -> None:
        """Create a publisher for a client."""
        try:
            if channel.encoding not in {"cdr", "json"}:
                raise ViewerError(
                    f"the encoding {channel.encoding!r} is not known: use cdr or json"
                )
            reference = self._system.publisher(channel.topic, channel.schema_name)
            cls = self._system.interface(channel.schema_name)
        except ZbotError as error:
            _warn(f"a client cannot publish on {channel.topic}: {error}")
            return
        with self._lock:
            self._published[client.id, channel.id] = reference, cls, channel.encoding

    def on_client_unadvertise(self, client: Any, client_channel_id: int) -> None:
        """Remove the publisher of a client."""
        with self._lock:
            known = self._published.pop((client.id, client_channel_id), None)
        if known is not None:
            known[0].release()

    def on_message_data(self, client: Any, client_channel_id: int, data: bytes) -> None:
        """Publish a message of a client."""
        with self._lock:
            known = self._published.get((client.id, client_channel_id))
        if known is None:
            return  # the publisher was refused
        reference, cls, encoding = known
        try:
            reference.entity.publish(client_message(data, cls, encoding))
        except (ZbotError, ValueError, TypeError) as error:
            _warn(f"a client has sent a wrong message: {error}")

    def on_get_parameters(
        self,
        client: Any,  # noqa: ARG002 - the SDK's signature
        param_names: list[str],
        request_id: str | None = None,  # noqa: ARG002 - as above
    ) -> list[Any]:
        """Return the parameters with these names. No names mean all parameters."""
        return self._parameters.read(param_names)

    def on_set_parameters(
        self,
        client: Any,  # noqa: ARG002 - as above
        parameters: list[Any],
        request_id: str | None = None,  # noqa: ARG002 - as above
    ) -> list[Any]:
        """Set parameters, and return the values that they have afterwards."""
        try:
            if self._system.read_only:
                _warn("a client tried to set a parameter: this server is read-only")
                return self._parameters.read(one.name for one in parameters)
            return self._parameters.write(parameters)
        except (ZbotError, ValueError, TypeError) as error:
            _warn(f"a parameter was not set: {error}")
            return []

    def on_parameters_subscribe(self, param_names: list[str]) -> None:
        """Do nothing: clients ask again when a parameter has changed."""

    def on_parameters_unsubscribe(self, param_names: list[str]) -> None:
        """Do nothing, because `on_parameters_subscribe` does nothing."""

    def on_playback_control_request(self, playback_control_request: Any) -> None:
        """Do nothing: this server shows live data, which has no playback."""

    def on_connection_graph_subscribe(self) -> None:
        """Do nothing: the server always has the newest graph."""

    def on_connection_graph_unsubscribe(self) -> None:
        """Do nothing: the server always has the newest graph."""


def client_message(data: bytes, cls: Any, encoding: str) -> Any:
    """Return a message that a client has sent.

    Raises:
        ZbotError: The bytes or the values do not fit the type.
        ValueError: There is no such field, or a value does not fit it.
        TypeError: A value has a type that does not fit the field.
    """
    if encoding == "cdr":
        return deserialize_message(data, cls)
    message = cls()
    try:
        set_message_fields(message, read_json_object(data))
    except AttributeError as error:
        raise ValueError(str(error)) from error
    return message


def _warn(text: str) -> None:
    get_logger("zbot.foxglove").warning(text)
