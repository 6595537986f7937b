"""Decorators for the functions of test files."""

from zbot.launch.testing.marker import keep_alive, retry_on_failure
