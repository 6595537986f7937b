"""`zbot test`: runs launch files with test cases, and other tests with pytest."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import zbot.compat
from zbot.errors import ZbotError
from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import new_app

if TYPE_CHECKING:
    from collections.abc import Sequence

app = new_app("Run tests and launch tests", has_verbs=False)

_PLUGIN = "zbot.compat.pytest_plugin"


class NoTestsError(ZbotError):
    """The command line names a path that does not exist."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.hint = "name a file, or a folder with test_*.py in it"
        super().__init__(f"there is no {path}")


class NoPytestError(ZbotError):
    """Some tests need pytest, which is not installed."""

    def __init__(self) -> None:
        self.hint = "pip install pytest"
        super().__init__("without pytest, zbot can run only launch files with test cases")


@app.command("test")
def run_tests(
    words: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[PATH]... [NAME:=VALUE]...",
            help="Files or folders, and launch arguments; without PATH: ./test or this folder",
        ),
    ] = None,
) -> int:
    """Run tests.

    A file with generate_test_description() is launched. Its test cases run during the launch.
    All other tests are run by pytest. With options after --, pytest also runs the launch files.

    Examples:
      zbot test test/test_talker_listener_launch.py
      zbot test src/my_package -- -k talker
    """
    given = list(words or ())
    # The options of pytest begin at the first word with a dash, because typer removes the `--`.
    end = next((place for place, word in enumerate(given) if word.startswith("-")), len(given))
    given, options = given[:end], given[end:]
    paths = [Path(word) for word in given if ":=" not in word]
    if not paths:
        paths = [Path("test") if Path("test").is_dir() else Path()]
    for path in paths:
        if not path.exists():
            raise NoTestsError(path)
    arguments = [word for word in given if ":=" in word]
    launches = [path for path in paths if not options and _is_launch(path)]
    others = [path for path in paths if path not in launches]
    failed = [path for path in launches if not _run_launch(path, arguments)]
    code = _run_pytest(others, options) if others else 0
    return Status.ERROR if failed or code else Status.OK


def _is_launch(path: Path) -> bool:
    """Return whether a file is a launch test with unittest cases, as `launch_test` runs them."""
    if not path.is_file():
        return False
    text = path.read_text(encoding="utf-8", errors="replace")
    return "def generate_test_description" in text and "launch_pytest" not in text


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
        raise NoPytestError
    command = [sys.executable, "-m", "pytest", "-p", _PLUGIN, *map(str, paths), *options]
    return subprocess.run(command, check=False).returncode  # noqa: S603 - the user's own tests
