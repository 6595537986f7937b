# Written by python -m zbot.compat.generator; do not edit.
"""Function that runs a test file. `launch_test` and `zbot test` use it."""

from zbot.launch.testing.test_run import (
    load_module as LoadTestsFromPythonFile,
    test_runs as LoadTestsFromPythonModule,
)

__all__ = [
    "LoadTestsFromPythonFile",
    "LoadTestsFromPythonModule",
]
