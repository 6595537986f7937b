"""What a teacher says to a class, on the terminals of its students' nodes."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import zenoh

from zbot.log import get_logger
from zbot.plain_text import plain

if TYPE_CHECKING:
    from collections.abc import Callable

_QUEUE = 16
_LONGEST = 500  # characters
_MOST_BYTES = 10_000

#: What teachers publish their words on (docs/wire.md); only they may.
NOTICE_KEY = "@class/teacher/notice"


def follow_notices(
    session: zenoh.Session, start_thread: Callable[[str, Callable[[], None]], None]
) -> zenoh.Subscriber[zenoh.handlers.Handler[zenoh.Sample]]:
    """Log what the teacher says from now on.

    Args:
        session: A session of a laptop that takes part in a class.
        start_thread: Runs a function under a name until the session is closed.

    Returns:
        What has to be kept for as long.
    """
    subscriber = session.declare_subscriber(NOTICE_KEY, zenoh.handlers.FifoChannel(_QUEUE))
    receive = subscriber.handler.recv

    def follow() -> None:
        while True:
            try:
                sample = receive()
            except zenoh.ZError:
                return  # the session was closed
            text = notice_text(sample.payload.to_bytes())
            if text:
                get_logger("class").info(f"the teacher says: {text}")

    start_thread("zbot notices", follow)
    return subscriber


def notice_text(payload: bytes) -> str:
    """Return what a notice says, fit for a terminal; empty if it is none."""
    if len(payload) > _MOST_BYTES:
        return ""
    try:
        found = json.loads(payload)
    except (ValueError, RecursionError):
        return ""
    return plain(str(found.get("text", "")), _LONGEST) if isinstance(found, dict) else ""
