"""Running a test file: `launch_test` and `zbot test` do."""

from zbot.launch_test import test_run

LoadTestsFromPythonFile = test_run.load_module
LoadTestsFromPythonModule = test_run.test_runs
