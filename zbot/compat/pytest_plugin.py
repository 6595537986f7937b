"""Plugin of pytest for launch tests: files of `launch_testing` and functions of `launch_pytest`.

If zbot is installed, pytest loads this plugin by its entry point. The plugin has no effect on files
without such tests. It also loads the fixtures of `zbot.testing`.

`ros2 pkg create` adds tests to each package. These tests run ROS 2's linters, e.g. `ament_flake8`.
If a linter is not installed, this plugin skips the linter's test, so that the other tests run.
"""

from __future__ import annotations

import io
import unittest
from collections import defaultdict
from contextlib import redirect_stderr
from typing import TYPE_CHECKING, Any, NamedTuple

import pytest

from zbot.package import import_finder

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from zbot.launch.testing.test_run import TestRun

#: Plugins that pytest loads with this one.
pytest_plugins = ("zbot.testing.plugin",)

_MARKS = {"launch_test", "rostest"}
_LINTERS = {
    "ament_clang_format", "ament_clang_tidy", "ament_copyright", "ament_cppcheck", "ament_cpplint",
    "ament_flake8", "ament_lint", "ament_lint_cmake", "ament_mypy", "ament_pclint", "ament_pep257",
    "ament_pycodestyle", "ament_uncrustify", "ament_xmllint",
}  # fmt: skip
_skipped_linters: set[str] = set()


def pytest_configure(config: pytest.Config) -> None:
    """Register the marks, and skip the tests of linters from now on."""
    import_finder.explain(_skip_linter)
    for line in (
        "launch_test: the function describes the launch for the test cases of its file",
        "rostest: older name of launch_test",
        "launch(fixture, shutdown=False): the test runs with the launch of a launch_pytest.fixture",
    ):
        config.addinivalue_line("markers", line)


def pytest_unconfigure() -> None:
    """Do not skip the tests of linters any longer."""
    import_finder.stop_explaining(_skip_linter)


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    """Set exit code 0 if pytest has no tests only because it skipped the tests of linters."""
    if exitstatus == pytest.ExitCode.NO_TESTS_COLLECTED and _skipped_linters:
        session.exitstatus = pytest.ExitCode.OK


def _skip_linter(fullname: str, path: object) -> BaseException | None:
    """Return the exception that skips a test file, if the file imports a linter of ROS 2.

    This function is asked only if the linter is not installed.
    """
    if path is not None or fullname not in _LINTERS:
        return None
    _skipped_linters.add(fullname)
    text = f"{fullname} is a linter of ROS 2: zbot lacks it"
    return pytest.skip.Exception(text, allow_module_level=True)


def pytest_pycollect_makemodule(
    module_path: Path, parent: pytest.Collector
) -> pytest.Module | None:
    """Return a collector for a file that describes a launch, or `None` for other files.

    In ROS 2, pytest launches only files with one of the marks. Without a launch, the test cases
    would wait for programs that nobody starts.
    """
    text = module_path.read_text(encoding="utf-8", errors="replace")
    if "generate_test_description" not in text or not any(mark in text for mark in _MARKS):
        return None  # such a file is not imported here, because it contains no launch test
    module: pytest.Module = pytest.Module.from_parent(parent, path=module_path)
    function = getattr(module.obj, "generate_test_description", None)
    marks = {mark.name for mark in getattr(function, "pytestmark", [])}
    is_launch = marks & _MARKS or (function is not None and _has_test_cases(module.obj))
    return _LaunchModule.from_parent(parent, path=module_path) if is_launch else module


def _has_test_cases(module: object) -> bool:
    values = vars(module).values()
    return any(isinstance(value, type) and issubclass(value, unittest.TestCase) for value in values)


class _LaunchModule(pytest.Module):
    """File with a launch test. It has one item for each set of values of `parametrize`."""

    def collect(self) -> Iterable[pytest.Item]:
        from zbot.launch.testing.test_run import test_runs  # noqa: PLC0415 - only launch tests need it

        for run in test_runs(self.obj):
            yield _LaunchItem.from_parent(self, name=f"launch{run.name}", test_run=run)


class _LaunchItem(pytest.Item):
    """One launch with all its test cases."""

    def __init__(self, *, test_run: TestRun, **options: Any) -> None:
        super().__init__(**options)
        self._run = test_run

    def runtest(self) -> None:
        """Run the launch and its test cases.

        Raises:
            _FailedCasesError: At least one test case failed.
        """
        report = io.StringIO()
        with redirect_stderr(report):
            results = self._run.run()
        print(report.getvalue())
        failed = [failure for result in results for failure in (*result.failures, *result.errors)]
        if failed:
            raise _FailedCasesError([(str(case), text) for case, text in failed])
        if results and all(len(result.skipped) == result.testsRun for result in results):
            raise unittest.SkipTest("all tests of this launch were skipped")

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        if isinstance(excinfo.value, _FailedCasesError):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int, str]:
        """Return the file, line and name of the item."""
        return self.path, 0, f"{self.path.name}::{self.name}"


