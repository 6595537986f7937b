"""Listener of the SDK's server. It handles requests that the guard has passed on."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.log import get_logger

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

    def on_subscribe(self, client: Any, channel: Any) -> None:
        """Subscribe to a topic."""
        self._channels.subscribe(channel.topic, client.id)

    def on_unsubscribe(self, client: Any, channel: Any) -> None:
        """End the subscription to a topic if no other client shows it."""
        self._channels.unsubscribe(channel.topic, client.id)

    def on_client_advertise(self, client: Any, channel: Any) -> None:
        """Do nothing: the guard publishes for the clients."""

    def on_client_unadvertise(self, client: Any, client_channel_id: int) -> None:
        """Do nothing: the guard publishes for the clients."""

    def on_message_data(self, client: Any, client_channel_id: int, data: bytes) -> None:
        """Do nothing: the guard publishes for the clients."""

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
                return self._parameters.read(parameter.name for parameter in parameters)
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


def _warn(text: str) -> None:
    get_logger("zbot.foxglove").warning(text)
