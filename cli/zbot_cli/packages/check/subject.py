"""Package that the checks examine. Its Python files are parsed once for all checks."""

from __future__ import annotations

import ast
import contextlib
import warnings
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from zbot.package.setup_file import SetupFileError
from zbot.package.symlink_install import files_below
from zbot_cli.packages.check.problem import Problem
from zbot_cli.packages.executables import program_files

if TYPE_CHECKING:
    from pathlib import Path

    from zbot.package.manifest import Manifest


@dataclass
class Subject:
    """Package to check. Parts that cannot be read are `None` or missing."""

    name: str
    folder: Path
    manifest: Manifest | None
    modules: dict[Path, ast.Module] = field(default_factory=dict)
    problems: list[Problem] = field(default_factory=list)

    def read_sources(self) -> None:
        """Parse all Python files. A file that cannot be parsed becomes a problem."""
        files = {path for path in files_below(self.folder) if path.suffix == ".py"}
        with contextlib.suppress(SetupFileError):  # other checks report errors in setup.py
            files.update(program_files(self.folder).values())
        for path in sorted(files):
            tree = _parsed(path)
            if isinstance(tree, Problem):
                self.problems.append(tree)
            else:
                self.modules[path] = tree

    @property
    def build_type(self) -> str:
        """Build type of ROS 2. It is empty if package.xml names no build type."""
        return self.manifest.build_type if self.manifest else ""


def _parsed(path: Path) -> ast.Module | Problem:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the user sees the warnings when the file runs
            return ast.parse(path.read_bytes(), str(path))
    except SyntaxError as exc:
        return Problem(path, exc.lineno or 0, f"{type(exc).__name__}: {exc.msg}")
    except (OSError, ValueError, RecursionError, MemoryError) as exc:
        return Problem(path, 0, f"cannot be read: {exc}")


def line_of(path: Path, *texts: str) -> int:
    """Return the number of the first line that contains all strings, or 0 if no line does."""
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    found = (number for number, line in enumerate(lines, 1) if all(one in line for one in texts))
    return next(found, 0)
