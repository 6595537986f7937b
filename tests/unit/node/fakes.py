"""Samples and a context without Zenoh's network, for entities that a test makes itself."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import zenoh

from tests.unit.tokens import endpoint_token
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.executor.ready_queue import ReadyQueue
from zbot.node.subscription import Subscription
from zbot.qos import QoSProfile
from zbot.wire.attachment import pack
from zbot.wire.dialect import NATIVE
from zbot.wire.messagepack.codec import messagepack_codec_for
from zbot.wire.tokens import EntityKind

from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.wire.tokens import EndpointToken

GID = bytes(range(16))
TOPIC = "/chatter"


@dataclass
class Sample:
    """The parts of a Zenoh sample that a subscription reads."""

    payload: zenoh.ZBytes
    attachment: zenoh.ZBytes | None = None
    encoding: str = ""
    key_expr: str = f"0{TOPIC}"


def sample(
    content: Any,
    number: int | None = None,
    *,
    gid: bytes = GID,
    stamp_ns: int = 0,
    encoding: str = "",
) -> Any:
    """Return a sample of a message or of bytes. A plain Zenoh program gives no `number`."""
    payload = (
        content
        if isinstance(content, bytes)
        else messagepack_codec_for(type(content)).encode(content)
    )
    attachment = None if number is None else zenoh.ZBytes(pack(number, stamp_ns, gid))
    return Sample(zenoh.ZBytes(payload), attachment, encoding)


@dataclass
class Channel:
    """Zenoh's queue of samples."""

    samples: deque[Any] = field(default_factory=deque)

    def try_recv(self) -> Any:
        return self.samples.popleft() if self.samples else None


class Context:
    """The parts of a context that a subscription uses."""

    def __init__(self, publishers: list[EndpointToken]) -> None:
        self.dialect = NATIVE
        self.is_inherited = False
        self.channel = Channel()
        self.declared: list[str] = []
        self.session = SimpleNamespace(declare_subscriber=self._declare)
        known = {token.gid: token for token in publishers}
        self.graph = SimpleNamespace(find=known.get, announce=self._announce)

    def _declare(self, key: str, _: Any) -> Any:
        self.declared.append(key)
        return SimpleNamespace(handler=self.channel)

    def _announce(self, token: EndpointToken, *, is_visible: bool) -> EndpointToken:
        assert is_visible
        self.declared.append(token.key)
        return token

    def undeclare(self, token: EndpointToken) -> None:
        self.declared.remove(token.key)


def subscription(
    callback: Callable[..., Any] = print, *, publishers: tuple[Any, ...] = (), **facts: Any
) -> Subscription[String]:
    """Return a subscription of `/chatter` without an open session."""
    msg_type, qos = facts.pop("msg_type", String), facts.pop("qos", QoSProfile(depth=10))
    token = endpoint_token(TOPIC, kind=EntityKind.SUBSCRIPTION, node="listener", qos=qos)
    context: Any = Context(list(publishers))
    return Subscription(
        *(context, msg_type, callback, token),
        ready_queue=ReadyQueue(),
        callback_group=ReentrantCallbackGroup(),
        logger_name="listener",
        **{"raw": False, **facts},
    )


def reply(content: Any = None, *, error: bytes | None = None) -> Any:
    """Return a reply with a message, or with the payload of an error."""
    if error is not None:
        return SimpleNamespace(ok=None, err=SimpleNamespace(payload=zenoh.ZBytes(error)))
    return SimpleNamespace(ok=sample(content), err=None)


#: Zenoh's own reply after the timeout of a query.
TIMEOUT = reply(error=b"Timeout")


class Sender:
    """Function that notes each attempt to send a request."""

    def __init__(self) -> None:
        self.timeouts_s: list[float] = []
        self.attempts: list[tuple[Callable[[Any], object], Callable[[], object]]] = []

    def __call__(self, request: Any, on_reply: Any, on_end: Any) -> None:
        self.timeouts_s.append(request.timeout_s)
        self.attempts.append((on_reply, on_end))

    def answer(self, *replies: Any) -> None:
        """Give replies to the latest attempt, and end it."""
        on_reply, on_end = self.attempts[-1]
        for each in replies:
            on_reply(each)
        on_end()
