"""Runner of all launches in a test file, with the interface of `LaunchTestRunner` in ROS 2."""

from __future__ import annotations

import sys
import unittest
from typing import TYPE_CHECKING

from zbot.launch.arguments import parse_arguments
from zbot.launch.testing.error import LaunchTestError

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from zbot.launch.testing.test_run import TestRun


class RunResult(unittest.TestResult):
    """Result of all tests of a run, both during the launch and after the launch."""

    def __init__(self) -> None:
        super().__init__()
        self._is_broken = False

    def include(self, results: Iterable[unittest.TestResult]) -> None:
        """Add the counts of other results."""
        for result in results:
            self.testsRun += result.testsRun
            self.failures += result.failures
            self.errors += result.errors
            self.skipped += result.skipped

    def mark_incomplete(self) -> None:
        """Mark the result as failed, because the launch ended before all its tests had run."""
        self._is_broken = True

    def wasSuccessful(self) -> bool:  # noqa: N802 - unittest's name
        """Return whether all tests ran and no test failed."""
        return super().wasSuccessful() and not self._is_broken


class LaunchTestRunner:
    """Runs the launches of a test file. Each launch has its own tests.

    Args:
        test_runs: The result of `LoadTestsFromPythonModule`.
        launch_file_arguments: Launch arguments in the form `name:=value`.
        debug: Whether debug lines are shown.
    """

    def __init__(
        self,
        test_runs: Sequence[TestRun],
        launch_file_arguments: Sequence[str] = (),
        debug: bool = False,
    ) -> None:
        self._test_runs, self._debug = list(test_runs), debug
        self._arguments = parse_arguments(launch_file_arguments)

    def validate(self) -> None:
        """Check that each `generate_test_description` has the same arguments as its `parametrize`.

        Raises:
            LaunchTestError: The arguments differ.
        """
        for run in self._test_runs:
            run.validate()

    def run(self) -> dict[TestRun, unittest.TestResult]:
        """Run all launches in order. Stop if a launch ends before all its tests have run."""
        results: dict[TestRun, unittest.TestResult] = {}
        for run in self._test_runs:
            result = results[run] = RunResult()
            try:
                result.include(run.run(self._arguments, debug=self._debug))
            except LaunchTestError as error:
                print(error, file=sys.stderr)
                result.mark_incomplete()
                break
        return results
