"""WebSocket frames of a message for a client. Clients may ask for compression or fragments."""

from __future__ import annotations

import array
import base64
import io
import itertools
import json
import math
import sys
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

from zbot.interfaces.plain_value import octets_of
from zbot.interfaces.slot import walk

if TYPE_CHECKING:
    from zbot.interfaces.slot import Slot

Compression: TypeAlias = Literal["none", "png", "cbor", "cbor-raw"]

#: Content of one frame: text or bytes.
Frame: TypeAlias = "str | bytes"

COMPRESSIONS = ("none", "png", "cbor", "cbor-raw")
_MAX_FRAGMENTS = 10_000
_numbers = itertools.count(1)
#: Tag of the typed array for each typecode of Python's `array`.
_TAGS = {"H": 69, "I": 70, "Q": 71, "b": 72, "h": 77, "i": 78, "q": 79, "f": 85, "d": 86}


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
        return [cbor(fields)]
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


def typed_array(typecode: str, values: Any) -> Any:
    """Return numbers that CBOR stores as one block of bytes.

    Args:
        typecode: The typecode of Python's `array`.
        values: The numbers.
    """
    import cbor2  # noqa: PLC0415 - few clients want CBOR

    numbers = array.array(typecode, values)
    if sys.byteorder == "big":
        numbers.byteswap()
    return cbor2.CBORTag(_TAGS[typecode], numbers.tobytes())


def cbor_value(message: Any) -> dict[str, Any]:
    """Return a message as a dictionary for `cbor`."""
    return walk(message, _leaf)


def _leaf(value: Any, slot: Slot) -> Any:
    if not slot.is_list:
        return _scalar(value)
    if slot.is_message:
        return [walk(item, _leaf) for item in value]
    if slot.is_octets:
        return octets_of(value, slot)
    if slot.type.typecode:
        return typed_array(slot.type.typecode, value)
    return [_scalar(item) for item in value]


def _scalar(value: Any) -> Any:
    if isinstance(value, bytes):
        return value[0]  # a field of the type byte
    return value.item() if hasattr(value, "item") else value


def cbor(value: Any) -> bytes:
    """Return the CBOR of a value made of dictionaries, lists, scalars, bytes and typed arrays."""
    import cbor2  # noqa: PLC0415 - few clients want CBOR

    return cbor2.dumps(value)
