"""Report of an error on stderr."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from zbot.errors import ZbotError


def report(error: ZbotError) -> Status:
    """Print an error's message without a prefix, as ros2 does. Print the hint below it."""
    print(error, file=sys.stderr)
    hint = getattr(error, "hint", None)
    if hint:
        print(f"\nhint: {hint}", file=sys.stderr)
    return Status.ERROR
