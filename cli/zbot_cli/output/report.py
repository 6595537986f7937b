"""How an error looks on the screen."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from zbot.errors import ZbotError


def report(error: ZbotError) -> Status:
    """Print an error as ros2 does, its bare sentence, and below it what to do about it."""
    print(error, file=sys.stderr)
    hint = getattr(error, "hint", None)
    if hint:
        print(f"\nhint: {hint}", file=sys.stderr)
    return Status.ERROR
