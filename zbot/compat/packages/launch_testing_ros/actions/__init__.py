"""launch_testing's actions."""

from zbot.launch.actions.testing import ReadyToTest as ReadyToTest
