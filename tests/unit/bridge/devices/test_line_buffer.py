from __future__ import annotations

from zbot.bridge.devices.serial.line_buffer import LineBuffer


def test_bytes_are_cut_into_lines() -> None:
    buffer = LineBuffer()
    assert buffer.feed(b"a: 1\r\nb:") == [b"a: 1\r"]
    assert buffer.feed(b" 2") == []
    assert buffer.feed(b"\n\nc") == [b"b: 2", b""]
    assert len(buffer) == 1


def test_a_line_that_had_begun_earlier_is_skipped() -> None:
    buffer = LineBuffer()
    buffer.skip_line()
    assert buffer.feed(b"rature: 1") == []
    assert buffer.feed(b"\ntemperature: 2\n") == [b"temperature: 2"]


def test_a_line_without_end_does_not_fill_the_memory() -> None:
    buffer = LineBuffer()
    for _ in range(200):
        assert buffer.feed(b"x" * 1000) == []
    assert len(buffer) == 0
    assert buffer.feed(b"end\na: 1\n") == [b"a: 1"]
    assert buffer.too_long == 1
