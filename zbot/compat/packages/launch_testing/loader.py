"""Runs of a test file."""

from zbot.launch.testing import test_run

LoadTestsFromPythonModule = test_run.test_runs
TestRun = test_run.TestRun
