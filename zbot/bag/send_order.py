"""Order of messages by the times at which they were sent."""

from __future__ import annotations

import heapq
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.bag.message import BagMessage


def in_send_order(messages: Iterator[BagMessage], size: int) -> Iterator[BagMessage]:
    """Yield messages by the times at which they were sent, which replace the times of recording.

    A bag is in the order of recording. A message comes too late in the result if it was recorded
    more than `size` messages after one that was sent later.
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
