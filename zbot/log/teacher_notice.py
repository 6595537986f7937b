"""What a teacher says to a class, on the terminals of its students' nodes."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from zbot.log import get_logger
from zbot.terminal_text import plain

if TYPE_CHECKING:
    import zenoh

_LONGEST = 500  # characters
_MOST_BYTES = 10_000

#: What teachers publish their words on (docs/wire.md); only they may.
NOTICE_KEY = "@class/teacher/notice"


def log_notice(sample: zenoh.Sample) -> None:
    """Log what the teacher says."""
    text = notice_text(sample.payload.to_bytes())
    if text:
        get_logger("class").info(f"the teacher says: {text}")


def notice_text(payload: bytes) -> str:
    """Return what a notice says, fit for a terminal; empty if it is none."""
    if len(payload) > _MOST_BYTES:
        return ""
    try:
        found = json.loads(payload)
    except (ValueError, RecursionError):
        return ""
    return plain(str(found.get("text", "")), _LONGEST) if isinstance(found, dict) else ""
