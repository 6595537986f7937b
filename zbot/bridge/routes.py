"""Routes of a bridge: a topic in one direction, or a service that one side offers to the other."""

from __future__ import annotations

import time
from contextlib import contextmanager
from typing import TYPE_CHECKING, Protocol

from zbot.bridge.errors import CallError
from zbot.wire.errors import CodecError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from zbot.bridge.side import Answer, Entity, Side
    from zbot.qos import QoSProfile


class Log(Protocol):
    """Logger of the bridge."""

    def warning(self, message: str) -> object:
        """Write a line."""


class RateLimit:
    """Decides which messages pass, so that at most `hertz` messages pass in a second."""

    def __init__(self, hertz: float) -> None:
        self._period_s = 1 / hertz
        self._due_s = 0.0

    def admits(self, now_s: float) -> bool:
        """Return whether a message may pass if it comes at `now_s` (seconds)."""
        if now_s < self._due_s:
            return False
        # The next due time is counted from the last due time, so the rate is right even if messages
        # come a little late. After a pause, the next due time is counted from now.
        self._due_s = max(self._due_s, now_s - self._period_s) + self._period_s
        return True


class TopicRoute:
    """Topic that is carried from one side to the other."""

    def __init__(
        self,
        topic: tuple[str, str, str],
        sides: tuple[Side, Side],
        profiles: tuple[QoSProfile, QoSProfile],
        *,
        convert: Callable[[bytes], bytes] | None,
        hertz: float,
        log: Log,
    ) -> None:
        """Begin to carry.

        Args:
            topic: Name on the first side, name on the second side, and type.
            sides: The side from which messages come, and the side to which they go.
            profiles: Profile of the subscription on the first side, and of the publisher on the
                second side.
            convert: Converts a message's bytes, or `None` if both sides have the same format.
            hertz: Largest number of messages in a second, or 0 without a limit.
            log: Gets a line for the first message that cannot be converted.
        """
        self._name, other_name, type_name = topic
        self._convert = convert
        self._limit = RateLimit(hertz) if hertz else None
        self._log = log
        self.refused_count = 0
        self._has_passed = False
        self._sender = sides[1].sender(other_name, type_name, profiles[1])
        with _closed_on_error(self._sender):
            self._receiver = sides[0].receiver(self._name, type_name, profiles[0], self._carry)

    def _carry(self, data: bytes) -> None:
        if self._limit is not None and not self._limit.admits(time.monotonic()):
            return
        if not self._sender.is_heard:
            return
        if self._convert is not None:
            try:
                data = self._convert(data)
            except CodecError as error:
                self._refuse(error)
                return
        self._sender.send(data)
        self._has_passed = True

    def send_once(self, data: bytes) -> None:
        """Publish a message, if the route has carried messages since the last call."""
        if self._has_passed:
            self._has_passed = False
            self._sender.send(data)

    def _refuse(self, error: CodecError) -> None:
        self.refused_count += 1
        if self.refused_count == 1:
            self._log.warning(
                f"{self._name}: cannot carry a message: {error} (more of this kind are not told)"
            )

    def close(self) -> None:
        """End the route."""
        self._receiver.close()
        self._sender.close()


class ServiceRoute:
    """Service of one side that is offered on the other side."""

    def __init__(
        self,
        service: tuple[str, str, str],
        sides: tuple[Side, Side],
        node: str,
        *,
        request: Callable[[bytes], bytes] | None,
        response: Callable[[bytes], bytes] | None,
    ) -> None:
        """Begin to offer the service.

        Args:
            service: Name on the first side, name on the second side, and type.
            sides: The side with the server, and the side with the clients.
            node: Full name, on the second side, of the node that has the service.
            request: Converts the bytes of a request, or `None`.
            response: Converts the bytes of a response, or `None`.
        """
        name, other_name, type_name = service
        self._request, self._response = request, response
        self._caller = sides[0].caller(name, type_name)
        with _closed_on_error(self._caller):
            self._server = sides[1].server(other_name, type_name, node, self._serve)

    def _serve(self, data: bytes, answer: Answer) -> None:
        try:
            request = data if self._request is None else self._request(data)
        except CodecError as error:
            answer.fail(_as_call_error(error))
            return
        self._caller.call(
            request, answer if self._response is None else _Converted(answer, self._response)
        )

    def close(self) -> None:
        """End the route. Calls without an answer fail."""
        self._server.close()
        self._caller.close()


class _Converted:
    """Answer whose response is converted first."""

    def __init__(self, answer: Answer, convert: Callable[[bytes], bytes]) -> None:
        self._answer, self._convert = answer, convert

    def reply(self, data: bytes) -> None:
        try:
            converted = self._convert(data)
        except CodecError as error:
            self._answer.fail(_as_call_error(error))
            return
        self._answer.reply(converted)

    def fail(self, error: CallError) -> None:
        self._answer.fail(error)


@contextmanager
def _closed_on_error(entity: Entity) -> Iterator[None]:
    """Remove the first endpoint of a route if there is no second one."""
    try:
        yield
    except BaseException:
        entity.close()
        raise


def _as_call_error(error: CodecError) -> CallError:
    return CallError("CodecError", str(error))
