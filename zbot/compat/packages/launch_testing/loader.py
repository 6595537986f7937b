# Written by python -m zbot.compat.generator; do not edit.
"""Runs of a test file."""

from zbot.launch.testing.test_run import TestRun, test_runs as LoadTestsFromPythonModule

__all__ = [
    "LoadTestsFromPythonModule",
    "TestRun",
]
