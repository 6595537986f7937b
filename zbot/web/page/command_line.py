"""Command line of `zbot` that does the same as a click in the page. The user can copy the line."""

from __future__ import annotations

import re
import shlex

_BARE = re.compile(r"[\w@%+=:,./~-]+\Z")
#: Characters that a shell changes inside double quotes.
_UNSAFE_IN_DOUBLE_QUOTES = re.compile(r"[\"$`\\!]")


def command_line(*words: str) -> str:
    """Return the command line of `zbot` with these words.

    An example is `zbot topic pub /a std_msgs/msg/Bool "{data: true}"`. Words get double
    quotes where possible, because all shells understand double quotes, also on Windows.
    """
    return " ".join(("zbot", *map(_quoted, words)))


def _quoted(word: str) -> str:
    if _BARE.match(word):
        return word
    return shlex.quote(word) if _UNSAFE_IN_DOUBLE_QUOTES.search(word) else f'"{word}"'
