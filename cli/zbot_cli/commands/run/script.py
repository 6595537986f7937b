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

    def __init__(self, path: str) -> None:
        self.path = path
        self.hint = "write a main() function, and call it at the end of the file"
        super().__init__(f"{path} has nothing to run: no main(), and not exactly one node class")


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
    if not _only_defines(source):
        return None
    return _start_of(module, path)()


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
