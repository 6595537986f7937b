"""Content filters, with which a subscription receives only messages that match an expression.

The expressions are those of DDS (annex B of its specification): `data > 3 AND data < %0`,
`pose.position.x BETWEEN 0 AND 1`, `name LIKE 'arm%'`, `NOT is_late = TRUE`. In a `LIKE` pattern,
`%` and `*` match any text. `_` and `?` match one character. `MATCH` takes a regular expression.
`NOT` has the highest precedence. `AND` and `OR` are evaluated from left to right, so use brackets
to mix them.
"""

from __future__ import annotations

import operator
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.interfaces.field_path import FieldPath, FieldPathError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    #: Returns whether a message matches the expression.
    Condition = Callable[[Any], bool]

_TOKEN = re.compile(
    r"""\s*(?: (?P<text>'[^'\n]*') | %(?P<parameter>\d{1,2})
      | (?P<number>[+-]?(?:0[xX][0-9a-fA-F]+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?))
      | (?P<sign><>|!=|<=|>=|[=<>()]) | (?P<word>[A-Za-z_][\w.\[\]]*) )""",
    re.VERBOSE,
)
_INTEGER = re.compile(r"[+-]?(0[xX][0-9a-fA-F]+|[1-9]\d*|0+)\Z")
_COMPARISONS: dict[str, Callable[[Any, Any], bool]] = {
    "=": operator.eq,
    "<>": operator.ne,
    "!=": operator.ne,
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
    "LIKE": lambda value, pattern: re.fullmatch(_regex(pattern), value, re.DOTALL) is not None,
    "MATCH": lambda value, pattern: re.fullmatch(pattern, value) is not None,
}
_WORDS = {"AND", "OR", "NOT", "BETWEEN", "LIKE", "MATCH", "TRUE", "FALSE"}


class ContentFilterError(ZbotError, ValueError):
    """A content filter's expression is not valid for its message type."""

    def __init__(self, expression: str, reason: str) -> None:
        self.expression, self.reason = expression, reason
        super().__init__(f"cannot filter by {expression!r}: {reason}")


@dataclass(frozen=True)
class _Operand:
    """One side of a comparison. `kind` is its type, or `None` if only a message shows the type."""

    read: Callable[[Any], Any]
    kind: str | None
    field: bool = False


class ContentFilter:
    """A compiled expression.

    Args:
        expression: The expression. The module's description shows the grammar.
        parameters: Values of `%0`, `%1` ... in the form that values have in an expression.
        message_type: Class of the messages.

    Raises:
        ContentFilterError: The expression breaks the grammar, names an unknown field, or compares
            values of different types.
    """

    def __init__(self, expression: str, parameters: Sequence[str], message_type: type[Any]) -> None:
        self._condition = _Parser(expression, parameters, message_type).parse()

    def matches(self, message: Any) -> bool:
        """Return whether a message matches the expression.

        A comparison is false if it uses an element that is beyond the end of a list.
        """
        return self._condition(message)


