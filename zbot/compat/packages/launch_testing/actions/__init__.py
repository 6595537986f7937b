"""Actions of launch files under test."""

from zbot.launch.actions.testing import ReadyToTest
from zbot.launch.testing.test_action import GTest, PyTest, Test
