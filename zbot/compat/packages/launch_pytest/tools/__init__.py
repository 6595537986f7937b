# Written by python -m zbot.compat.generator; do not edit.
"""Functions that wait for processes."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.testing.tool import (
    assert_output,
    assert_output_sync,
    assert_stderr,
    assert_stderr_sync,
    wait_for_exit,
    wait_for_exit_sync,
    wait_for_output,
    wait_for_output_sync,
    wait_for_start,
    wait_for_start_sync,
    wait_for_stderr,
    wait_for_stderr_sync,
)

__all__ = [
    "assert_output",
    "assert_output_sync",
    "assert_stderr",
    "assert_stderr_sync",
    "wait_for_exit",
    "wait_for_exit_sync",
    "wait_for_output",
    "wait_for_output_sync",
    "wait_for_start",
    "wait_for_start_sync",
    "wait_for_stderr",
    "wait_for_stderr_sync",
]

if TYPE_CHECKING:
    from . import process as process
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "process",
        ),
    )[0]
