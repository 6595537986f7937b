"""Pictures of topics as addresses for browsers. Threads encode them once for all pages."""

from __future__ import annotations

import base64
from concurrent.futures import Future, ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, NamedTuple
from weakref import WeakKeyDictionary

from zbot.interfaces import type_name
from zbot.observer.image_encoder import (
    COMPRESSED_IMAGE,
    IMAGE,
    ImageError,
    encode_jpeg,
    media_type,
)

if TYPE_CHECKING:
    from zbot.observer.watch import Feed, Record, Watch

_THREADS = ThreadPoolExecutor(2, "zbot web pictures")
#: A compressed image goes to the browser as it is.
_MOST_BYTES = 5_000_000


class Picture(NamedTuple):
    """Picture of a message."""

    record: Record
    message: Any
    address: str  #: for the browser. It is empty if there is a problem
    text: str  #: its size or format, or the problem


class _TopicPictures:
    """Pictures of one topic. Of the messages that come during the encoding, the newest is next."""

    def __init__(self) -> None:
        self._newest: Picture | None = None
        self._coming: Future[Picture] | None = None

    def newest(self, record: Record | None, message: Any) -> Picture | None:
        if self._coming is not None and self._coming.done():
            self._newest, self._coming = self._coming.result(), None
        is_new = self._newest is None or self._newest.record is not record
        if self._coming is None and record is not None and message is not None and is_new:
            self._coming = _THREADS.submit(_encoded, record, message)
        return self._newest


_TOPICS: WeakKeyDictionary[Feed, _TopicPictures] = WeakKeyDictionary()


def newest_picture(watch: Watch) -> Picture | None:
    """Return the newest picture of a topic, or None. Call this in NiceGUI's loop.

    A thread encodes the newest message, so its picture comes with a later call.
    """
    pictures = _TOPICS.setdefault(watch.feed, _TopicPictures())
    return pictures.newest(*watch.latest_record)


def _encoded(record: Record, message: Any) -> Picture:
    try:
        return Picture(record, message, *image_address(message))
    except Exception as error:  # noqa: BLE001 - the message may have any type and content
        return Picture(record, message, "", str(error))


def image_address(message: Any) -> tuple[str, str]:
    """Return an image as an address for the browser, and its size or format as text.

    Raises:
        ImageError: The image cannot be shown.
    """
    name = type_name(type(message))
    if name == IMAGE:
        data, kind = encode_jpeg(message), "image/jpeg"
        text = f"{message.width} x {message.height}, {message.encoding}"
    elif name != COMPRESSED_IMAGE:
        raise ImageError(f"{name} is no type of images: choose another topic")
    elif len(message.data) > _MOST_BYTES:
        raise ImageError("the compressed image is larger than 5 MB")
    else:
        data = bytes(message.data)
        kind, text = media_type(data), message.format
    return f"data:{kind};base64,{base64.b64encode(data).decode()}", text
