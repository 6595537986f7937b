"""`zbot test`: runs launch files with test cases, and other tests with pytest."""

from __future__ import annotations

import ast
import importlib.util
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, ClassVar, TypeGuard

import typer

import zbot.compat
from zbot.errors import ZbotError
from zbot.errors.installation import pip_install
from zbot.package.cmake_file import read_cmake
from zbot.package.rclpy_choice import choose_rclpy
from zbot.package.ros_variables import set_ros_variables
from zbot.package.workspace import (
    MANIFEST,
    package_folders,
    packages_by_name,
    set_workspace_variable,
)
from zbot_cli.commands.build import unknown_packages_error
from zbot_cli.errors import CommandError
from zbot_cli.input.many_values import ManyValuesCommand
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import new_app
from zbot_cli.output.standard_streams import report

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

app = new_app("Run tests, also those of launch files", has_verbs=False)

_FUNCTION = "generate_test_description"
_PLUGIN = "zbot.compat.pytest_plugin"
_NO_TESTS = 5  #: exit code of pytest


class _TestCommand(ManyValuesCommand):
    many: ClassVar[frozenset[str]] = frozenset({"--packages-select"})


@app.command("test", cls=_TestCommand)
def run_tests(
    words: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[PATH]... [NAME:=VALUE]...",
            help="Files or folders, and launch arguments; without PATH: ./test or this folder",
        ),
    ] = None,
    select: Annotated[
        list[str] | None,
        typer.Option("--packages-select", help="Run the tests of these packages of the workspace"),
    ] = None,
    genuine: Annotated[
        bool, typer.Option("--genuine", help="Let the tests use an installed ROS 2 instead of zbot")
    ] = False,
) -> int:
    """Run tests.

    A file with generate_test_description() is launched. Its test cases run during the launch.
    pytest runs all other tests. With options after --, pytest runs all files.
    """
    given = list(words or ())
    # The options of pytest begin at the first word with a dash, because typer removes the `--`.
    end = next((place for place, word in enumerate(given) if word.startswith("-")), len(given))
    given, options = given[:end], given[end:]
    groups = list(_groups([Path(word) for word in given if ":=" not in word], select or []))
    set_ros_variables()
    if note := choose_rclpy(is_genuine=genuine):
        print(f"note: {note}", file=sys.stderr)
    set_workspace_variable(groups[0][0])
    arguments = [word for word in given if ":=" in word]
    codes = []
    for paths in groups:
        if len(groups) > 1:
            print(f"-- {', '.join(map(str, paths))}", file=sys.stderr, flush=True)
        try:
            codes += _run_group(paths, arguments, options)
        except ZbotError as error:
            if len(groups) == 1:
                raise
            codes.append(report(error))  # the other packages are still tested
    # A package without tests is an error only if no package has tests.
    passed = all(code in {0, _NO_TESTS} for code in codes) and set(codes) != {_NO_TESTS}
    return Status.OK if passed else Status.ERROR


def _groups(paths: list[Path], names: list[str]) -> Iterator[list[Path]]:
    """Yield the tests that run together in one process.

    Args:
        paths: Files and folders. Without paths, the current package or folder is tested.
        names: Packages of the workspace.
    """
    for path in paths:
        if not path.exists():
            raise CommandError(
                f"there is no {path}", hint="name a file, or a folder with test_*.py in it"
            )
    for folder in _folders(names):
        yield from _groups_of(folder)
    if not (paths or names):
        here = Path()
        yield from _groups_of(here) if _is_package(here) else _groups_below(_test_folder(here))
    folders = {path: list(_groups_below(path)) for path in paths if path.is_dir()}
    plain = [path for path in paths if folders.get(path, [[path]]) == [[path]]]
    if plain:
        yield plain
    for path, groups in folders.items():
        yield from () if path in plain else groups


def _run_group(paths: list[Path], arguments: list[str], options: list[str]) -> list[int]:
    """Run launch tests in this process, and other tests in one process of pytest."""
    launches = [path for path in paths if not options and _is_launch(path)]
    others = [path for path in paths if path not in launches]
    codes = [0 if _run_launch(path, arguments) else 1 for path in launches]
    # pytest cannot import a file such as `drive.test.py` by its name.
    dotted = [path for path in others if path.is_file() and "." in path.stem]
    others = [path for path in others if path not in dotted]
    if dotted:
        codes.append(_run_pytest(dotted, ["--import-mode=importlib", *options]))
    return [*codes, _run_pytest(others, options)] if others else codes


