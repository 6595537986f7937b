"""WebSocket frames of a message for a client. Clients may ask for compression or fragments."""

from __future__ import annotations

import base64
import io
import itertools
import json
import math
from typing import Any, Literal, TypeAlias

from zbot.web.rosbridge import cbor

Compression: TypeAlias = Literal["none", "png", "cbor", "cbor-raw"]

#: Content of one frame: text or bytes.
Frame: TypeAlias = "str | bytes"

COMPRESSIONS = ("none", "png", "cbor", "cbor-raw")
_MAX_FRAGMENTS = 10_000
_numbers = itertools.count(1)


def frames(
    fields: dict[str, Any], compression: str = "none", fragment_size: int | None = None
) -> list[Frame]:
    """Return the frames of a message for a client.

    Args:
        fields: The message. For `cbor` and `cbor-raw` it may contain bytes and typed arrays,
            otherwise only values that JSON allows.
        compression: One of `COMPRESSIONS`. With `cbor` and `cbor-raw`, there are never
            fragments.
        fragment_size: The largest number of characters of the message in one frame. A message has
            at most 10,000 fragments, so the fragments of a very long message may be longer.
    """
    if compression in {"cbor", "cbor-raw"}:
        return [cbor.encode(fields)]
    text = dump(fields)
    if compression == "png":
        text = dump({"op": "png", "data": png(text)})
    if fragment_size is None or len(text) <= fragment_size:
        return [text]
    size = max(fragment_size, math.ceil(len(text) / _MAX_FRAGMENTS))
    parts = [text[start : start + size] for start in range(0, len(text), size)]
    facts = {"op": "fragment", "id": str(next(_numbers)), "total": len(parts)}
    return [dump({**facts, "num": number, "data": part}) for number, part in enumerate(parts)]


def dump(fields: dict[str, Any]) -> str:
    """Return the JSON text of a message."""
    return json.dumps(fields, separators=(",", ":"), allow_nan=False)


def png(text: str) -> str:
    """Return a PNG picture in base64. Its pixels are the bytes of a text, filled up with newlines.

    This is the form in which rosbridge compresses messages.
    """
    from PIL import Image  # noqa: PLC0415 - few clients want PNG

    octets = text.encode()
    width = max(1, math.isqrt(len(octets) // 3))
    height = math.ceil(len(octets) / 3 / width)
    picture = Image.frombytes("RGB", (width, height), octets.ljust(3 * width * height, b"\n"))
    file = io.BytesIO()
    picture.save(file, "png")
    return base64.b64encode(file.getvalue()).decode()
