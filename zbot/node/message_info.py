"""Info about a message, which a subscription's callback can take as a second argument."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypedDict

from zbot.executor.callback_check import check_callback

if TYPE_CHECKING:
    from collections.abc import Callable


class PublisherGid(TypedDict):
    """The publisher that sent a message."""

    implementation_identifier: str
    data: bytes


class MessageInfo(TypedDict):
    """Info about a message. Its times are nanoseconds since the epoch."""

    source_timestamp: int
    received_timestamp: int
    publication_sequence_number: int
    reception_sequence_number: int
    publisher_gid: PublisherGid | None  #: `None` if the publisher is unknown


def takes_info(callback: Callable[..., Any]) -> bool:
    """Return true if a callback takes a message and its info, or false if it takes a message only.

    Raises:
        WrongTypeError: The callback is not callable.
        WrongStateError: The number of the callback's arguments is not 1 or 2.
    """
    forms = ("(message)", "(message, info)")
    return check_callback("create_subscription", callback, *forms, position=2) == 1
