"""Notices from a teacher to a classroom. The students' nodes log the notices."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.log import get_logger
from zbot.text.json_reader import JsonError, read_json_object
from zbot.text.terminal import single_line

if TYPE_CHECKING:
    import zenoh

_MAX_LENGTH = 500  # characters
_MAX_BYTES = 10_000

#: Key of the notices (docs/wire.md). Only the teacher may publish on it.
NOTICE_KEY = "@class/teacher/notice"


def log_notice(sample: zenoh.Sample) -> None:
    """Log a teacher's notice."""
    text = notice_text(sample.payload.to_bytes())
    if text:
        get_logger("class").info(f"the teacher says: {text}")


def notice_text(payload: bytes) -> str:
    """Return the text of a notice in one printable line. Return `""` for an invalid notice."""
    try:
        found = read_json_object(payload, _MAX_BYTES)
    except JsonError:
        return ""
    return single_line(str(found.get("text", "")), _MAX_LENGTH)
