"""Evaluator of the expressions in a setup.py. It does not run the file.

It evaluates constants, f-strings, lists, tuples, dictionaries, list comprehensions, `+`, `%`, and
names that were assigned earlier in the file. It also evaluates the few functions that setup files
use to find files and to make paths. Other values are unknown (None), and the callers ignore them.
The number of steps and the size of values have limits, because a short file can describe a value
that fills the memory.
"""

from __future__ import annotations

import ast
import os
import re
from typing import TYPE_CHECKING, Any

from zbot.package.file_search import FileSearch, SearchLimitError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from pathlib import Path


# A setup.py of ROS 2 needs some hundred steps.
_MAX_STEPS = 500_000
_STEP_CHARACTERS = 100  #: characters of a text that count as one step
_MAX_SIZE = 1_000_000  #: characters and elements of one value
_MAX_RESULT = 10_000_000  #: estimated characters of a call's result
_MOST_FOR_EACH = 10  #: largest number of characters that `repr` writes for one character
# Widths such as `%9999d`, which make a text longer than its parts.
_WIDTH = re.compile(r"\d{4}|%[^%a-zA-Z]*\*|:[^{}]*\{")


class LiteralLimitError(Exception):
    """The expressions of a file need too many steps or too much memory."""

    def __init__(self, reason: str = "its expressions are too large to evaluate") -> None:
        super().__init__(reason)


