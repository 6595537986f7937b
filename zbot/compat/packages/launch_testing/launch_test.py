"""Function that runs a test file. `launch_test` and `zbot test` use it."""

from zbot.launch.testing import test_run

LoadTestsFromPythonFile = test_run.load_module
LoadTestsFromPythonModule = test_run.test_runs
