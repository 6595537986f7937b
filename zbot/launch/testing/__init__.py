"""Tests of launch files. The names are the same as in `launch_testing` and `launch_pytest`.

A test file describes a launch that contains `ReadyToTest`. Its test cases run during the launch.
Cases with the decorator `post_shutdown_test` run after the launch has ended. Test cases get the
output of the processes (`proc_output`) and their exit codes (`proc_info`).
"""

from __future__ import annotations
