"""Package that the checks examine. Its Python files are parsed once for all checks."""

from __future__ import annotations

import ast
import contextlib
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.package.errors import SetupFileError
from zbot.package.finder import Origin, Package
from zbot.package.python_finder import import_paths
from zbot.package.python_source import parse_source
from zbot.package.setup_file import declared_scripts
from zbot.package.symlink_install import files_below, installed_files
from zbot_cli.packages.executables import module_file, program_files

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.package.manifest import Manifest


@dataclass(frozen=True, order=True)
class Problem:
    """Problem in a file of a package."""

    path: Path
    line: int  #: counted from 1; 0 for the whole file
    text: str
    is_error: bool = True  #: `False` if the package works in zbot, but may fail in ROS 2

    def __str__(self) -> str:
        shown = shown_path(self.path)
        where = f"{shown}:{self.line}" if self.line else str(shown)
        return f"{where}: {'' if self.is_error else 'warning: '}{self.text}"


def shown_path(path: Path) -> Path:
    """Return a path inside the current folder as a relative path, and other paths unchanged."""
    try:
        return path.relative_to(Path.cwd())
    except (ValueError, FileNotFoundError):  # not inside, or the current folder is deleted
        return path


@dataclass
class CheckedPackage:
    """Package to check. Parts that cannot be read are `None` or missing."""

    name: str
    folder: Path
    manifest: Manifest | None
    modules: dict[Path, ast.Module] = field(default_factory=dict)
    problems: list[Problem] = field(default_factory=list)

    def read_sources(self) -> None:
        """Parse all Python files. An installed file that cannot be parsed becomes a problem."""
        installed = set(self._installed_files())
        files = {path for path in files_below(self.folder) if path.suffix == ".py"}
        for path in sorted(files | installed):
            tree = _parsed(path)
            if not isinstance(tree, Problem):
                self.modules[path] = tree
            elif path in installed or self._is_importable(path):
                self.problems.append(tree)

    def _installed_files(self) -> Iterator[Path]:
        """Yield setup.py, the programs, and the other Python files that a build installs."""
        if (self.folder / "setup.py").is_file():
            yield self.folder / "setup.py"
        with contextlib.suppress(SetupFileError):  # other checks report errors in setup.py
            yield from program_files(self.folder).values()
            package = Package(self.name, self.folder, Origin.WORKSPACE)
            yield from (file for file in installed_files(package).values() if file.suffix == ".py")
            places = tuple(import_paths(self.folder))
            for target in declared_scripts(self.folder).values():
                module = module_file(target.partition(":")[0].strip(), places)
                if module is not None and module.is_relative_to(self.folder):
                    yield module

    def _is_importable(self, path: Path) -> bool:
        """Return whether a file is in a Python package, or in the folder of the launch files."""
        for place in map(Path, import_paths(self.folder)):
            if path.is_relative_to(place):
                top = path.relative_to(place).parts[0]
                if top in {self.name, "launch"}:
                    return True
                if top not in {"test", "tests"} and (place / top / "__init__.py").is_file():
                    return True
        return False

    @property
    def build_type(self) -> str:
        """Build type of ROS 2. It is empty if package.xml has no build type."""
        return self.manifest.build_type if self.manifest else ""


def _parsed(path: Path) -> ast.Module | Problem:
    try:
        return parse_source(path.read_bytes(), str(path))
    except SyntaxError as exc:
        return Problem(path, exc.lineno or 0, f"{type(exc).__name__}: {exc.msg}")
    except (OSError, ValueError, RecursionError, MemoryError) as exc:
        return Problem(path, 0, f"cannot be read: {exc}")


def line_of(path: Path, *texts: str) -> int:
    """Return the number of the first line that contains all strings, or 0 if no line does."""
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    found = (number for number, line in enumerate(lines, 1) if all(text in line for text in texts))
    return next(found, 0)


def imports(tree: ast.Module) -> Iterator[tuple[str, tuple[str, ...], int]]:
    """Yield each imported module, the names that are imported from it, and the line number.

    Imports inside `try` are left out, because the program can run without these modules.
    """
    # Without this set, the content of a `try` in a `try` would be visited several times.
    optional: set[ast.AST] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Try):
            optional.update(node.body)
        if node in optional:
            optional.update(ast.iter_child_nodes(node))
            continue
        if isinstance(node, ast.Import):
            yield from ((alias.name, (), node.lineno) for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield node.module, tuple(alias.name for alias in node.names), node.lineno