class _FailedCasesError(Exception):
    def __init__(self, failed: list[tuple[str, str]]) -> None:
        self.failed = failed
        super().__init__("\n".join(f"{case}\n{text}" for case, text in failed))


@pytest.hookimpl(tryfirst=True)
def pytest_pycollect_makeitem(
    collector: pytest.Module | pytest.Class, name: str, obj: Any
) -> list[pytest.Item] | None:
    """Return the items of a function with the mark `launch`. The items use the mark's fixture."""
    # Only a test has marks in `pytestmark`. `pytest.mark` itself makes a mark of this name.
    if isinstance(obj, type) or not collector.funcnamefilter(name):
        return None
    marks = [mark for mark in getattr(obj, "pytestmark", []) if mark.name == "launch"]
    if not marks:
        return None
    made = marks[0].kwargs.get("fixture")
    if made is None:
        return [_skipped(collector, name)]
    from zbot.launch.testing.launch_fixture import name_and_scope  # noqa: PLC0415 - only launch tests need it
    from zbot.launch.testing.staged_test import StagedTest  # noqa: PLC0415 - only launch tests need it

    fixture_name, scope = name_and_scope(made)
    test, shutdown = StagedTest(obj, fixture_name), bool(marks[0].kwargs.get("shutdown"))
    if scope == "function" or shutdown or not test.has_two_stages:
        whole = test.as_one_function(shutdown=shutdown)
        return _items(collector, name, whole, _Stage(made, fixture_name, scope, shutdown))
    first, second = test.as_two_functions()
    return [
        *_items(collector, name, first, _Stage(made, fixture_name, scope, False)),
        *_items(
            collector, f"{name}[shutdown_test]", second, _Stage(made, fixture_name, scope, True)
        ),
    ]


class _Stage(NamedTuple):
    """Stage of a launch at which an item of pytest runs."""

    fixture: Any
    fixture_name: str
    scope: str
    is_last: bool  #: whether the item runs after the end of the launch

    def key(self, item: pytest.Item) -> Any:
        """Return a key that is equal for all items that share one launch."""
        parameters = getattr(item, "callspec", None)
        index = parameters.indices.get(self.fixture_name) if parameters is not None else None
        kinds: dict[str, Any] = {
            "class": pytest.Class,
            "module": pytest.Module,
            "package": pytest.Package,
        }
        kind = kinds.get(self.scope)
        owner = None if kind is None else item.getparent(kind)
        return id(self.fixture), index, owner


_STAGE = pytest.StashKey[_Stage]()


def _items(
    collector: pytest.Module | pytest.Class, name: str, plain: Any, stage: _Stage
) -> list[pytest.Item]:
    used = pytest.mark.usefixtures(stage.fixture_name)(plain)
    setattr(collector.obj, name, used)  # pytest calls the attribute of this name
    items: list[pytest.Item] = list(collector._genfunctions(name, used))  # noqa: SLF001 - pytest has no public way
    for item in items:
        item.stash[_STAGE] = stage
    return items


def _skipped(collector: pytest.Module | pytest.Class, name: str) -> pytest.Item:
    item: pytest.Item = pytest.Function.from_parent(collector, name=name)
    reason = (
        'the "fixture" keyword argument is required in pytest.mark.launch(): nothing is launched'
    )
    item.warn(pytest.PytestWarning(reason))
    item.add_marker(pytest.mark.skip(reason=reason))
    return item


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Order each launch's tests: the tests during the launch run before the tests after it."""
    places: defaultdict[Any, list[int]] = defaultdict(list)
    for place, item in enumerate(items):
        stage = item.stash.get(_STAGE, None)
        if stage is not None and stage.scope != "function":
            places[stage.key(item)].append(place)
    for shared in places.values():
        in_order = sorted(
            (items[place] for place in shared), key=lambda item: item.stash[_STAGE].is_last
        )
        for place, item in zip(shared, in_order, strict=True):
            items[place] = item


@pytest.fixture
def launch_service() -> Any:
    """Return the launch service of the test's launch."""
    from zbot.launch.testing.error import LaunchTestError  # noqa: PLC0415 - only launch tests need it
    from zbot.launch.testing.launch_fixture import running  # noqa: PLC0415 - only launch tests need it

    if not running:
        raise LaunchTestError("no launch is running: request a launch fixture first")
    return list(running.values())[-1].service


@pytest.fixture
def launch_context(launch_service: Any) -> Any:
    """Return the launch context of the test's launch."""
    return launch_service.context
