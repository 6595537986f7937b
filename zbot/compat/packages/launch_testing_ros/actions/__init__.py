"""Actions of `launch_testing`."""

from zbot.launch.actions.testing import ReadyToTest
