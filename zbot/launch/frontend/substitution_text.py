r"""Parser of texts with substitutions: `$(find-pkg-share my_pkg)/config/$(var robot).yaml`.

Blanks separate arguments. An argument in quotes may contain blanks. Arguments with and without
quotes may contain substitutions. If a substitution is in a quoted argument, quotes inside this
substitution are plain text. After a backslash, the characters `$`, `(`, `)`, quotes and backslash
are plain text.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from zbot.launch.errors import CoercionError, SubstitutionSyntaxError
from zbot.launch.frontend.registry import make_substitution
from zbot.launch.substitution import TextSubstitution
from zbot.launch.typed_value import is_instance_of_valid_type

if TYPE_CHECKING:
    from zbot.launch.substitution import Substitution

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_-]*")
_ESCAPED = "\\$\"'()"
_MAX_LEVELS = 50
_BLANKS = " \t\r\n"


def parse(text: str) -> list[Substitution]:
    """Return the substitutions that a text contains. Plain parts become `TextSubstitution`.

    Raises:
        SubstitutionSyntaxError: The text does not follow the grammar.
    """
    return _Parser(text).template("")


def parse_if_substitutions(value: Any) -> Any:
    """Parse a text, or each text of a list. Values of other types are returned unchanged.

    A text without substitutions is returned as it is. A text with substitutions is returned as the
    list of its parts.

    Raises:
        CoercionError: The items of a list have different types.
        SubstitutionSyntaxError: A text does not follow the grammar.
    """
    if isinstance(value, list):
        items = [parse_if_substitutions(item) for item in value]
        if not is_instance_of_valid_type([item for item in items if not isinstance(item, list)]):
            raise CoercionError(f"the items of a list must have one type: {value}")
        return items
    if not isinstance(value, str):
        return value
    parts = parse(value)
    texts = [part.text for part in parts if isinstance(part, TextSubstitution)]
    return "".join(texts) if len(texts) == len(parts) else parts


class _Parser:
    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0
        self._levels = 0
        self._is_quoted = False  #: whether `_at` is inside quotes, where quotes are plain text

    @property
    def _next(self) -> str:
        return self._text[self._at : self._at + 1]

    def template(self, ends: str) -> list[Substitution]:
        """Read until a character of `ends`. If `ends` is empty, read the whole text."""
        parts: list[Substitution] = []
        plain = ""
        while self._next and self._next not in ends:
            if self._text.startswith("$(", self._at):
                parts += [TextSubstitution(text=plain)] if plain else []
                plain = ""
                parts.append(self._substitution())
            elif ends == _BLANKS + ")" and self._next in "\"'" and not self._is_quoted:
                parts += [TextSubstitution(text=plain)] if plain else []
                plain = ""
                parts += self._quoted()
            else:
                plain += self._character()
        return parts + ([TextSubstitution(text=plain)] if plain or not parts else [])

    def _character(self) -> str:
        if self._next == "\\" and self._text[self._at + 1 : self._at + 2] in tuple(_ESCAPED):
            self._at += 1
        self._at += 1
        return self._text[self._at - 1]

    def _quoted(self) -> list[Substitution]:
        quote = self._next
        self._at += 1
        self._is_quoted = True
        parts = self.template(quote)
        self._is_quoted = False
        if self._next != quote:
            raise SubstitutionSyntaxError(f"the quote {quote} is not closed in: {self._text}")
        self._at += 1
        return parts

    def _substitution(self) -> Substitution:
        self._at += 2
        self._skip_blanks()
        match = _NAME.match(self._text, self._at)
        if match is None:
            raise SubstitutionSyntaxError(f"a name must follow '$(' in: {self._text}")
        self._at = match.end()
        self._levels += 1
        if self._levels > _MAX_LEVELS:
            raise SubstitutionSyntaxError(f"'$(' is nested deeper than {_MAX_LEVELS} levels")
        arguments: list[list[Substitution]] = []
        while True:
            self._skip_blanks()
            if self._next == ")":
                self._at += 1
                self._levels -= 1
                return make_substitution(match[0], arguments)
            if not self._next:
                raise SubstitutionSyntaxError(f"'$({match[0]}' is not closed in: {self._text}")
            arguments.append(self.template(_BLANKS + ")"))

    def _skip_blanks(self) -> None:
        while self._next and self._next in _BLANKS:
            self._at += 1
