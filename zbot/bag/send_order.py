"""Order of messages by the times at which they were sent."""

from __future__ import annotations

import heapq
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.bag.message import BagMessage


def in_send_order(messages: Iterator[BagMessage], size: int) -> Iterator[BagMessage]:
    """Yield messages in the order of sending. Their `log_ns` becomes the time of sending.

    The input has the order of recording, and `size` messages are sorted at a time. So a message
    comes too late if it was recorded more than `size` messages after a message that was sent later.
    """
    waiting: list[tuple[int, int, BagMessage]] = []
    for number, one in enumerate(messages):
        heapq.heappush(waiting, (one.publish_ns, number, one))
        if len(waiting) > size:
            yield _first(waiting)
    while waiting:
        yield _first(waiting)


def _first(waiting: list[tuple[int, int, BagMessage]]) -> BagMessage:
    time_ns, _, message = heapq.heappop(waiting)
    return message._replace(log_ns=time_ns)