class Literals:
    """Values of the names in a setup.py. The statements are read in order."""

    def __init__(self, tree: ast.Module, folder: Path) -> None:
        self._folder = folder
        self._search = FileSearch(folder)
        self._steps = 0
        self._names: dict[str, Any] = {"__file__": str(folder / "setup.py")}
        for statement in tree.body:
            self._read(statement)

    def value(self, node: ast.AST) -> Any:
        """Return the value of an expression, or None if the value is unknown.

        Raises:
            LiteralLimitError: The expressions of the file are too large.
        """
        self._count_step()
        found = self._value(node)
        if isinstance(found, (str, bytes, list, tuple, dict)):
            self._check_size(found)
        return found

    def _count_step(self) -> None:
        self._steps += 1
        if self._steps > _MAX_STEPS:
            raise LiteralLimitError

    def _check_size(self, value: Any) -> int:
        """Return a value's number of characters and elements. Raise an error above the limit."""
        size, waiting = 0, [value]
        while waiting:
            self._count_step()
            item = waiting.pop()
            if isinstance(item, (str, bytes)):
                size += len(item)
                # A file can copy or search the same long text thousands of times.
                self._steps += len(item) // _STEP_CHARACTERS
            elif isinstance(item, (list, tuple)):
                size += len(item)
                waiting += item
            elif isinstance(item, dict):
                size += len(item)
                waiting += [*item, *item.values()]
            if size > _MAX_SIZE:
                raise LiteralLimitError
        return size

    def _value(self, node: ast.AST) -> Any:
        match node:
            case ast.Constant(value=value):
                return value
            case ast.Name(id=name):
                return self._names.get(name)
            case ast.List(elts=items):
                return self._items(items)
            case ast.Tuple(elts=items):
                return tuple(self._items(items))
            case ast.Dict(keys=keys, values=values):
                pairs = zip(keys, values, strict=True)
                return self._dictionary((key, value) for key, value in pairs if key)
            case ast.BinOp(left=left, op=operator, right=right):
                return self._combined(operator, self.value(left), self.value(right))
            case ast.ListComp(elt=item, generators=[ast.comprehension(ast.Name(id=name), many)]):
                return self._each(item, name, self.value(many))
            case ast.JoinedStr(values=parts):
                return self._joined(parts)
            case ast.Call():
                return self._call(node)
        return None

    def _items(self, nodes: list[ast.expr]) -> list[Any]:
        found: list[Any] = []
        for node in nodes:
            if isinstance(node, ast.Starred):
                more = self.value(node.value)
                found += more if isinstance(more, (list, tuple)) else ()
            else:
                found.append(self.value(node))
        return found

    def _dictionary(self, pairs: Iterable[tuple[ast.expr, ast.expr]]) -> dict[Any, Any]:
        found = {}
        for key, value in pairs:
            name = self.value(key)
            if isinstance(name, (str, int, float, bytes, tuple)) and _is_hashable(name):
                found[name] = self.value(value)
        return found

    def _joined(self, parts: list[ast.expr]) -> str | None:
        inner = [part.value if isinstance(part, ast.FormattedValue) else part for part in parts]
        texts = [self.value(part) for part in inner]
        return "".join(texts) if all(isinstance(text, str) for text in texts) else None

    def _read(self, statement: ast.stmt) -> None:
        match statement:
            case ast.Assign(targets=targets, value=value):
                found = self.value(value)
                self._names.update(
                    {target.id: found for target in targets if isinstance(target, ast.Name)}
                )
            case ast.AugAssign(target=ast.Name(id=name), op=operator, value=value):
                found = self._combined(operator, self._names.get(name), self.value(value))
                self._check_size(found)
                self._names[name] = found
            case ast.Expr(ast.Call(ast.Attribute(ast.Name(id=name), method), [value])):
                self._extend(name, method, self.value(value))

    def _extend(self, name: str, method: str, value: Any) -> None:
        known = self._names.get(name)
        if isinstance(known, list) and method in {"append", "extend"}:
            items = value if isinstance(value, (list, tuple)) else ()
            more = [value] if method == "append" else items
            self._names[name] = [*known, *more]
            self._check_size(self._names[name])

    def _each(self, item: ast.expr, name: str, values: Any) -> list[Any] | None:
        if not isinstance(values, (list, tuple)):
            return None
        found = []
        for value in values:
            self._names[name] = value
            found.append(self.value(item))
        return found

    def _call(self, node: ast.Call) -> Any:
        arguments = [self.value(argument) for argument in node.args]
        if any(argument is None for argument in arguments):
            return None
        if isinstance(node.func, ast.Attribute):
            name, owner = node.func.attr, self.value(node.func.value)
        else:
            name, owner = getattr(node.func, "id", ""), None
        if name in {"glob", "iglob"}:
            deep = any(keyword.arg == "recursive" for keyword in node.keywords)
            return self._files(arguments, deep=deep)
        if isinstance(owner, str):
            return self._result(_METHODS.get(name), [owner, *arguments])
        return self._result(_FUNCTIONS.get(name), arguments)

    def _files(self, arguments: list[Any], *, deep: bool) -> list[str] | None:
        if not arguments or not isinstance(arguments[0], str):
            return None
        pattern = os.path.relpath(os.path.join(self._folder, arguments[0]), self._folder)  # noqa: PTH118
        if deep and pattern.startswith(".."):  # folders outside the package may be very large
            return None
        try:
            return self._search.matching(arguments[0], recursive=deep)
        except SearchLimitError as error:
            raise LiteralLimitError(str(error)) from None

    def _result(self, function: Callable[..., Any] | None, arguments: list[Any]) -> Any:
        if function is None:
            return None
        self._check_result(function, arguments)
        try:
            return function(*arguments)
        except (TypeError, ValueError, LookupError, AttributeError, ArithmeticError):
            return None  # the setup.py itself would raise here too

    def _check_result(self, function: Callable[..., Any], arguments: list[Any]) -> None:
        """Check the largest possible size of a result, before it is computed."""
        sizes = [self._check_size(argument) for argument in arguments]
        if function in {str.__mod__, str.format}:
            places = arguments[0].count("%") + arguments[0].count("{")
            largest = places * _MOST_FOR_EACH * (1 + max(sizes))
            if _WIDTH.search(arguments[0]):
                raise LiteralLimitError
        elif function is str.replace:
            largest = (1 + sizes[0]) * (1 + sizes[-1])
        elif function is str.join:
            largest = (1 + sizes[0]) * (1 + sum(sizes[1:]))
        else:
            largest = 0
        if largest > _MAX_RESULT:
            raise LiteralLimitError

    def _combined(self, operator: ast.operator, first: Any, second: Any) -> Any:
        if isinstance(operator, ast.Add):
            if isinstance(first, list) and second is None:
                return first
            same = type(first) is type(second) and isinstance(first, (str, list, tuple))
            return first + second if same else None
        if isinstance(operator, ast.Mod) and isinstance(first, str) and second is not None:
            return self._result(str.__mod__, [first, second])
        return None


def _is_hashable(value: object) -> bool:
    try:
        hash(value)
    except TypeError:
        return False
    return True


_FUNCTIONS: dict[str, Callable[..., Any]] = {
    "join": os.path.join,
    "dirname": os.path.dirname,
    "basename": os.path.basename,
    "abspath": str,
    "realpath": str,
    "normpath": os.path.normpath,
    "str": str,
    "list": list,
    "sorted": sorted,
    "tuple": tuple,
}
_METHODS: dict[str, Callable[..., Any]] = {
    "format": str.format,
    "join": str.join,
    "replace": str.replace,
    "strip": str.strip,
}
