"""The `zbot` command that does what a click did, to read and to copy."""

from __future__ import annotations

import re
import shlex

_BARE = re.compile(r"[\w@%+=:,./~-]+\Z")
#: What a shell would change inside double quotes.
_TREACHEROUS = re.compile(r"[\"$`\\!]")


def command_line(*words: str) -> str:
    """Return words as one types them: `zbot topic pub /a std_msgs/msg/Bool "{data: true}"`.

    Double quotes where they suffice, as every shell knows them, also Windows'.
    """
    return " ".join(("zbot", *map(_quoted, words)))


def _quoted(word: str) -> str:
    if _BARE.match(word):
        return word
    return shlex.quote(word) if _TREACHEROUS.search(word) else f'"{word}"'
