"""Report of an error on stderr."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from zbot.terminal.typographic import advice, advice_for_words
from zbot_cli.output.exit_status import Status

if TYPE_CHECKING:
    from zbot.errors import ZbotError


def report(error: ZbotError) -> Status:
    """Print an error's message without a prefix, as ros2 does. Print the hint below it.

    If the user typed a character of a word processor, a hint is about this character.
    """
    print(error, file=sys.stderr)
    hints = [advice(str(error)) or getattr(error, "hint", None), advice_for_words(sys.argv[1:])]
    for hint in dict.fromkeys(filter(None, hints)):
        print(f"\nhint: {hint}", file=sys.stderr)
    return Status.ERROR
