"""What publishers, subscriptions, services and clients have in common."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.transport.handle import Handle

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from zbot.context import Context
    from zbot.qos import QoSProfile
    from zbot.wire.tokens import EndpointToken

#: What ROS 2's programs are told of who carries the messages.
RMW_IDENTIFIER = "rmw_zbot_zenoh"


class Endpoint:
    """A part of a node that has a place in the graph; leaving a `with` block destroys it."""

    _token: EndpointToken
    _logger_name: str

    @property
    def qos_profile(self) -> QoSProfile:
        """The quality of service it was made with."""
        return self._token.qos

    @property
    def token(self) -> EndpointToken:
        """What the graph shows of it."""
        return self._token

    @property
    def handle(self) -> Handle[Self]:
        """What a `WaitSet` takes."""
        return Handle(self)

    @property
    def is_destroyed(self) -> bool:
        """Whether it has left the graph."""
        raise NotImplementedError

    @property
    def logger_name(self) -> str:
        """The name of its node's logger."""
        return self._logger_name

    def destroy(self) -> None:
        """Leave the graph."""
        raise NotImplementedError

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        exc_type: type[BaseException] | None,
        exc_val: BaseException | None,
        exc_tb: TracebackType | None,
    ) -> None:
        self.destroy()


class TopicEndpoint(Endpoint):
    """One that has a topic."""

    _topic = ""
    _context: Context

    @property
    def context(self) -> Context:
        """The context whose session carries its messages."""
        return self._context

    @property
    def topic_name(self) -> str:
        """The topic's full name."""
        return self._token.name

    @property
    def topic(self) -> str:
        """The topic's name as it was given when this was created."""
        return self._topic or self._token.name

    @topic.setter
    def topic(self, given: str) -> None:
        self._topic = given
