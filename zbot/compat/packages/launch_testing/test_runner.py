"""Running the launches of a test file with their tests."""

from zbot.launch_test.test_runner import LaunchTestRunner as LaunchTestRunner
