"""Base classes of publishers, subscriptions, services and clients."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.threads.handle import Handle

if TYPE_CHECKING:
    from typing_extensions import Self

    from zbot.context import Context
    from zbot.qos import QoSProfile
    from zbot.wire.tokens import EndpointToken


class Endpoint:
    """Publisher, subscription, service or client. The end of a `with` block destroys it."""

    _context: Context
    _token: EndpointToken
    _logger_name: str

    @property
    def context(self) -> Context:
        """The context whose session sends and receives the messages."""
        return self._context

    @property
    def qos_profile(self) -> QoSProfile:
        """The quality of service that the endpoint was created with."""
        return self._token.qos

    @property
    def token(self) -> EndpointToken:
        """The liveliness token that shows the endpoint in the graph."""
        return self._token

    @property
    def handle(self) -> Handle[Self]:
        """A handle for a `WaitSet`."""
        return Handle(self)

    @property
    def is_destroyed(self) -> bool:
        """Whether the endpoint was destroyed."""
        raise NotImplementedError

    @property
    def logger_name(self) -> str:
        """The name of the node's logger."""
        return self._logger_name

    def destroy(self) -> None:
        """Leave the graph."""
        raise NotImplementedError

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exc_info: object) -> None:
        self.destroy()


class TopicEndpoint(Endpoint):
    """Endpoint of a topic: a publisher or a subscription."""

    _topic = ""

    @property
    def topic_name(self) -> str:
        """The topic's full name."""
        return self._token.name

    @property
    def topic(self) -> str:
        """The topic's name as it was given to the node."""
        return self._topic or self._token.name

    @topic.setter
    def topic(self, given: str) -> None:
        self._topic = given
