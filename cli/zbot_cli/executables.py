"""What `zbot run` can run: bundled nodes, packages of the machine or workspace, and files."""

from __future__ import annotations

import ast
import configparser
import importlib.metadata
import os
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

#: Entry point group of nodes: the bundled ones are in it, and a student's package may add its own.
GROUP = "zbot.nodes"
BUNDLED = "zbot_nodes"
#: ROS 2's packages for the nodes that zbot bundles.
_ROS_NAMES = {
    "demo_nodes_py": {"talker", "listener"},
    "demo_nodes_cpp": {"talker", "listener"},
}
_MOST_FOLDERS = 2000
_SKIPPED = {"build", "install", "log", "node_modules", "__pycache__", "site-packages"}


@dataclass(frozen=True, order=True)
class Executable:
    """Something that can be run."""

    package: str
    name: str
    target: str  #: `module:function`, or the path of a file
    folder: str = ""  #: has to be on Python's path for the module to be found


def all_executables() -> list[Executable]:
    """Return everything that can be run by name, workspace first."""
    found: dict[tuple[str, str, str], Executable] = {}
    for executable in (*_in_workspace(), *_installed()):
        found.setdefault((executable.package, executable.name, executable.target), executable)
    return list(found.values())


def _installed() -> Iterator[Executable]:
    for point in importlib.metadata.entry_points(group=GROUP):
        distribution = point.dist.name if point.dist is not None else BUNDLED
        package = BUNDLED if distribution == "zbot" else distribution.replace("-", "_")
        yield Executable(package, point.name, point.value)
        for alias, names in _ROS_NAMES.items():
            if package == BUNDLED and point.name in names:
                yield Executable(alias, point.name, point.value)


def console_scripts(package: str) -> list[Executable]:
    """Return the commands that an installed distribution brings."""
    try:
        distribution = importlib.metadata.distribution(package)
    except importlib.metadata.PackageNotFoundError:
        return []
    return [
        Executable(package, point.name, point.value)
        for point in distribution.entry_points
        if point.group == "console_scripts"
    ]


def workspaces() -> list[Path]:
    """Return the folders to search: `$ZBOT_WORKSPACE`, else the workspace around this folder."""
    given = os.environ.get("ZBOT_WORKSPACE")
    if given:
        return [Path(part).expanduser() for part in given.split(os.pathsep) if part]
    try:
        here = Path.cwd()
    except OSError:  # the folder was deleted under us
        return []
    stop = {Path.home(), Path(here.anchor)}
    for folder in (here, *here.parents):
        if folder in stop:
            break
        if (folder / "src").is_dir() or (folder / "package.xml").is_file():
            # A package inside a src/ belongs to the workspace around that.
            around = folder.parent.parent if folder.parent.name == "src" else folder
            return [around]
    return []


def _in_workspace() -> Iterator[Executable]:
    for root in workspaces():
        for folder in _packages_below(root):
            yield from _of_package(folder)


def _packages_below(root: Path) -> Iterator[Path]:
    pending, seen = [root], 0
    while pending and seen < _MOST_FOLDERS:
        folder = pending.pop(0)
        seen += 1
        if (folder / "package.xml").is_file():
            yield folder
            continue
        pending.extend(_subfolders(folder))


def _subfolders(folder: Path) -> list[Path]:
    try:
        entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
    except OSError:
        return []
    return [
        Path(entry.path)
        for entry in entries
        if entry.is_dir(follow_symlinks=False)
        and not entry.name.startswith(".")
        and entry.name not in _SKIPPED
        and not (Path(entry.path) / "pyvenv.cfg").is_file()
    ]


def _of_package(folder: Path) -> Iterator[Executable]:
    package = folder.name
    for line in (
        *_setup_py_scripts(folder / "setup.py"),
        *_setup_cfg_scripts(folder / "setup.cfg"),
    ):
        name, equals, target = (part.strip() for part in line.partition("="))
        if equals:
            yield Executable(package, name, target, str(folder))
    scripts = folder / "scripts"
    if scripts.is_dir():
        for path in sorted(scripts.glob("*.py")):
            yield Executable(package, path.name, str(path), str(folder))


def _setup_py_scripts(path: Path) -> list[str]:
    """Return the console scripts of a setup.py, read without running it."""
    try:
        tree = ast.parse(path.read_text(encoding="utf-8"))
    except (OSError, SyntaxError, ValueError):
        return []
    constants = _constants(tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "setup":
            for keyword in node.keywords:
                if keyword.arg == "entry_points":
                    return _scripts_of(keyword.value, constants)
    return []


def _constants(tree: ast.Module) -> dict[str, str]:
    return {
        target.id: statement.value.value
        for statement in tree.body
        if isinstance(statement, ast.Assign)
        and isinstance(statement.value, ast.Constant)
        and isinstance(statement.value.value, str)
        for target in statement.targets
        if isinstance(target, ast.Name)
    }


def _scripts_of(value: ast.expr, constants: dict[str, str]) -> list[str]:
    if not isinstance(value, ast.Dict):
        return []
    for key, entries in zip(value.keys, value.values, strict=True):
        if isinstance(key, ast.Constant) and key.value == "console_scripts":
            items = entries.elts if isinstance(entries, (ast.List, ast.Tuple)) else []
            return [text for item in items if (text := _text(item, constants)) is not None]
    return []


def _text(item: ast.expr, constants: dict[str, str]) -> str | None:
    if isinstance(item, ast.Constant) and isinstance(item.value, str):
        return item.value
    if isinstance(item, ast.JoinedStr):
        parts = [_text(part, constants) for part in item.values]
        return None if None in parts else "".join(part for part in parts if part is not None)
    if isinstance(item, ast.FormattedValue):
        return _text(item.value, constants)
    if isinstance(item, ast.Name):
        return constants.get(item.id)
    if isinstance(item, ast.BinOp) and isinstance(item.op, ast.Add):
        left, right = _text(item.left, constants), _text(item.right, constants)
        return None if left is None or right is None else left + right
    return None


def _setup_cfg_scripts(path: Path) -> Iterable[str]:
    parser = configparser.ConfigParser()
    try:
        parser.read(path, encoding="utf-8")
    except (configparser.Error, UnicodeDecodeError):
        return []
    section = "options.entry_points"
    if not parser.has_option(section, "console_scripts"):
        return []
    return [line for line in parser.get(section, "console_scripts").splitlines() if line.strip()]


def is_path(word: str) -> bool:
    """Return whether a word names a Python file rather than a package or executable."""
    return word.endswith(".py") or os.sep in word or (sys.platform == "win32" and "/" in word)
