"""Content filters, with which a subscription receives only messages that match an expression.

The expressions are those of DDS (annex B of its specification): `data > 3 AND data < %0`,
`pose.position.x BETWEEN 0 AND 1`, `name LIKE 'arm%'`, `NOT is_late = TRUE`. In a `LIKE` pattern,
`%` and `*` match any text. `_` and `?` match one character. `MATCH` needs a regular expression on
its right side. This expression cannot be a field, and has no back-references and assertions.
`NOT` has the highest precedence. `AND` and `OR` are evaluated from left to right, so use brackets
in an expression that has both.
"""

from __future__ import annotations

import operator
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError, shortened
from zbot.interfaces import get_message
from zbot.interfaces.field_path import FieldPath, FieldPathError, fields_of
from zbot.interfaces.spec import FieldType
from zbot.interfaces.text_pattern import PatternError, RegularExpression, like_expression

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
    "LIKE": lambda value, pattern: like_expression(pattern).fullmatch(value) is not None,
    "MATCH": lambda value, pattern: pattern.matches(value),
}
_LONGEST_NUMBER = 400
_MAX_LENGTH = 10_000  #: characters
_MAX_LEVELS = 50  #: brackets and NOTs inside each other
_WORDS = {"AND", "OR", "NOT", "BETWEEN", "LIKE", "MATCH", "TRUE", "FALSE"}


class ContentFilterError(ZbotError, ValueError):
    """A content filter's expression is not valid for its message type."""

    def __init__(self, expression: str, reason: str) -> None:
        self.expression, self.reason = expression, reason
        super().__init__(f"cannot filter by {shortened(expression, 500)}: {reason}")


@dataclass(frozen=True)
class _Operand:
    """One side of a comparison. `kind` is the type of the value."""

    read: Callable[[Any], Any]
    kind: str
    field: bool = False


class ContentFilter:
    """A compiled expression.

    Args:
        expression: The expression. The module's description shows the grammar.
        parameters: Values of `%0`, `%1` ... in the form that values have in an expression.
        message_type: Class of the messages.

    Raises:
        ContentFilterError: The expression breaks the grammar, contains an unknown field, or
            compares values of different types.
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
        if len(expression) > _MAX_LENGTH:
            raise self._error(f"it has more than {_MAX_LENGTH} characters")
        self._tokens = self._scan(expression)
        self._position = 0
        self._levels = 0

    def parse(self) -> Condition:
        condition = self._and_or()
        if self._position < len(self._tokens):
            raise self._error(f"{self._tokens[self._position][1]!r} is unexpected")
        return condition

    def _error(self, reason: str) -> ContentFilterError:
        return ContentFilterError(self._expression, reason)

    def _scan(self, text: str) -> list[tuple[str, str]]:
        tokens, place = list[tuple[str, str]](), 0
        text = text.rstrip()
        while place < len(text):
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
        first = self._negation()
        more: list[tuple[bool, Condition]] = []
        while word := self._accept("AND", "OR"):
            more.append((word == "AND", self._negation()))
        return _combined(first, more) if more else first

    def _negation(self) -> Condition:
        self._levels += 1
        if self._levels > _MAX_LEVELS:
            raise self._error(f"it is nested deeper than {_MAX_LEVELS} levels")
        condition = self._inner()
        self._levels -= 1
        return condition

    def _inner(self) -> Condition:
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
        if sign in {"LIKE", "MATCH"} and {left.kind, right.kind} - {"string"}:
            raise self._error(f"{sign} needs strings on both sides")
        if sign == "MATCH":
            right = self._regular_expression(right)
        compare, first, second = _COMPARISONS[sign], left.read, right.read

        def condition(message: Any) -> bool:
            try:
                return compare(first(message), second(message))
            except FieldPathError:
                return False  # the list is too short

        return condition

    def _regular_expression(self, pattern: _Operand) -> _Operand:
        if pattern.field:
            raise self._error("the regular expression of MATCH must be a value, not a field")
        text = pattern.read(None)
        try:
            expression = RegularExpression(text)
        except PatternError as exc:
            reason = f"{text!r} is not a regular expression that MATCH knows: {exc}"
            raise self._error(reason) from None
        return _Operand(lambda _: expression, "string")

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
            value = self._number(text)
        elif text in {"TRUE", "FALSE"}:
            value = text == "TRUE"
            return _Operand(lambda _: value, "bool")
        else:
            raise self._error(f"a field or a value is needed in place of {text!r}")
        return _Operand(lambda _: value, "number")

    def _number(self, text: str) -> float:
        if len(text) > _LONGEST_NUMBER:
            raise self._error(f"the number {shortened(text)} is too long")
        return int(text, 0) if _INTEGER.match(text) else float(text)

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
        return _Operand(path.select, self._element_kind(path), field=True)

    def _element_kind(self, path: FieldPath) -> str:
        """Return the type of the value at a path.

        The type comes from the definitions, because the lists of a message may be empty.
        """
        message_type, last = type(self._message), FieldType("")
        for name in path.names:
            fields = {field.name: field.type for field in fields_of(message_type())}
            if name not in fields:
                raise self._error(f"{path.text} is not a field")
            last = fields[name]
            message_type = get_message(last.base) if last.is_message else message_type
        is_list = path.is_list or (last.kind != "scalar" and not path.ends_with_index)
        if is_list or last.is_message or last.base == "byte":
            return self._kind(path.text, None)
        return "string" if last.is_string else "bool" if last.base == "bool" else "number"

    def _kind(self, text: str, value: Any) -> str:
        if isinstance(value, str):
            return "string"
        if isinstance(value, bool):
            return "bool"
        if isinstance(value, (int, float)):
            return "number"
        raise self._error(f"{text} is not a number, string or bool")


def _combined(first: Condition, more: list[tuple[bool, Condition]]) -> Condition:
    """Combine conditions from left to right. In `more`, True means AND, and False means OR."""

    def condition(message: Any) -> bool:
        value = first(message)
        for is_and, following in more:
            if (
                bool(value) is is_and
            ):  # otherwise the value is known without the following condition
                value = following(message)
        return value

    return condition


def _comparable(left: _Operand, right: _Operand) -> bool:
    if left.kind == right.kind:
        return True
    return left.field and left.kind == "bool" and right.kind == "number"
