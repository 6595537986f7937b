"""Tests of launch files, under the rules of ROS 2's `launch_testing` and `launch_pytest`.

A test file describes a launch with a `ReadyToTest` in it; its test cases run while the launch does,
those marked `post_shutdown_test` after it has ended. They are given what the processes wrote
(`proc_output`) and how they ended (`proc_info`).
"""

from __future__ import annotations