def _folders(names: list[str]) -> list[Path]:
    copies = packages_by_name() if names else {}
    folders = {name: places[0] for name, places in copies.items()}
    unknown = [name for name in names if name not in folders]
    if unknown:
        raise unknown_packages_error("--packages-select", unknown, folders)
    return [folders[name] for name in names]


def _is_launch(path: Path) -> bool:
    """Return whether a file is a launch test with unittest cases, as `launch_test` runs them."""
    if not path.is_file():
        return False
    text = path.read_text(encoding="utf-8", errors="replace")
    return _FUNCTION in text and "launch_pytest" not in text and _FUNCTION in _top_names(text)


def _top_names(text: str) -> set[str]:
    """Return the names that a Python file defines, assigns or imports outside of functions."""
    try:
        statements = ast.parse(text).body
    except (SyntaxError, ValueError):
        return set()  # pytest reports the file's mistake
    names = set()
    for statement in statements:
        if isinstance(statement, (ast.FunctionDef, ast.AsyncFunctionDef)):
            names.add(statement.name)
        elif isinstance(statement, (ast.Import, ast.ImportFrom)):
            names.update(alias.asname or alias.name for alias in statement.names)
        else:
            names.update(each.id for each in ast.walk(statement) if _is_assigned(each))
    return names


def _is_assigned(node: ast.AST) -> TypeGuard[ast.Name]:
    return isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)


def _run_launch(path: Path, words: Sequence[str]) -> bool:
    from zbot.launch.arguments import parse_arguments  # noqa: PLC0415 - costs time
    from zbot.launch.testing.test_run import load_module, test_runs  # noqa: PLC0415 - as above

    zbot.compat.install_names({"launch", "launch_ros", "launch_testing"})
    arguments = parse_arguments(words)
    results = []
    for run in test_runs(load_module(path.resolve())):
        if run.name:
            print(f"-- {path.name}{run.name}", file=sys.stderr)
        results += run.run(arguments)
    if not sum(result.testsRun for result in results):
        raise ZbotError(f"{path} has no test cases: write a subclass of unittest.TestCase")
    return all(result.wasSuccessful() for result in results)


def _run_pytest(paths: Sequence[Path], options: Sequence[str]) -> int:
    if importlib.util.find_spec("pytest") is None:
        raise CommandError(
            "without pytest, zbot can run only launch files with test cases",
            hint=pip_install("pytest"),
        )
    command = [sys.executable, "-m", "pytest", "-p", _PLUGIN, *map(str, paths), *options]
    return subprocess.run(command, check=False).returncode  # noqa: S603 - the user's own tests


def _groups_below(folder: Path) -> Iterator[list[Path]]:
    """Yield the groups of all packages in a folder, or the folder itself if it has no packages.

    Raises:
        SetupFileError: The CMakeLists.txt of a package is too large.
    """
    packages = sorted(package_folders([folder]))
    for package in packages:
        yield from _groups_of(package)
    if not packages:
        yield [folder]


def _groups_of(package: Path) -> Iterator[list[Path]]:
    """Yield the groups of a package: each test that its CMakeLists.txt adds, or its test folder.

    Raises:
        SetupFileError: The CMakeLists.txt is too large.
    """
    added = read_cmake(package).tests
    for name in _known(added):
        yield [package / name]
    # A test of a CMake loop, e.g. `ament_add_pytest_test(${name} ${path})`, has no known path.
    if not added or any("${" in name for name in added):
        yield [_test_folder(package)]


def _test_folder(folder: Path) -> Path:
    """Return the folder `test` of a folder, or the folder itself."""
    return folder / "test" if (folder / "test").is_dir() else folder


def _known(names: Iterable[str]) -> dict[str, None]:
    """Return the names without variables in their order, each name once."""
    return dict.fromkeys(name for name in names if "${" not in name)


def _is_package(folder: Path) -> bool:
    """Return whether a folder has a package.xml."""
    return (folder / MANIFEST).is_file()
