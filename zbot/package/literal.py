"""Evaluator of the expressions in a setup.py. It does not run the file.

It evaluates constants, f-strings, lists, tuples, dictionaries, list comprehensions, `+`, `%`, and
names that were assigned earlier in the file. It also evaluates the few functions that setup files
use to find files and to make paths. Other values are unknown (None), and the callers ignore them.
"""

from __future__ import annotations

import ast
import glob
import os
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path


class Literals:
    """Values of the names in a setup.py. The statements are read in order."""

    def __init__(self, tree: ast.Module, folder: Path) -> None:
        self._folder = folder
        self._names: dict[str, Any] = {"__file__": str(folder / "setup.py")}
        for statement in tree.body:
            self._read(statement)

    def value(self, node: ast.AST) -> Any:
        """Return the value of an expression, or None if the value is unknown."""
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
                return {self.value(key): self.value(value) for key, value in pairs if key}
            case ast.BinOp(left=left, op=operator, right=right):
                return _combined(operator, self.value(left), self.value(right))
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
                found += self.value(node.value) or ()
            else:
                found.append(self.value(node))
        return found

    def _joined(self, parts: list[ast.expr]) -> str | None:
        inner = [part.value if isinstance(part, ast.FormattedValue) else part for part in parts]
        texts = [self.value(part) for part in inner]
        return "".join(texts) if all(isinstance(text, str) for text in texts) else None

    def _read(self, statement: ast.stmt) -> None:
        match statement:
            case ast.Assign(targets=targets, value=value):
                found = self.value(value)
                self._names.update({one.id: found for one in targets if isinstance(one, ast.Name)})
            case ast.AugAssign(target=ast.Name(id=name), op=operator, value=value):
                self._names[name] = _combined(operator, self._names.get(name), self.value(value))
            case ast.Expr(ast.Call(ast.Attribute(ast.Name(id=name), method), [value])):
                self._extend(name, method, self.value(value))

    def _extend(self, name: str, method: str, value: Any) -> None:
        known = self._names.get(name)
        if isinstance(known, list) and method in {"append", "extend"}:
            more = [value] if method == "append" else list(value or ())
            self._names[name] = [*known, *more]

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
            return _result(_METHODS.get(name), [owner, *arguments])
        return _result(_FUNCTIONS.get(name), arguments)

    def _files(self, arguments: list[Any], *, deep: bool) -> list[str] | None:
        if not arguments or not isinstance(arguments[0], str):
            return None
        pattern = os.path.relpath(os.path.join(self._folder, arguments[0]), self._folder)  # noqa: PTH118
        if deep and pattern.startswith(".."):  # folders outside the package may be very large
            return None
        # Path.glob rejects absolute patterns, but setup files make such patterns from __file__.
        return sorted(glob.glob(arguments[0], root_dir=self._folder, recursive=deep))  # noqa: PTH207


def _result(function: Callable[..., Any] | None, arguments: list[Any]) -> Any:
    if function is None:
        return None
    try:
        return function(*arguments)
    except (TypeError, ValueError, LookupError):
        return None  # the setup.py itself would raise here too


def _combined(operator: ast.operator, first: Any, second: Any) -> Any:
    if isinstance(operator, ast.Add):
        if isinstance(first, list) and second is None:
            return first
        same = type(first) is type(second) and isinstance(first, (str, list, tuple))
        return first + second if same else None
    if isinstance(operator, ast.Mod) and isinstance(first, str) and second is not None:
        return _result(str.__mod__, [first, second])
    return None


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
