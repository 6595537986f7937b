"""Request of a service call, with the time-outs of its attempts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import zenoh

# Zenoh keeps 0.8 kB for each query until the query's timeout, even if the reply came long before.
# So the timeout is short, and the request is repeated at growing intervals (docs/wire.md).
_FIRST_TIMEOUT_S = 2.0
_LONGEST_TIMEOUT_S = 60.0
_TIMEOUT_REPLY = b"Timeout"  # Zenoh's own error reply after the timeout


class ServiceRequest:
    """Encoded request, which is sent again after each timeout of its Zenoh query.

    Args:
        payload: The encoded request.
        attachment: Number and gid of the request. Each repetition has the same number and gid, so
            that the server runs its callback once.
        timeout_s: Seconds until the call fails. With `None`, the call does not fail, and the
            request is repeated.
    """

    __slots__ = ("_has_timed_out", "_is_repeated", "attachment", "payload", "timeout_s")

    def __init__(self, payload: Any, attachment: bytes, *, timeout_s: float | None = None) -> None:
        self.payload = payload
        self.attachment = attachment
        self._is_repeated = timeout_s is None
        self._has_timed_out = False
        self.timeout_s = _FIRST_TIMEOUT_S if timeout_s is None else timeout_s

    def is_timeout(self, reply: zenoh.Reply) -> bool:
        """Return whether a reply is a timeout of Zenoh, and the request is to be repeated.

        One attempt may time out twice: in this session and in the server's session.
        """
        if not self._is_repeated or reply.ok is not None or reply.err is None:
            return False
        if reply.err.payload.to_bytes() != _TIMEOUT_REPLY:
            return False
        self._has_timed_out = True
        return True

    def is_to_be_repeated(self) -> bool:
        """After an attempt, return whether it timed out. If it did, double the next timeout."""
        if not self._has_timed_out:
            return False
        self._has_timed_out = False
        self.timeout_s = min(2 * self.timeout_s, _LONGEST_TIMEOUT_S)
        return True
