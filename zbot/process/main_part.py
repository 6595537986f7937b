"""Main part of a program's file: the statements that start the program.

Without them, the program ends immediately and prints nothing, so a beginner does not see the
mistake.
"""

from __future__ import annotations

import atexit
import contextlib
import io
import os
import sys
from typing import TYPE_CHECKING, NamedTuple

from zbot.errors import library_name

if TYPE_CHECKING:
    import ast
    from collections.abc import Iterable

# A test often defines nodes that it does not start.
_TEST_RUNNERS = ("pytest", "unittest")
#: Functions that can start what a file defines, although they do not name it.
_STARTERS = {"Fire", "eval", "exec", "globals", "locals", "main", "run", "vars"}
_RIGHT = "if __name__ == '__main__':"


class Mistake(NamedTuple):
    """Reason why a file starts nothing, and what to write."""

    reason: str
    advice: str


class Program:
    """What the program of this process has done so far."""

    #: whether it created a node, or `zbot run` reports a file that starts nothing
    needs_no_warning = False


def is_program() -> bool:
    """Return whether the process runs a file, and neither tests nor an interactive session."""
    # At the end of the process, Python has already removed `__file__`.
    is_interactive = hasattr(sys, "ps1") or bool(sys.flags.interactive)
    has_file = hasattr(sys.modules.get("__main__"), "__file__")
    return has_file and not is_interactive and not any(map(sys.modules.get, _TEST_RUNNERS))


def warn_at_exit() -> None:
    """Let the process warn at its end if it runs a file that starts nothing."""
    main = sys.modules.get("__main__")
    # A child process of multiprocessing imports the file of its parent as `__mp_main__`.
    if is_program() and getattr(main, "__name__", "") == "__main__":
        # At the end of the process, `__file__` is gone, and the current folder may be another one.
        atexit.register(_warn, os.path.abspath(str(getattr(main, "__file__", ""))))  # noqa: PTH100 - as quick as possible


def _warn(file: str) -> None:
    if Program.needs_no_warning or hasattr(sys, "last_value"):
        return
    with contextlib.suppress(OSError, SyntaxError, ValueError), io.open_code(file) as opened:
        mistake = mistake_in(opened.read())
        if mistake:
            text = f"{file}: nothing was started: {mistake.reason}: {mistake.advice}"
            print(text, file=sys.stderr)


def mistake_in(source: bytes) -> Mistake | None:
    """Return why the main part of a file starts nothing, or `None` if it may start something.

    Raises:
        SyntaxError: The source is not Python.
    """
    import ast  # noqa: PLC0415 - takes 8 ms, so not imported before the program runs

    return wrong_condition(source) or _no_start(ast.parse(source).body)


def only_defines(source: bytes) -> bool:
    """Return whether a file has only definitions, imports and constants."""
    import ast  # noqa: PLC0415 - as in `mistake_in`

    return all(_is_definition(statement) for statement in ast.parse(source).body)


def _is_definition(statement: ast.stmt) -> bool:
    import ast  # noqa: PLC0415 - as in `mistake_in`

    if isinstance(statement, (ast.Assign, ast.AnnAssign, ast.Expr)):
        return not any(isinstance(node, ast.Call) for node in ast.walk(statement))
    definitions = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Import, ast.ImportFrom)
    return isinstance(statement, definitions)


def wrong_condition(source: bytes) -> Mistake | None:
    """Return what is wrong in `if __name__ == '__main__':` and the call below it, if anything."""
    import ast  # noqa: PLC0415 - as in `mistake_in`

    statements = ast.parse(source).body
    reason = "its main part starts nothing"
    functions = {
        statement.name for statement in statements if isinstance(statement, ast.FunctionDef)
    }
    for statement in statements:
        match statement:
            case ast.If(
                test=ast.Compare(left=ast.Name(id="__name__"), comparators=[ast.Constant(value)])
            ) if value != "__main__":
                return Mistake(reason, f"write `{_RIGHT}`, not {value!r}")
            case ast.If(test=ast.Compare(left=ast.Constant("__name__"))):
                return Mistake(reason, f"write `{_RIGHT}`, with __name__ not in quotes")
            case ast.If(body=[ast.Expr(ast.Name(name))]) | ast.Expr(ast.Name(name)) if (
                name in functions
            ):
                return Mistake(reason, f"write {name}(), with brackets")
    return None


def _no_start(statements: list[ast.stmt]) -> Mistake | None:
    """Return why no statement of a file starts its node, or `None` if one may start it."""
    import ast  # noqa: PLC0415 - as in `mistake_in`

    functions = [statement for statement in statements if isinstance(statement, ast.FunctionDef)]
    classes = [statement for statement in statements if isinstance(statement, ast.ClassDef)]
    nodes = [class_.name for class_ in classes if any(map(_is_node, class_.bases))]
    own = {function.name for function in functions} | {class_.name for class_ in classes}
    if _starts_something(statements, own) or any(function.decorator_list for function in functions):
        return None
    if any(function.name == "main" for function in functions):
        return Mistake("main() is never called", "write main() at the end of the file")
    for class_ in classes:
        inside = [part.name for part in class_.body if isinstance(part, ast.FunctionDef)]
        if "main" in inside:
            reason = f"main() is inside the class {class_.name}"
            return Mistake(reason, "move it to the left, and write main() at the end of the file")
    if not nodes:
        return None
    start = f"{library_name()}.init() and {library_name()}.spin({nodes[0]}())"
    return Mistake(f"the class {nodes[0]} is never used", f"write {start} at the end of the file")


def _is_node(base: ast.expr) -> bool:
    import ast  # noqa: PLC0415 - as in `mistake_in`

    return ast.unparse(base).rpartition(".")[2] in {"Node", "LifecycleNode"}


def _starts_something(statements: Iterable[ast.stmt], own: set[str]) -> bool:
    """Return whether a statement outside of definitions uses an own name of the file, or waits."""
    import ast  # noqa: PLC0415 - as in `mistake_in`

    definitions = (ast.FunctionDef, ast.ClassDef, ast.Import, ast.ImportFrom)
    run = [statement for statement in statements if not isinstance(statement, definitions)]
    parts = [part for statement in run for part in ast.walk(statement)]
    assigned = {
        part.id for part in parts if isinstance(part, ast.Name) and isinstance(part.ctx, ast.Store)
    }
    called = {ast.unparse(part.func) for part in parts if isinstance(part, ast.Call)}
    return (
        any(isinstance(part, ast.Name) and part.id in own for part in parts)
        or any(isinstance(part, ast.AsyncFunctionDef) for part in statements)
        or any(isinstance(part, ast.While) for part in parts)
        or any(name.partition(".")[0] in assigned for name in called)
        or any(name.rpartition(".")[2] in _STARTERS for name in called)
    )
