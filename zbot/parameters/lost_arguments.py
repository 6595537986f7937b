"""Arguments that have no effect, because `--ros-args` is missing in front of them.

ROS 1, the first versions of ROS 2, and many old texts write `chatter:=/news` and `__node:=other`
without `--ros-args`.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from zbot.errors.suggestion import nearest, question

if TYPE_CHECKING:
    from collections.abc import Sequence

_BEGIN = "--ros-args"
_ASSIGNMENT = re.compile(r"(?P<name>[~/\w]+):=(?P<value>.+)", re.DOTALL)
#: A value that is a number, a bool or a list, and so not the name of a topic.
_PARAMETER = re.compile(r"[-+]?[0-9.].*|true|false|\[.*", re.IGNORECASE | re.DOTALL)
_FLAGS = {"-r", "--remap", "-p", "--param", "--params-file"}
_SPECIAL = {"__params": "--params-file", "__log_level": "--log-level"}


def warning_about(words: Sequence[str]) -> str:
    """Return a sentence about the arguments that have no effect, or an empty string.

    Args:
        words: The words outside of `--ros-args ... --`.
    """
    for word in words:
        if word.startswith("-") and nearest(word, [_BEGIN]):
            return f"{word} has no effect{question([_BEGIN], '; ')}"
    lost, right = list[str](), list[str]()
    for before, word in zip(("", *words), words, strict=False):
        wanted = _right(before, word)
        if wanted:
            lost += [before, word] if before in _FLAGS else [word]
            right.append(wanted)
    if not lost:
        return ""
    return f"'{' '.join(lost)}' has no effect; write {_BEGIN} {' '.join(right)}"


def _right(flag: str, word: str) -> str:
    """Return how an argument is written after `--ros-args`. It is empty for other arguments."""
    if flag == "--params-file":
        return f"{flag} {word}"
    match = _ASSIGNMENT.fullmatch(word)
    if match is None:
        return ""
    if flag in _FLAGS:
        return f"{flag} {word}"
    name, value = match["name"], match["value"]
    if name in _SPECIAL:
        return f"{_SPECIAL[name]} {value}"
    if name.startswith("_") and not name.startswith("__"):
        return f"-p {name[1:]}:={value}"
    return f"{'-p' if _PARAMETER.fullmatch(value) else '-r'} {word}"
