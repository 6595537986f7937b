"""Info about a message, which a subscription's callback can take as a second argument."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any, TypedDict

from zbot.executor.errors import CallbackSignatureError

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
        CallbackSignatureError: The number of the callback's arguments is not 1 or 2.
    """
    expected = "(message) or (message, info)"
    if not callable(callback):
        raise CallbackSignatureError("a subscription's callback", expected)
    try:
        signature = inspect.signature(callback)
    except (TypeError, ValueError):
        return False  # some builtins have no signature: they get only the message
    for arguments in ((None,), (None, None)):
        try:
            signature.bind(*arguments)
        except TypeError:
            continue
        return len(arguments) == 2
    raise CallbackSignatureError("a subscription's callback", expected)
