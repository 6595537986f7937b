"""Filter of messages by a Python expression about the message `m`, with harmless operations only.

This module compares each node of the expression's syntax tree with a list of allowed nodes, and
evaluates the tree without `eval`. So a command line copied from a lesson sheet can do no harm.
"""

from __future__ import annotations

import ast
import contextlib
import operator
import warnings
from numbers import Real
from typing import TYPE_CHECKING, Any

from zbot.errors import shortened
from zbot.interfaces.field_path import FieldPathError, follow
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Callable

_MOST_NODES = 200
_MOST_CHARACTERS = 10_000
_BINARY: dict[type[ast.AST], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
}
_UNARY: dict[type[ast.AST], Callable[[Any], Any]] = {
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
    ast.Not: operator.not_,
}
_COMPARE: dict[type[ast.AST], Callable[[Any, Any], bool]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.In: lambda item, items: item in items,
    ast.NotIn: lambda item, items: item not in items,
}


def _rounded(number: Any) -> Any:
    # `round` with -10**9 digits would never end, so the number of digits is not an argument.
    return round(number)


_FUNCTIONS: dict[str, Callable[..., Any]] = {
    "abs": abs,
    "bool": bool,
    "float": float,
    "int": int,
    "len": len,
    "max": max,
    "min": min,
    "round": _rounded,
}
# No method here can make a long string from a short string. `ljust` could.
_TEXT_METHODS = frozenset(
    (
        *("lower", "upper", "strip", "lstrip", "rstrip"),
        *("split", "rsplit", "partition", "rpartition"),
        *("startswith", "endswith", "find", "rfind", "count", "isdigit"),
    )
)
_CALLABLE = ", ".join(_FUNCTIONS) + " and methods of texts such as startswith()"


def filter_error(expression: str, reason: str) -> CommandError:
    """Return the error that a filter expression is invalid, or does not fit the message type."""
    hint = "write a comparison of fields of m, e.g. --filter 'm.linear.x > 0.5'"
    return CommandError(f"Invalid filter expression '{expression}': {reason}", hint=hint)


class Filter:
    """Filter that accepts the messages for which an expression is true.

    Args:
        expression: The expression, e.g. `m.linear.x > 0.5`.

    Raises:
        CommandError: `expression` is invalid, or contains an operation that is not allowed.
    """

    def __init__(self, expression: str) -> None:
        self._expression = expression
        if len(expression) > _MOST_CHARACTERS:
            raise filter_error(shortened(expression), "it is too long")
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # the error below is enough
                tree = ast.parse(expression.strip(), mode="eval")
        except (SyntaxError, ValueError, RecursionError, MemoryError) as exc:
            reason = getattr(exc, "msg", None) or "it is too long"
            raise filter_error(expression, reason) from None
        _check(expression, tree)
        self._body = tree.body

    def accepts(self, message: Any) -> bool:
        """Return whether the expression is true for a message or for one field of it.

        Raises:
            CommandError: The expression does not fit the message.
        """
        try:
            return bool(_value(self._body, message))
        except (AttributeError, TypeError, LookupError, ArithmeticError, ValueError) as exc:
            raise filter_error(self._expression, str(exc)) from None

    def check(self, message_type: type[Any], subject: Callable[[Any], Any]) -> None:
        """Check that the expression fits a message type, before the first message arrives.

        Args:
            message_type: Message class.
            subject: Function that finds `m` in a message. `m` is the message or one of its fields.

        Raises:
            CommandError: A field does not exist, or two values have types that cannot be compared.
        """
        with contextlib.suppress(FieldPathError, LookupError, ArithmeticError, ValueError):
            try:
                _value(self._body, subject(message_type()))
            except (AttributeError, TypeError) as exc:
                raise filter_error(self._expression, str(exc)) from None


def _check(expression: str, tree: ast.Expression) -> None:
    nodes = list(ast.walk(tree))
    if len(nodes) > _MOST_NODES:
        raise filter_error(expression, "it is too long")
    for node in nodes:
        problem = _problem(node)
        if problem is not None:
            raise filter_error(expression, problem)


def _problem(node: ast.AST) -> str | None:
    if isinstance(node, ast.Attribute):
        return f"{node.attr} is private" if node.attr.startswith("_") else None
    if isinstance(node, ast.Name):
        return (
            None if node.id in {"m", *_FUNCTIONS} else f"{node.id} is not known; the message is m"
        )
    if isinstance(node, ast.Call):
        return None if _is_harmless(node) else f"only {_CALLABLE} can be called"
    allowed = (
        ast.Expression,
        ast.BoolOp,
        ast.And,
        ast.Or,
        ast.Compare,
        ast.BinOp,
        ast.UnaryOp,
        ast.Constant,
        ast.Subscript,
        ast.Slice,
        ast.List,
        ast.Tuple,
        ast.Load,
        *_BINARY,
        *_UNARY,
        *_COMPARE,
    )
    return None if isinstance(node, allowed) else f"{type(node).__name__} is not allowed"


def _is_harmless(call: ast.Call) -> bool:
    if call.keywords:
        return False
    if isinstance(call.func, ast.Attribute):
        return call.func.attr in _TEXT_METHODS
    return isinstance(call.func, ast.Name) and call.func.id in _FUNCTIONS


def _value(node: ast.AST, message: Any) -> Any:  # noqa: C901 - one branch for each kind of node
    match node:
        case ast.Constant(value=value):
            return value
        case ast.Name(id="m"):
            return message
        case ast.Attribute(value=owner, attr=name):
            return follow(_value(owner, message), name)
        case ast.Subscript(value=owner, slice=index):
            return _value(owner, message)[_value(index, message)]
        case ast.Slice(lower=lower, upper=upper, step=step):
            parts = (lower, upper, step)
            return slice(*(None if part is None else _value(part, message) for part in parts))
        case ast.List(elts=items) | ast.Tuple(elts=items):
            return [_value(item, message) for item in items]
        case ast.UnaryOp(op=op, operand=operand):
            return _UNARY[type(op)](_value(operand, message))
        case ast.BinOp(left=left, op=op, right=right):
            return _reckon(op, _value(left, message), _value(right, message))
        case ast.BoolOp(op=op, values=values):
            results = (_value(value, message) for value in values)
            return all(results) if isinstance(op, ast.And) else any(results)
        case ast.Call(func=ast.Name(id=name), args=arguments):
            return _FUNCTIONS[name](*(_value(argument, message) for argument in arguments))
        case ast.Call(func=ast.Attribute(value=owner, attr=name), args=arguments):
            return _ask_text(_value(owner, message), name, [_value(a, message) for a in arguments])
        case ast.Compare(left=left, ops=ops, comparators=comparators):
            return _compare(_value(left, message), ops, comparators, message)
    raise TypeError(f"{type(node).__name__} is not allowed")


def _ask_text(text: Any, method: str, arguments: list[Any]) -> Any:
    if not isinstance(text, str):
        raise TypeError(f"only texts have {method}()")
    return getattr(text, method)(*arguments)


def _reckon(op: ast.operator, left: Any, right: Any) -> Any:
    # Only numbers are allowed, because "x" * 10**9 would fill the memory of the machine.
    if not (isinstance(left, Real) and isinstance(right, Real)):
        raise TypeError("arithmetic is for numbers only")
    return _BINARY[type(op)](left, right)


def _compare(left: Any, ops: list[ast.cmpop], rights: list[ast.expr], message: Any) -> bool:
    for op, node in zip(ops, rights, strict=True):
        right = _value(node, message)
        if not _COMPARE[type(op)](left, right):
            return False
        left = right
    return True
