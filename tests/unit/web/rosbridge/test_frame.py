from __future__ import annotations

import base64
import io
import json
from typing import Any

import pytest

from zbot.web.rosbridge.frame import frames

MESSAGE = {"op": "publish", "topic": "/a", "msg": {"data": "Grüße, " * 40}}


def joined(parts: list[Any]) -> Any:
    """Return the message in fragments, as a client joins them."""
    fragments = [json.loads(part) for part in parts]
    assert {one["op"] for one in fragments} == {"fragment"}
    assert {one["total"] for one in fragments} == {len(fragments)}
    assert len({one["id"] for one in fragments}) == 1
    assert [one["num"] for one in fragments] == list(range(len(fragments)))
    return json.loads("".join(one["data"] for one in fragments))


def test_a_short_message_is_one_frame() -> None:
    assert [json.loads(one) for one in frames(MESSAGE, fragment_size=10_000)] == [MESSAGE]


def test_a_long_message_is_in_fragments() -> None:
    parts = frames(MESSAGE, fragment_size=50)
    assert len(parts) > 5
    assert joined(parts) == MESSAGE


def test_the_number_of_fragments_is_limited() -> None:
    long = {"op": "publish", "msg": {"data": "x" * 100_000}}
    parts = frames(long, fragment_size=1)
    assert len(parts) <= 10_000
    assert joined(parts) == long


@pytest.mark.parametrize("text", ["", "x", "Grüße, " * 1000])
def test_png_has_the_message_in_its_colours(text: str) -> None:
    image = pytest.importorskip("PIL.Image", reason='PNG needs Pillow: pip install "zbot[web]"')
    [frame] = frames({"op": text}, "png")
    fields = json.loads(frame)
    assert fields["op"] == "png"
    picture = image.open(io.BytesIO(base64.b64decode(fields["data"]))).convert("RGB")
    assert json.loads(picture.tobytes().decode().rstrip("\n")) == {"op": text}


def test_cbor_is_bytes() -> None:
    assert frames({"op": "publish"}, "cbor") == [b"\xa1\x62op\x67publish"]
