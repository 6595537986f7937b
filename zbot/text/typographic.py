"""Characters that word processors and web pages put in place of those on the keyboard.

Python, YAML and the shell do not accept such characters as quotes, signs or spaces.
"""

# ruff: noqa: RUF001 - these characters are the subject

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

_QUOTES = dict.fromkeys("“”„‟″«»", '"') | dict.fromkeys("‘’‚‛′‹›´", "'")
_SIGNS = dict.fromkeys("‐‑‒–—―−", "-") | {"…": "...", "×": "*", "÷": "/"}
_SIGNS |= {"≤": "<=", "≥": ">=", "≠": "!=", "⁄": "/", "∗": "*", "、": ",", "。": "."}
_SPACES = dict.fromkeys("\u00a0\u2002\u2003\u2007\u2009\u200a\u202f\u3000", "a space")
_INVISIBLE = dict.fromkeys("\u00ad\u200b\u200c\u200d\u200e\u200f\u2060\ufeff", "")
# East Asian keyboards type these wide forms of the characters of ASCII.
_WIDE = {chr(code): chr(code - 0xFEE0) for code in range(0xFF01, 0xFF5F)}
_TYPED = {**_WIDE, **_SIGNS, **_QUOTES, **_SPACES, **_INVISIBLE}
_ANY = re.compile(f"[{''.join(_TYPED)}]")
_CODE = re.compile(r"\bU\+([0-9A-F]{4,6})\b")


def advice(text: str) -> str:
    """Return what to type in place of the first such character, or an empty string."""
    found = _ANY.search(text)
    return _advice_for(found[0]) if found else ""


def advice_for_words(words: Iterable[str]) -> str:
    """Return the advice for the first word of a command line that begins with such a character."""
    wrong = next((word for word in words if word and _ANY.match(word)), "")
    if _TYPED.get(wrong[:1]) == "-":  # an option
        name = wrong.lstrip("".join(_SIGNS) + "-")
        return f"type {'--' if len(name) > 1 else '-'}{name} in place of {wrong}"
    return advice(wrong[:1])


def is_quoted(text: str) -> bool:
    """Return whether a text begins and ends with quotes that are not those of the keyboard."""
    return len(text) > 1 and _QUOTES.keys() >= {text[0], text[-1]}


def _advice_for(character: str) -> str:
    typed, code = _TYPED[character], f"U+{ord(character):04X}"
    if character in _INVISIBLE:
        return f"delete the invisible character {code}"
    if character in _SPACES:
        return f"the character {code} only looks like a space: type a space"
    return f"type {typed} in place of {character} ({code})"


def advice_for_syntax(message: str, line: str) -> str:
    """Return the advice for an error of Python's parser.

    Args:
        message: Python's message, e.g. `invalid character '“' (U+201C)`.
        line: The line of the program.
    """
    code = _CODE.search(message)
    if code and chr(int(code[1], 16)) in _TYPED:
        return _advice_for(chr(int(code[1], 16)))
    if "unterminated string" in message:
        quote = re.search(f"[{''.join(_QUOTES)}]", line)
        return _advice_for(quote[0]) if quote else ""
    if "decimal literal" in message:  # Python 3.10 says so of a character after a number
        found = re.search(rf"\d({_ANY.pattern})", line)
        return _advice_for(found[1]) if found else ""
    if "tabs and spaces" in message:
        return "indent this line with the same spaces as the lines around it"
    return ""


def advise_of_syntax(error: BaseException | None) -> None:
    """Add the advice to a `SyntaxError`. Do nothing for other errors."""
    if isinstance(error, SyntaxError):
        found = advice_for_syntax(error.msg or "", error.text or "")
        if found and found not in str(error.msg):
            error.msg = f"{error.msg}: {found}"
