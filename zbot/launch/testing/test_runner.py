"""launch_testing's `LaunchTestRunner`: the runs of a test file, one after the other."""

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
    """What became of all tests of a run, those beside the launch and those after it."""

    def __init__(self) -> None:
        super().__init__()
        self._is_broken = False

    def include(self, results: Iterable[unittest.TestResult]) -> None:
        """Count what other results say."""
        for one in results:
            self.testsRun += one.testsRun
            self.failures += one.failures
            self.errors += one.errors
            self.skipped += one.skipped

    def break_off(self) -> None:
        """Note that the launch ended before its tests did."""
        self._is_broken = True

    def wasSuccessful(self) -> bool:  # noqa: N802 - unittest's name
        """Return whether all tests came to their end, and none failed."""
        return super().wasSuccessful() and not self._is_broken


class LaunchTestRunner:
    """Runs the launches of a test file, each with its tests.

    Args:
        test_runs: What `LoadTestsFromPythonModule` returned.
        launch_file_arguments: Launch arguments as on a command line, `name:=value`.
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
        """Check that each description takes what `parametrize` gives it, and nothing else.

        Raises:
            LaunchTestError: One does not.
        """
        for run in self._test_runs:
            run.validate()

    def run(self) -> dict[TestRun, unittest.TestResult]:
        """Launch, test, and launch the next; none follows one that ended before its tests did."""
        results: dict[TestRun, unittest.TestResult] = {}
        for run in self._test_runs:
            result = results[run] = RunResult()
            try:
                result.include(run.run(self._arguments, debug=self._debug))
            except LaunchTestError as error:
                print(error, file=sys.stderr)
                result.break_off()
                break
        return results
