from __future__ import annotations

import pytest

from zbot.log.announcement import notice_text
from zbot.terminal_text import plain


def test_a_notice_is_what_the_teacher_said() -> None:
    assert notice_text(b'{"text": "five minutes", "time": 1.5}') == "five minutes"


@pytest.mark.parametrize(
    "payload", [b"", b"\xff", b"[]", b"5", b"{", b"[" * 5000, b'{"words": "x"}', b'"text"']
)
def test_what_is_no_notice_says_nothing(payload: bytes) -> None:
    assert not notice_text(payload)


def test_a_notice_moves_no_cursor_and_has_an_end() -> None:
    assert notice_text(b'{"text": "\\u001b[2J\\nhello\\u202e"}') == "[2J hello"
    assert len(notice_text(b'{"text": "' + b"x" * 5000 + b'"}')) == 500
    assert not notice_text(b'{"text": "' + b"x" * 50_000 + b'"}')


def test_plain_text_is_cut_without_leaving_a_space() -> None:
    assert plain("a b  c", 4) == "a b"
