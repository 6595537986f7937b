"""Tests of the pictures that threads encode for all pages."""

from __future__ import annotations

import threading
from types import SimpleNamespace
from typing import Any

import pytest

from tests.conftest import wait_until
from zbot.observer.image_encoder import ImageError
from zbot.observer.watch import Record
from zbot.web.page import encoded_picture
from zbot.web.page.encoded_picture import Picture, image_address, newest_picture

from sensor_msgs.msg import CompressedImage, Image
from std_msgs.msg import String


class Feed:
    """Topic that two watches share."""


def watch(feed: Feed, number: int, message: Any) -> Any:
    return SimpleNamespace(feed=feed, latest_record=(Record(number, 0, 0, b""), message))


def image() -> Image:
    return Image(width=2, height=1, step=2, encoding="mono8", data=b"ab")


def wait_for_picture(seen: Any) -> Picture:
    assert wait_until(lambda: newest_picture(seen) is not None)
    newest = newest_picture(seen)
    assert newest is not None
    return newest


def test_pages_share_a_picture_that_a_thread_encodes(monkeypatch: pytest.MonkeyPatch) -> None:
    threads: list[int] = []

    def encode(message: Any) -> tuple[str, str]:
        threads.append(threading.get_ident())
        return image_address(message)

    monkeypatch.setattr(encoded_picture, "image_address", encode)
    feed = Feed()
    seen = watch(feed, 1, image())
    newest = wait_for_picture(seen)
    assert newest.address.startswith("data:image/jpeg;base64,")
    assert newest.text == "2 x 1, mono8"
    other = SimpleNamespace(feed=feed, latest_record=seen.latest_record)
    assert newest_picture(other) is newest  # type: ignore[arg-type]
    assert len(threads) == 1
    assert threads[0] != threading.get_ident()


def test_a_message_without_a_picture_does_not_stop_the_next() -> None:
    feed = Feed()
    text = wait_for_picture(watch(feed, 1, String())).text
    assert text == "std_msgs/msg/String is no type of images: choose another topic"
    seen = watch(feed, 2, image())
    newest_picture(seen)
    assert wait_until(lambda: wait_for_picture(seen).record.number == 2)


def test_a_compressed_image_has_a_limit() -> None:
    with pytest.raises(ImageError, match="larger than 5 MB"):
        image_address(CompressedImage(format="png", data=bytes(5_000_001)))
