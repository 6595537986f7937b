"""Base class of nodes that receive messages of any type and publish them again, as bytes."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import zbot
from zbot.remote.profiles import profile_to_record
from zbot.remote.types import interface
from zbot_nodes.startup.program import ParameterError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.qos import QoSProfile

_DISCOVERY_S = 0.1
_DEPTH = 10


class TopicTool(zbot.Node):
    """Subscribes to the input as soon as the input has a publisher.

    The subscription and the publisher of the node have the type and profile of that publisher.

    Args:
        name: The node's name.
        options: The options of `zbot.Node`.
    """

    def __init__(self, name: str, **options: Any) -> None:
        super().__init__(name, **options)
        self.input = self.output = ""
        self.is_lazy = bool(self.declare_parameter("lazy", False).value)
        self.publisher: zbot.Publisher[Any] | None = None
        self.subscription: zbot.Subscription[Any] | None = None
        self.source: tuple[str, QoSProfile] | None = None

    def required(self, name: str, kind: type, text: str) -> Any:
        """Declare a parameter, and return its value. The default is 0 or an empty string.

        Raises:
            ParameterError: The parameter is a string, and its value is empty.
            InvalidParameterTypeException: The value has another type.
        """
        self.declare_parameter(name, kind())
        value = self.get_parameter(name).value
        if not value and kind is str:
            raise ParameterError(f"the parameter {name} is missing: {text}")
        return value

    def begin(self) -> None:
        """Begin to look for publishers of the input."""
        real = zbot.Clock(clock_type=zbot.ClockType.STEADY_TIME)
        self.create_timer(_DISCOVERY_S, self.match, clock=real)
        self.match()

    def match(self) -> None:
        """Adapt the node's publisher and subscription to the publishers of the input."""
        source = self.find_source()
        if source is None:
            return
        output = self.resolve_topic_name(self.output)
        if source != self.source or self.publisher is None or self.publisher.topic_name != output:
            self.forget()
            self.source = source
            self.publisher = self.create_publisher(self.message_type(), self.output, source[1])
        is_wanted = not self.is_lazy or self.publisher.get_subscription_count() > 0
        topic = self.resolve_topic_name(self.input)
        if self.subscription is not None and (
            not is_wanted or self.subscription.topic_name != topic
        ):
            self.destroy_subscription(self.subscription)
            self.subscription = None
        if is_wanted and self.subscription is None:
            self.subscription = self.create_subscription(
                self.message_type(), self.input, self.process, source[1], raw="payload"
            )

    def forget(self) -> None:
        """Destroy the publisher and the subscription."""
        if self.publisher is not None:
            self.destroy_publisher(self.publisher)
        if self.subscription is not None:
            self.destroy_subscription(self.subscription)
        self.publisher = self.subscription = None

    def message_type(self) -> Any:
        """Return the class of the messages. If its definition is unknown, ask the publisher."""
        assert self.source is not None
        return interface(self.context, self.source[0])

    def find_source(self) -> tuple[str, QoSProfile] | None:
        """Return the type and profile of the input's publishers, or None without a publisher."""
        found = self.get_publishers_info_by_topic(self.resolve_topic_name(self.input))
        if not found:
            return None
        profile = profile_to_record([publisher.qos_profile for publisher in found], _DEPTH)
        return found[0].topic_type, profile

    def process(self, message: bytes) -> None:
        """Publish a message. Subclasses may drop or delay it."""
        self.pass_on(message)

    def pass_on(self, message: bytes) -> None:
        """Publish a message."""
        if self.publisher is not None:
            self.publisher.publish(message)


def overrides(names: Sequence[str], values: Sequence[Any]) -> list[zbot.Parameter[Any]]:
    """Return parameters with the values of a command line."""
    return [zbot.Parameter(name, value=value) for name, value in zip(names, values, strict=False)]


def number(word: str, name: str) -> float:
    """Return a word of the command line as a number.

    Raises:
        ParameterError: The word is not a finite number.
    """
    try:
        value = float(word)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise ParameterError(f"{name} must be a number, not '{word}'")
    return value
