"""Generator of the modules in `packages/`, such as `rclpy.node`, from the table of ROS 2's names.

    python -m zbot.compat.generator FOLDER

This command writes all modules of the table into a folder, and removes all others that it wrote
before. zbot contains these modules in `zbot/compat/packages`. They are files, so that everything
that reads files finds the names: Python and its tools, editors and type checkers.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.compat.table import Module, modules

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

_HEADER = "# Written by python -m zbot.compat.generator; do not edit."
_WIDTH = 100


def write_packages(folder: Path) -> None:
    """Write all modules of the table, and remove those that are no longer in it."""
    texts = package_files()
    for file in folder.rglob("*.py"):
        is_ours = file.read_text(encoding="utf-8").startswith(_HEADER)
        if is_ours and file.relative_to(folder).as_posix() not in texts:
            file.unlink()
    for name, text in texts.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8", newline="\n")


def package_files() -> dict[str, str]:
    """Return the text of each file by its path in the folder."""
    table = modules()
    parents = {name.rpartition(".")[0] for name in table}
    files = {}
    for name, module in table.items():
        is_package = name in parents or "." not in name
        path = name.replace(".", "/") + ("/__init__.py" if is_package else ".py")
        files[path] = "\n".join(_lines(name, module, table)).rstrip() + "\n"
    return files


def _lines(name: str, module: Module, table: Iterable[str]) -> Iterator[str]:
    yield from (_HEADER, f'"""{module.doc}"""', "")
    if module.same:
        yield from _same(module.same)
        return
    inner = [
        full_name.rpartition(".")[2] for full_name in table if full_name.rpartition(".")[0] == name
    ]
    own = [part for part in inner if part in module.names]
    lazy = [part for part in inner if part not in own and not part.startswith("_")]
    if lazy or module.later:
        yield from ("from typing import TYPE_CHECKING", "")
        yield "from zbot.lazy_imports import lazy_names"
    yield from _imports(name, module, own)
    public = [
        f'"{public_name}"'
        for public_name in sorted(module.names)
        if not public_name.startswith("_")
    ]
    if public:
        yield from ("", *_bracketed("__all__ = [", public, "]"))
    if lazy or module.later:
        yield from ("", *_first_use(lazy, module.later))


def _same(place: str) -> Iterator[str]:
    package, _, last = place.rpartition(".")
    yield from ("from typing import TYPE_CHECKING", "")
    yield "from zbot.compat.same_module import stand_for"
    yield from (f"from {package} import {last}", "")
    yield from ("if TYPE_CHECKING:", f"    from {place} import *", "")
    yield f"stand_for(__name__, {last})"


def _imports(name: str, module: Module, own: list[str]) -> Iterator[str]:
    top = name.partition(".")[0]
    for place, names in module.places.items():
        # Type checkers find no `rclpy`: they know this folder as a part of zbot.
        where = "." * name.count(".") if place == top else place
        yield from _import(where, {here: names[here] for here in names if here not in own})
    # `rosidl_runtime_py.get_interfaces` is a function and a module: the function must win. Python
    # replaces a package's attribute when it loads a module, so the module is loaded first.
    for module_name in own:
        yield from _import(f".{module_name}", {module_name: module_name})


def _import(place: str, names: Mapping[str, str]) -> list[str]:
    if not names:
        return []
    shown = [there if here == there else f"{there} as {here}" for here, there in names.items()]
    line = f"from {place} import {', '.join(shown)}"
    return [line] if len(line) <= _WIDTH else _bracketed(f"from {place} import (", shown, ")")


def _bracketed(first: str, items: Iterable[str], last: str) -> list[str]:
    return [first, *(f"    {item}," for item in items), last]


def _first_use(lazy: list[str], later: Mapping[str, Mapping[str, str]]) -> Iterator[str]:
    yield "if TYPE_CHECKING:"
    places = {name: place for place, names in later.items() for name in names}
    for name, place in {**dict.fromkeys(lazy, "."), **places}.items():
        yield f"    from {place} import {name} as {name}"
    yield from ("else:", "    __getattr__ = lazy_names(", "        __name__,", "        {")
    yield from (f'            "{place}": "{" ".join(names)}",' for place, names in later.items())
    yield from ("        },", "        submodules=(")
    yield from (f'            "{submodule}",' for submodule in lazy)
    yield from ("        ),", "    )[0]")


def main(arguments: list[str]) -> int:
    """Run the command line, and return its exit code."""
    if len(arguments) != 1 or arguments[0].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    write_packages(Path(arguments[0]))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
