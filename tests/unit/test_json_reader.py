from __future__ import annotations

import time

import pytest

from zbot.json_reader import JsonError, read_json, read_json_object

DEEP = "[" * 64 + "1" + "]" * 64


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (b"", "Expecting value"),
        (b"{'a': 1}", "Expecting property name"),
        (b'{"a": 1} x', "Extra data"),
        (b"\xff\xfe\xfd", "codec"),
        (b"\x00" * 5, "codec"),
        (b'{"pid": Infinity}', "Infinity is not a number"),
        (b'{"pid": NaN}', "NaN is not a number"),
        (b'{"pid": 1e999999}', "a number is infinite"),
        (b"-1e999999", "a number is infinite"),
        (b"9" * 5000, "more than 400 digits"),
        (b'"\\ud800"', "UTF-8"),
        (b'{"\\udfff": 1}', "UTF-8"),
        ('["\ud800"]', "UTF-8"),
        (f"[{DEEP}]".encode(), "nested deeper than 64 levels"),
        (b"[" * 100_000, "nested deeper than 64 levels"),
        (b"[" * 1_000_000, "more than 200000 objects and lists"),
        (b'{"a":' * 100_000, "nested deeper than 64 levels"),
        (b" " * 1001 + b"1", "longer than 1000 bytes"),
    ],
)
def test_invalid_json_is_one_error(text: bytes | str, reason: str) -> None:
    begin = time.process_time()
    with pytest.raises(JsonError, match=r"^this is not valid JSON: ") as caught:
        read_json(text, 1000 if reason.startswith("longer") else 10**7)
    assert reason in caught.value.reason
    assert time.process_time() - begin < 3


def test_valid_json_is_read() -> None:
    assert read_json('{"a": [1, -2.5, "\\u00e9", "\\ud83e\\udd16", null, true]}') == {
        "a": [1, -2.5, "é", "\U0001f916", None, True]
    }
    assert read_json(DEEP)
    assert read_json_object("{}") == {}
    with pytest.raises(JsonError, match="it is not an object"):
        read_json_object("[]")


@pytest.mark.parametrize(
    "text",
    [
        "[" + "{}," * 200_000 + "1]",
        "[" + "[]," * 200_000 + "1]",
        "[" + "1," * 1_100_000 + "1]",
        '["\\\\",' + "{}," * 200_000 + "1]",
        '"' + "[" * 5_000_000 + '"',  # too long for a count without strings
    ],
)
def test_json_that_needs_much_more_memory_than_its_text_is_refused(text: str) -> None:
    begin = time.process_time()
    with pytest.raises(JsonError, match="more than 200000 objects and lists, or 1100000 values"):
        read_json(text)
    assert time.process_time() - begin < 1


@pytest.mark.parametrize("text", ["{,[" * 200_000, '{\\"' * 200_000])
def test_the_characters_inside_strings_are_no_values(text: str) -> None:
    assert read_json(f'["{text}"]') == [text.replace("\\", "")]


def test_a_map_of_a_million_cells_is_read() -> None:
    assert len(read_json("[" + "0," * 999_999 + "0]")) == 1_000_000
