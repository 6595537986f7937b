"""Evaluator of conditions in a package.xml, e.g. `$ROS_VERSION == 2 and $ROS_DISTRO >= humble`."""

from __future__ import annotations

import operator
import re
from typing import TYPE_CHECKING

from zbot.package.ros_variables import ros_variable

if TYPE_CHECKING:
    from collections.abc import Callable

_TOKEN = re.compile(
    r"""\s*(?:(?P<operator>==|!=|<=|>=|<|>)|(?P<bracket>[()])|\$(?P<variable>\w+)"""
    r"""|(?P<word>[\w-]+)|"(?P<double>[^"]*)"|'(?P<single>[^']*)')"""
)
# All values are texts, as in ROS 2's own reader of these files.
_COMPARE: dict[str, Callable[[str, str], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}
_MAX_LENGTH = 1000


class ConditionError(Exception):
    """A condition is not valid. The caller adds the file and the line."""


def holds(condition: str) -> bool:
    """Return whether a condition is true with the variables of the environment.

    Raises:
        ConditionError: The condition is not valid.
    """
    if len(condition) > _MAX_LENGTH:
        raise ConditionError(f"a condition must not have more than {_MAX_LENGTH} characters")
    reader = _Reader(condition)
    try:
        result = reader.disjunction()
        reader.end()
    except RecursionError:
        raise ConditionError("the brackets of the condition are nested too deeply") from None
    return result


class _Reader:
    """Reader of the grammar `a == b and (c != d or ...)`, from left to right."""

    def __init__(self, text: str) -> None:
        self._text, self._tokens, self._next = text, list(_tokens(text)), 0

    def disjunction(self) -> bool:
        result = self._conjunction()
        while self._accept("word", "or"):
            result = self._conjunction() or result
        return result

    def end(self) -> None:
        if self._next < len(self._tokens):
            raise self._error()

    def _conjunction(self) -> bool:
        result = self._comparison()
        while self._accept("word", "and"):
            result = self._comparison() and result
        return result

    def _comparison(self) -> bool:
        if self._accept("bracket", "("):
            result = self.disjunction()
            if not self._accept("bracket", ")"):
                raise self._error()
            return result
        left = self._value()
        kind, text = self._take()
        if kind != "operator":
            raise self._error()
        return _COMPARE[text](left, self._value())

    def _value(self) -> str:
        kind, text = self._take()
        if kind in {"operator", "bracket"}:
            raise self._error()
        return ros_variable(text) if kind == "variable" else text

    def _accept(self, kind: str, text: str) -> bool:
        if self._tokens[self._next : self._next + 1] != [(kind, text)]:
            return False
        self._next += 1
        return True

    def _take(self) -> tuple[str, str]:
        if self._next >= len(self._tokens):
            raise self._error()
        self._next += 1
        return self._tokens[self._next - 1]

    def _error(self) -> ConditionError:
        return ConditionError(
            f"the condition {self._text!r} is not of the form '$VARIABLE == value'"
        )


def _tokens(text: str) -> list[tuple[str, str]]:
    found, place = [], 0
    while text[place:].strip():
        match = _TOKEN.match(text, place)
        if match is None:
            raise ConditionError(f"the condition {text!r} has a wrong character: {text[place:]!r}")
        found.append((match.lastgroup or "", match[match.lastgroup or 0]))
        place = match.end()
    return found
