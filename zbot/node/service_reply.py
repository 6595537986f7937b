"""Reply to a service request: a response, or the error of the server's callback."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.node.errors import ServiceError
from zbot.wire.error_reply import unpack_error

if TYPE_CHECKING:
    import zenoh


def response_sample(reply: zenoh.Reply | None, service: str) -> zenoh.Sample:
    """Return the sample with the response in a reply.

    Args:
        reply: The reply, or `None` if the server ended without a reply.
        service: Full name of the service.

    Raises:
        ServiceError: The reply is an error, or there is none.
    """
    if reply is None:
        raise ServiceError(service, "server_gone", "the server ended before it answered")
    if reply.ok is None:
        payload = b"" if reply.err is None else reply.err.payload.to_bytes()
        raise ServiceError(service, *unpack_error(payload))
    return reply.ok
