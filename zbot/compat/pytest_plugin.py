"""Tests of launches under pytest: files of `launch_testing`, and functions of `launch_pytest`.

pytest loads this by its entry point wherever zbot is installed; it does nothing before a file asks
for one of both.
"""

from __future__ import annotations

import io
import unittest
from contextlib import redirect_stderr
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from zbot.launch_test.test_run import TestRun

_MARKS = {"launch_test", "rostest"}


def pytest_configure(config: pytest.Config) -> None:
    """Make the marks known."""
    for line in (
        "launch_test: the function describes a launch that the file's test cases run beside",
        "rostest: the same, by its older name",
        "launch(fixture, shutdown=False): the test runs beside a launch_pytest.fixture",
    ):
        config.addinivalue_line("markers", line)


# -- launch_testing --------------------------------------------------------------------------------


def pytest_pycollect_makemodule(
    module_path: Path, parent: pytest.Collector
) -> pytest.Module | None:
    """Take over files that describe a launch with one of the marks."""
    text = module_path.read_text(encoding="utf-8", errors="replace")
    if "generate_test_description" not in text or not any(mark in text for mark in _MARKS):
        return None  # nothing is imported that is not asked for
    module: pytest.Module = pytest.Module.from_parent(parent, path=module_path)
    function = getattr(module.obj, "generate_test_description", None)
    marks = {mark.name for mark in getattr(function, "pytestmark", [])}
    return _LaunchModule.from_parent(parent, path=module_path) if marks & _MARKS else module


class _LaunchModule(pytest.Module):
    """A file with a launch: one item for each row of its parameters."""

    def collect(self) -> Iterable[pytest.Item]:
        from zbot.launch_test.test_run import test_runs  # noqa: PLC0415 - only files that need it

        for run in test_runs(self.obj):
            yield _LaunchItem.from_parent(self, name=f"launch{run.name}", test_run=run)


class _LaunchItem(pytest.Item):
    """One launch with all of its test cases."""

    def __init__(self, *, test_run: TestRun, **options: Any) -> None:
        super().__init__(**options)
        self._run = test_run

    def runtest(self) -> None:
        """Run the launch and its tests.

        Raises:
            _FailedCasesError: At least one of them failed.
        """
        report = io.StringIO()
        with redirect_stderr(report):
            results = self._run.run()
        print(report.getvalue())
        failed = [failure for one in results for failure in (*one.failures, *one.errors)]
        if failed:
            raise _FailedCasesError([(str(case), text) for case, text in failed])
        if results and all(len(one.skipped) == one.testsRun for one in results):
            raise unittest.SkipTest("all of its tests were skipped")

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """Return the tests' own tracebacks."""
        if isinstance(excinfo.value, _FailedCasesError):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int, str]:
        """Return where it is from."""
        return self.path, 0, f"{self.path.name}::{self.name}"


class _FailedCasesError(Exception):
    def __init__(self, failed: list[tuple[str, str]]) -> None:
        self.failed = failed
        super().__init__("\n".join(f"{case}\n{text}" for case, text in failed))


# -- launch_pytest ---------------------------------------------------------------------------------


@pytest.hookimpl(tryfirst=True)
def pytest_pycollect_makeitem(
    collector: pytest.Module | pytest.Class, name: str, obj: Any
) -> list[pytest.Item] | None:
    """Give functions that are marked with `launch` their launch."""
    marks = [mark for mark in getattr(obj, "pytestmark", []) if mark.name == "launch"]
    if not marks or isinstance(obj, type) or not collector.funcnamefilter(name):
        return None
    from zbot.launch_test.launch_fixture import (  # noqa: PLC0415 - as above
        as_plain_test,
        name_of,
    )

    fixture_name = name_of(marks[0].kwargs.get("fixture"))
    shutdown = bool(marks[0].kwargs.get("shutdown"))
    plain = pytest.mark.usefixtures(fixture_name)(
        as_plain_test(obj, fixture_name, shutdown=shutdown)
    )
    setattr(collector.obj, name, plain)  # where pytest looks for what it calls
    return list(collector._genfunctions(name, plain))  # noqa: SLF001 - pytest has no public way


@pytest.fixture
def launch_service() -> Any:
    """Give the service of the launch that the test runs beside."""
    from zbot.launch_test.error import LaunchTestError  # noqa: PLC0415 - as above
    from zbot.launch_test.launch_fixture import running  # noqa: PLC0415 - as above

    if not running:
        raise LaunchTestError("no launch runs: ask for its fixture in front of this one")
    return list(running.values())[-1].service


@pytest.fixture
def launch_context(launch_service: Any) -> Any:
    """Give the context of the launch that the test runs beside."""
    return launch_service.context
