from __future__ import annotations

import contextlib
import sys
import threading
import time

import pytest

from zbot.text.json_reader import JsonError, read_json, read_json_object

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
        (b"[" * 50_000, "nested deeper than 64 levels"),
        (b"[" * 1_000_000, "more than 200000 objects, 50000 lists"),
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
        "[" + "{}," * 200_001 + "1]",
        "[" + "[]," * 50_000 + "1]",
        "[" + "1," * 1_100_000 + "1]",
        '["\\\\",' + "{}," * 200_001 + "1]",
        '["' + "\\\\" * 40_000 + '",' + "{}," * 200_001 + "1]",
    ],
)
def test_json_that_needs_much_more_memory_than_its_text_is_refused(text: str) -> None:
    begin = time.process_time()
    with pytest.raises(JsonError, match="200000 objects, 50000 lists or 1100000 values"):
        read_json(text)
    assert time.process_time() - begin < 1


@pytest.mark.parametrize(
    "text", ["{,[" * 200_000, '{\\"' * 200_000, "a" + '{\\"' * 200_000, "[," * 5_000_000]
)
def test_the_characters_inside_strings_are_no_values(text: str) -> None:
    assert read_json(f'["{text}"]') == [text.replace("\\", "")]


def test_a_map_of_a_million_cells_is_read() -> None:
    assert len(read_json("[" + "0," * 999_999 + "0]")) == 1_000_000


def test_a_string_with_millions_of_escapes_is_refused() -> None:
    with pytest.raises(JsonError, match="more than 1100000 backslashes"):
        read_json('["' + "\\n" * 1_200_000 + '"]')


@pytest.mark.parametrize(
    "text",
    [
        "[" + "{}," * 1_000_000 + "{}]",  # refused
        "[" + '{"a":"b"},' * 199_990 + "{}]",
        '["' + "\\n," * 1_300_000 + '"]',  # refused
        '["' + "," * 3_900_000 + '"]',
    ],
)
def test_other_threads_work_while_a_long_text_is_read(text: str) -> None:
    assert min(longest_hold_s(text) for _ in range(3)) < 0.04


def longest_hold_s(text: str) -> float:
    """Return the most processor time that `read_json` needs before another thread can work."""
    clock = time.pthread_getcpuclockid(threading.get_ident())
    holds = [0.0]
    is_over = threading.Event()

    def watch() -> None:
        before_s = time.clock_gettime(clock)
        while not is_over.is_set():
            now_s = time.clock_gettime(clock)
            holds.append(now_s - before_s)
            before_s = now_s

    turn_s = sys.getswitchinterval()
    sys.setswitchinterval(0.0005)
    watcher = threading.Thread(target=watch)
    try:
        watcher.start()
        with contextlib.suppress(JsonError):
            read_json(text)
    finally:
        is_over.set()
        watcher.join()
        sys.setswitchinterval(turn_s)
    return max(holds)
