from __future__ import annotations

import pytest

from zbot.log.teacher_notice import notice_text
from zbot.text.terminal import single_line


def test_notice_text_is_the_teachers_text() -> None:
    assert notice_text(b'{"text": "five minutes", "time": 1.5}') == "five minutes"


@pytest.mark.parametrize(
    "payload", [b"", b"\xff", b"[]", b"5", b"{", b"[" * 5000, b'{"words": "x"}', b'"text"']
)
def test_an_invalid_notice_has_no_text(payload: bytes) -> None:
    assert not notice_text(payload)


def test_a_notice_has_no_control_characters_and_a_maximum_length() -> None:
    assert notice_text(b'{"text": "\\u001b[2J\\nhello\\u202e"}') == "[2J hello"
    assert len(notice_text(b'{"text": "' + b"x" * 5000 + b'"}')) == 500
    assert not notice_text(b'{"text": "' + b"x" * 50_000 + b'"}')


def test_a_truncated_line_does_not_end_with_a_space() -> None:
    assert single_line("a b  c", 4) == "a b"
