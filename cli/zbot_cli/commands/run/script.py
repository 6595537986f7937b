"""Execution of a Python file. If the file only defines a node class, the node is started."""

from __future__ import annotations

import io
import sys
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot_cli.commands.run.name_clash import warn_of_unused_files

if TYPE_CHECKING:
    import ast
    from collections.abc import Callable


class NothingToRunError(ZbotError):
    """A file with only definitions has no `main()`, and does not have exactly one node class."""

    def __init__(
        self,
        path: str,
        reason: str = "no main(), and not exactly one node class",
        hint: str = "write a main() function, and call it at the end of the file",
    ) -> None:
        self.path, self.hint = path, hint
        super().__init__(f"{path} has nothing to run: {reason}")


def run_script(path: str) -> Any:
    """Run a file as `__main__`.

    A file with only definitions, as in many lesson sheets, would end immediately. So its `main()`
    is called. If it has no `main()`, a node of its only node class is created and spun.

    Raises:
        NothingToRunError: The file has no `main()`, and does not have exactly one node class.
    """
    with io.open_code(str(Path(path).resolve())) as file:
        source = file.read()
    warn_of_unused_files(source, str(Path(path).resolve().parent))
    code = compile(source, path, "exec")
    module = ModuleType("__main__")
    module.__file__ = path
    sys.modules["__main__"] = module
    exec(code, module.__dict__)  # noqa: S102 - running the user's file is the whole point
    if hint := _wrong_main_part(source):
        raise NothingToRunError(path, "its main part starts nothing", hint)
    if not _only_defines(source):
        return None
    return _start_of(module, path)()


def _wrong_main_part(source: bytes) -> str:
    """Return what to write if the last part of a file does not start the program, or `""`."""
    import ast  # noqa: PLC0415 - as in `_only_defines`

    right = "if __name__ == '__main__':"
    statements = ast.parse(source).body
    functions = {one.name for one in statements if isinstance(one, ast.FunctionDef)}
    for statement in statements:
        match statement:
            case ast.If(
                test=ast.Compare(left=ast.Name(id="__name__"), comparators=[ast.Constant(value)])
            ) if value != "__main__":
                return f"write `{right}`, not {value!r}"
            case ast.If(test=ast.Compare(left=ast.Constant("__name__"))):
                return f"write `{right}`, with __name__ not in quotes"
            case ast.If(body=[ast.Expr(ast.Name(name))]) | ast.Expr(ast.Name(name)) if (
                name in functions
            ):
                return f"write {name}(), with brackets"
    return ""


def _only_defines(source: bytes) -> bool:
    import ast  # noqa: PLC0415 - takes 8 ms, so not imported before the file runs

    return all(_is_definition(statement) for statement in ast.parse(source).body)


def _is_definition(statement: ast.stmt) -> bool:
    import ast  # noqa: PLC0415 - as in `_only_defines`

    if isinstance(statement, (ast.Assign, ast.AnnAssign, ast.Expr)):
        return not any(isinstance(node, ast.Call) for node in ast.walk(statement))
    definitions = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Import, ast.ImportFrom)
    return isinstance(statement, definitions)


def _start_of(module: ModuleType, path: str) -> Callable[[], Any]:
    main: Any = getattr(module, "main", None)
    if callable(main):
        return partial(main)
    if hasattr(module, "generate_launch_description"):
        raise NothingToRunError(path, "it is a launch file", f"type: zbot launch {path}")
    import zbot  # noqa: PLC0415 - not needed by a file with `main()`

    classes: list[Any] = [
        value
        for value in vars(module).values()
        if isinstance(value, type)
        and issubclass(value, zbot.Node)
        and value.__module__ == "__main__"
    ]
    if len(classes) != 1:
        raise NothingToRunError(path)
    return partial(_spin, classes[0])


def _spin(node_class: Any) -> None:
    import zbot  # noqa: PLC0415 - not needed by a file with `main()`

    with zbot.init():
        zbot.spin(node_class())
