"""Check that the modules and functions of the entry points in setup files exist."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.errors.suggestion import did_you_mean
from zbot.package.errors import SetupFileError
from zbot.package.python_finder import import_paths
from zbot.package.setup_file import script_lines
from zbot_cli.packages.check.checked_package import Problem, line_of
from zbot_cli.packages.executables import module_file

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from zbot_cli.packages.check.checked_package import CheckedPackage


#: The first of two entry points that were joined to one string, without the end of its function.
_JOINED = re.compile(r"\s*[\w.-]+\s*=\s*[\w.]+:(?=\w+\s*=)")


def check_entry_points(checked: CheckedPackage) -> Iterator[Problem]:
    """Yield the problems of a package's entry points, without importing anything."""
    try:
        declared = script_lines(checked.folder)
    except SetupFileError as error:
        yield Problem(error.path, error.line, error.reason)
        return
    for path, text in declared:
        reason = _problem_text(checked, text)
        if reason:
            line = line_of(path, *text.split("=")) or line_of(path, *re.split("[=:]", text)[:2])
            yield Problem(path, line, reason)
    names = [text.partition("=")[0].strip() for _, text in declared]
    for index, (path, text) in enumerate(declared):
        if names[index] in names[:index]:
            reason = f"'{names[index]}' is declared twice: only one of the programs can be started"
            yield Problem(path, line_of(path, *text.split("=")), reason)


def _problem_text(checked: CheckedPackage, text: str) -> str:
    name, equals, target = (part.strip() for part in text.partition("="))
    module, colon, function = (part.strip() for part in target.partition("[")[0].partition(":"))
    if not (name and equals and module and colon and function):
        return f"'{text.strip()}' must have the form 'name = package.module:function'"
    if joined := _JOINED.match(text):
        return f"a comma is missing after '{joined[0].strip()}...': Python joins the two strings"
    path = module_file(module, tuple(import_paths(checked.folder)))
    if path is None:
        return f"'{name}' names the module {module}, which does not exist{_hint(checked, module)}"
    if path not in checked.modules:
        return ""  # a module of another package, or a syntax error that is reported elsewhere
    names = set(_names(checked.modules[path].body))
    if function.endswith("()"):
        return f"'{name}' names {function}: write {function[:-2]}, without brackets"
    first = function.partition(".")[0]
    if "*" in names or first in names:
        return ""
    hint = did_you_mean(first, names, before="; ")
    return f"'{name}' names {first}(), but {path.name} has no {first}(){hint}"


def _hint(checked: CheckedPackage, module: str) -> str:
    folders = import_paths(checked.folder)
    known = [
        ".".join(path.relative_to(folder).with_suffix("").parts)
        for path in checked.modules
        for folder in map(Path, folders)
        if path.is_relative_to(folder)
    ]
    return did_you_mean(module, known, before="; ")


def _names(statements: Iterable[ast.stmt]) -> Iterator[str]:
    """Yield the names that a module may define when it is imported, from all branches of `if`."""
    for statement in statements:
        match statement:
            case (
                ast.FunctionDef(name=name)
                | ast.AsyncFunctionDef(name=name)
                | ast.ClassDef(name=name)
            ):
                yield name
            case ast.Import(names=aliases) | ast.ImportFrom(names=aliases):
                yield from ((alias.asname or alias.name).partition(".")[0] for alias in aliases)
            case ast.Assign(targets=targets):
                for target in targets:
                    yield from (node.id for node in ast.walk(target) if isinstance(node, ast.Name))
            case ast.AnnAssign(target=ast.Name(id=name)):
                yield name
            case ast.If() | ast.Try() | ast.With() | ast.For() | ast.While():
                yield from _names(_inner(statement))


def _inner(statement: ast.stmt) -> Iterator[ast.stmt]:
    for part in ("body", "orelse", "finalbody"):
        yield from getattr(statement, part, ())
    for handler in getattr(statement, "handlers", ()):
        yield from handler.body
