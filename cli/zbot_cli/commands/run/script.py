"""Execution of a Python file. If the file only defines a node class, the node is started."""

from __future__ import annotations

import io
import re
import sys
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.process import main_part
from zbot.process.main_part import Mistake, Program

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence


class NothingToRunError(ZbotError):
    """A file with only definitions has no `main()`, and does not have exactly one node class."""

    def __init__(self, path: str, mistake: Mistake) -> None:
        self.path, self.hint = path, mistake.advice
        Program.needs_no_warning = True
        super().__init__(f"{path} has nothing to run: {mistake.reason}")


def run_script(path: str) -> Any:
    """Run a file as `__main__`.

    A file with only definitions, as in many lesson sheets, would end immediately. So its `main()`
    is called. If it has no `main()`, a node of its only node class is created and spun. A note says
    so, because the file does nothing without `zbot run`.

    Raises:
        NothingToRunError: The file has no `main()`, and does not have exactly one node class.
    """
    with io.open_code(str(Path(path).resolve())) as file:
        source = file.read()
    _warn_of_unused_files(source, str(Path(path).resolve().parent))
    code = compile(source, path, "exec")
    module = ModuleType("__main__")
    module.__file__ = path
    sys.modules["__main__"] = module
    exec(code, module.__dict__)  # noqa: S102 - running the user's file is the whole point
    if wrong := main_part.wrong_condition(source):
        raise NothingToRunError(path, wrong)
    if main_part.only_defines(source):
        start = _start_of(module, path)
        if forgotten := main_part.mistake_in(source):
            text = f"{path}: {forgotten.reason}; `zbot run` starts it, but `python` does not"
            print(f"note: {text}: {forgotten.advice}", file=sys.stderr)
        return start()
    if not Program.needs_no_warning and (unused := main_part.mistake_in(source)):
        raise NothingToRunError(path, unused)
    return None


def _start_of(module: ModuleType, path: str) -> Callable[[], Any]:
    main: Any = getattr(module, "main", None)
    if callable(main):
        return partial(main)
    if hasattr(module, "generate_launch_description"):
        raise NothingToRunError(path, Mistake("it is a launch file", f"type: zbot launch {path}"))
    import zbot  # noqa: PLC0415 - not needed by a file with `main()`

    classes: list[Any] = [
        value
        for value in vars(module).values()
        if isinstance(value, type)
        and issubclass(value, zbot.Node)
        and value.__module__ == "__main__"
    ]
    if len(classes) != 1:
        raise NothingToRunError(
            path, _no_single_class([class_.__name__ for class_ in classes], path)
        )
    return partial(_spin, classes[0])


def _no_single_class(names: list[str], path: str) -> Mistake:
    advice = "write a main() function, and call it at the end of the file"
    if names:
        listed = f"{', '.join(names[:-1])} and {names[-1]}"
        return Mistake(f"it has no main(), and several node classes: {listed}", advice)
    if not Path(path).read_bytes().strip():
        return Mistake("it is empty", "write a program into it, and save it")
    return Mistake("it has no main() and no node class", advice)


def _spin(node_class: Any) -> None:
    import zbot  # noqa: PLC0415 - not needed by a file with `main()`

    with zbot.init():
        zbot.spin(node_class())


def _warn_of_unused_files(source: bytes, folder: str) -> None:
    """Warn about files in a script's folder that the script tries to import, but cannot import.

    The script gets Python's own module of the same name, which is already imported.

    Args:
        source: The text of the script.
        folder: The folder of the script.
    """
    imported = re.findall(rb"^[ \t]*(?:import|from)[ \t]+(\w+)", source, re.MULTILINE)
    for name in sorted({module.decode() for module in imported} & sys.stdlib_module_names):
        file = _file_of(name, [folder]) if name in sys.modules else None
        if file is not None:
            reason = f"because Python uses its own module {name}"
            print(f"{file} is not imported, {reason}: rename the file", file=sys.stderr)


def _file_of(name: str, folders: Sequence[str]) -> Path | None:
    places = (
        Path(folder) / file for folder in folders for file in (f"{name}.py", f"{name}/__init__.py")
    )
    return next((place for place in places if place.is_file()), None)
