"""Tests of launch files. The names are the same as in `launch_testing` and `launch_pytest`.

A test file describes a launch that contains the action `ReadyToTest`. The test cases in the file
run during the launch. Test cases with the decorator `post_shutdown_test` run after the launch has
ended. Test cases get the output (`proc_output`) and the exit codes (`proc_info`) of the processes.
"""

from __future__ import annotations
