"""Content filters: a subscription takes only the messages of which an expression is true.

The expressions are those of DDS (annex B of its specification): `data > 3 AND data < %0`,
`pose.position.x BETWEEN 0 AND 1`, `name LIKE 'arm%'`, `NOT is_late = TRUE`. In a pattern `%` and
`*` stand for any text, `_` and `?` for one character; `MATCH` takes a regular expression. `NOT`
binds tightest; `AND` and `OR` go from left to right, so write brackets where both occur.
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

    #: Whether a message is what the expression asks for.
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
    """A content filter cannot be applied to its type of messages."""

    def __init__(self, expression: str, reason: str) -> None:
        self.expression, self.reason = expression, reason
        super().__init__(f"cannot filter by {expression!r}: {reason}")


@dataclass(frozen=True)
class _Operand:
    """A side of a comparison; `kind` is `None` where only a message can tell it."""

    read: Callable[[Any], Any]
    kind: str | None
    field: bool = False


class ContentFilter:
    """A compiled expression.

    Args:
        expression: See above.
        parameters: What `%0`, `%1` ... stand for, written as in an expression.
        message_type: Whose fields it names.

    Raises:
        ContentFilterError: The expression breaks the grammar, names a field that is not there, or
            compares what cannot be compared.
    """

    def __init__(self, expression: str, parameters: Sequence[str], message_type: type[Any]) -> None:
        self._condition = _Parser(expression, parameters, message_type).parse()

    def admits(self, message: Any) -> bool:
        """Return whether the expression is true of a message.

        A comparison with an element that a shorter list does not have is false.
        """
        return self._condition(message)


class _Parser:
    def __init__(self, expression: str, parameters: Sequence[str], message_type: type[Any]) -> None:
        self._expression = expression
        self._parameters = parameters
        self._message = message_type()
        self._tokens = list(self._scan(self._expression))
        self._at = 0

    def parse(self) -> Condition:
        condition = self._chain()
        if self._at < len(self._tokens):
            raise self._error(f"{self._tokens[self._at][1]!r} is too much")
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

    def _skip(self, *signs: str) -> str:
        """Return the sign that comes next if it is one of these, and go on behind it."""
        if self._at < len(self._tokens):
            kind, text = self._tokens[self._at]
            if kind == "sign" and text in signs:
                self._at += 1
                return text
        return ""

    def _expect(self, sign: str) -> None:
        if not self._skip(sign):
            raise self._error(f"{sign!r} is missing")

    # -- conditions ----------------------------------------------------------------------------

    def _chain(self) -> Condition:
        # DDS gives AND and OR no order of precedence, and Fast DDS goes from left to right.
        condition = self._single()
        while word := self._skip("AND", "OR"):
            condition = _joined(word, condition, self._single())
        return condition

    def _single(self) -> Condition:
        if self._skip("NOT"):
            inner = self._single()
            return lambda message: not inner(message)
        if self._skip("("):
            inner = self._chain()
            self._expect(")")
            return inner
        return self._predicate()

    def _predicate(self) -> Condition:
        left = self._operand()
        negated = bool(self._skip("NOT"))
        if self._skip("BETWEEN"):
            return self._range(left, negated=negated)
        sign = "" if negated else self._skip(*_COMPARISONS)
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
                return False  # a list that is too short

        return condition

    def _check_pattern(self, left: _Operand, sign: str, right: _Operand) -> None:
        if {left.kind, right.kind} - {"text", None}:
            raise self._error(f"{sign} needs texts")
        if sign == "MATCH" and not right.field:
            pattern = right.read(None)
            try:
                re.compile(pattern)
            except re.error as exc:
                raise self._error(f"{pattern!r} is no regular expression: {exc}") from None

    # -- operands ------------------------------------------------------------------------------

    def _operand(self) -> _Operand:
        if self._at >= len(self._tokens):
            raise self._error("something is missing at its end")
        kind, text = self._tokens[self._at]
        self._at += 1
        if kind == "word":
            return self._field(text)
        if kind == "parameter":
            return self._parameter(int(text))
        return self._literal(kind, text)

    def _literal(self, kind: str, text: str) -> _Operand:
        value: Any
        if kind == "text":
            value = text[1:-1]
            return _Operand(lambda _: value, "text")
        if kind == "number":
            value = int(text, 0) if _INTEGER.match(text) else float(text)
        elif text in {"TRUE", "FALSE"}:
            value = text == "TRUE"
            return _Operand(lambda _: value, "truth value")
        else:
            raise self._error(f"{text!r} stands where a field or a value belongs")
        return _Operand(lambda _: value, "number")

    def _parameter(self, number: int) -> _Operand:
        if number >= len(self._parameters):
            raise self._error(f"there is no parameter for %{number}")
        tokens = self._scan(self._parameters[number])
        if len(tokens) != 1 or tokens[0][0] in {"word", "parameter"}:
            raise self._error(
                f"the parameter {self._parameters[number]!r} is no value: write texts in quotes"
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
            kind = None  # an element of a list that is empty in a new message
        return _Operand(path.select, kind, field=True)

    def _kind(self, text: str, value: Any) -> str:
        if isinstance(value, str):
            return "text"
        if isinstance(value, bool):
            return "truth value"
        if isinstance(value, (int, float)):
            return "number"
        raise self._error(f"{text} is no number, text or truth value")


def _joined(word: str, left: Condition, right: Condition) -> Condition:
    if word == "AND":
        return lambda message: left(message) and right(message)
    return lambda message: left(message) or right(message)


def _comparable(left: _Operand, right: _Operand) -> bool:
    if None in {left.kind, right.kind} or left.kind == right.kind:
        return True
    return left.field and left.kind == "truth value" and right.kind == "number"


def _regex(pattern: str) -> str:
    wild = {"%": ".*", "*": ".*", "_": ".", "?": "."}
    return "".join(wild.get(character) or re.escape(character) for character in pattern)
