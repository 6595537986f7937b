"""Reader of the payloads of MQTT messages: JSON, numbers, ON and OFF, words."""

from __future__ import annotations

from typing import Any

from zbot.bridge.devices.errors import UnreadableError
from zbot.bridge.devices.text_value import word_of
from zbot.text.json_reader import JsonError, read_json


def read_payload(data: bytes) -> Any:
    """Return the value of a payload: a word, or a list or dictionary of JSON.

    Raises:
        UnreadableError: The payload is not text, e.g. it is a picture.
    """
    try:
        text = data.decode().strip()
    except UnicodeDecodeError:
        raise UnreadableError("it is not text") from None
    if text[:1] in {"{", "[", '"'}:
        try:
            value = read_json(text)
        except JsonError:
            return word_of(text)
        return word_of(value) if isinstance(value, str) else value
    return word_of(text)