class _Parser:
    def __init__(self, expression: str, parameters: Sequence[str], message_type: type[Any]) -> None:
        self._expression = expression
        self._parameters = parameters
        self._message = message_type()
        self._tokens = list(self._scan(self._expression))
        self._position = 0

    def parse(self) -> Condition:
        condition = self._and_or()
        if self._position < len(self._tokens):
            raise self._error(f"{self._tokens[self._position][1]!r} is unexpected")
        return condition

    def _error(self, reason: str) -> ContentFilterError:
        return ContentFilterError(self._expression, reason)

    def _scan(self, text: str) -> list[tuple[str, str]]:
        tokens, place = [], 0
        while text[place:].strip():
            match = _TOKEN.match(text, place)
            if match is None or match.lastgroup is None:
                raise self._error(f"{text[place:].strip()!r} cannot be read")
            kind, found, place = match.lastgroup, match[match.lastgroup], match.end()
            is_keyword = kind == "word" and found.upper() in _WORDS
            tokens.append(("sign", found.upper()) if is_keyword else (kind, found))
        return tokens

    def _accept(self, *signs: str) -> str:
        """If the next token is one of the signs, skip and return it. Else return ""."""
        if self._position < len(self._tokens):
            kind, text = self._tokens[self._position]
            if kind == "sign" and text in signs:
                self._position += 1
                return text
        return ""

    def _expect(self, sign: str) -> None:
        if not self._accept(sign):
            raise self._error(f"{sign!r} is missing")

    def _and_or(self) -> Condition:
        # DDS defines no precedence of AND and OR. Fast DDS evaluates them from left to right.
        condition = self._negation()
        while word := self._accept("AND", "OR"):
            condition = _combined(word, condition, self._negation())
        return condition

    def _negation(self) -> Condition:
        if self._accept("NOT"):
            inner = self._negation()
            return lambda message: not inner(message)
        if self._accept("("):
            inner = self._and_or()
            self._expect(")")
            return inner
        return self._predicate()

    def _predicate(self) -> Condition:
        left = self._operand()
        negated = bool(self._accept("NOT"))
        if self._accept("BETWEEN"):
            return self._range(left, negated=negated)
        sign = "" if negated else self._accept(*_COMPARISONS)
        if not sign:
            raise self._error("a comparison is missing: = <> < > <= >= LIKE MATCH BETWEEN")
        return self._comparison(left, sign, self._operand())

    def _range(self, value: _Operand, *, negated: bool) -> Condition:
        first = self._operand()
        self._expect("AND")
        low = self._comparison(value, ">=", first)
        high = self._comparison(value, "<=", self._operand())
        return lambda message: (low(message) and high(message)) is not negated

    def _comparison(self, left: _Operand, sign: str, right: _Operand) -> Condition:
        if not (left.field or right.field):
            raise self._error("each comparison needs a field of the message")
        if not (_comparable(left, right) or _comparable(right, left)):
            raise self._error(f"a {left.kind} cannot be compared with a {right.kind}")
        if sign in {"LIKE", "MATCH"}:
            self._check_pattern(left, sign, right)
        compare, first, second = _COMPARISONS[sign], left.read, right.read

        def condition(message: Any) -> bool:
            try:
                return compare(first(message), second(message))
            except FieldPathError:
                return False  # the list is too short

        return condition

    def _check_pattern(self, left: _Operand, sign: str, right: _Operand) -> None:
        if {left.kind, right.kind} - {"string", None}:
            raise self._error(f"{sign} needs strings on both sides")
        if sign == "MATCH" and not right.field:
            pattern = right.read(None)
            try:
                re.compile(pattern)
            except re.error as exc:
                raise self._error(f"{pattern!r} is not a regular expression: {exc}") from None

    def _operand(self) -> _Operand:
        if self._position >= len(self._tokens):
            raise self._error("a field or a value is missing at the end")
        kind, text = self._tokens[self._position]
        self._position += 1
        if kind == "word":
            return self._field(text)
        if kind == "parameter":
            return self._parameter(int(text))
        return self._literal(kind, text)

    def _literal(self, kind: str, text: str) -> _Operand:
        value: Any
        if kind == "text":
            value = text[1:-1]
            return _Operand(lambda _: value, "string")
        if kind == "number":
            value = int(text, 0) if _INTEGER.match(text) else float(text)
        elif text in {"TRUE", "FALSE"}:
            value = text == "TRUE"
            return _Operand(lambda _: value, "bool")
        else:
            raise self._error(f"a field or a value is needed in place of {text!r}")
        return _Operand(lambda _: value, "number")

    def _parameter(self, number: int) -> _Operand:
        if number >= len(self._parameters):
            raise self._error(f"there is no parameter for %{number}")
        tokens = self._scan(self._parameters[number])
        if len(tokens) != 1 or tokens[0][0] in {"word", "parameter"}:
            raise self._error(
                f"the parameter {self._parameters[number]!r} is not a value: put strings in quotes"
            )
        return self._literal(*tokens[0])

    def _field(self, text: str) -> _Operand:
        try:
            path = FieldPath(text)
            path.check(type(self._message))
        except FieldPathError as exc:
            raise self._error(str(exc) + (f"; {exc.hint}" if exc.hint else "")) from None
        if "[" not in text:
            value = path.select(self._message)
            return _Operand(operator.attrgetter(text), self._kind(text, value), field=True)
        try:
            kind: str | None = self._kind(text, path.select(self._message))
        except FieldPathError:
            kind = None  # the list is empty in a new message
        return _Operand(path.select, kind, field=True)

    def _kind(self, text: str, value: Any) -> str:
        if isinstance(value, str):
            return "string"
        if isinstance(value, bool):
            return "bool"
        if isinstance(value, (int, float)):
            return "number"
        raise self._error(f"{text} is not a number, string or bool")


def _combined(word: str, left: Condition, right: Condition) -> Condition:
    if word == "AND":
        return lambda message: left(message) and right(message)
    return lambda message: left(message) or right(message)


def _comparable(left: _Operand, right: _Operand) -> bool:
    if None in {left.kind, right.kind} or left.kind == right.kind:
        return True
    return left.field and left.kind == "bool" and right.kind == "number"


def _regex(pattern: str) -> str:
    wild = {"%": ".*", "*": ".*", "_": ".", "?": "."}
    return "".join(wild.get(character) or re.escape(character) for character in pattern)
