"""Running the launches of a test file with their tests."""

from zbot.launch.testing.test_runner import LaunchTestRunner as LaunchTestRunner
