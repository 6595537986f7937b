"""Waiting for processes."""

from zbot.launch.testing.tool import assert_output as assert_output
from zbot.launch.testing.tool import assert_output_sync as assert_output_sync
from zbot.launch.testing.tool import assert_stderr as assert_stderr
from zbot.launch.testing.tool import assert_stderr_sync as assert_stderr_sync
from zbot.launch.testing.tool import wait_for_exit as wait_for_exit
from zbot.launch.testing.tool import wait_for_exit_sync as wait_for_exit_sync
from zbot.launch.testing.tool import wait_for_output as wait_for_output
from zbot.launch.testing.tool import wait_for_output_sync as wait_for_output_sync
from zbot.launch.testing.tool import wait_for_start as wait_for_start
from zbot.launch.testing.tool import wait_for_start_sync as wait_for_start_sync
from zbot.launch.testing.tool import wait_for_stderr as wait_for_stderr
from zbot.launch.testing.tool import wait_for_stderr_sync as wait_for_stderr_sync
