"""What a launch file under test can have done."""

from zbot.launch.actions.testing import ReadyToTest as ReadyToTest
from zbot.launch.testing.test_action import GTest as GTest
from zbot.launch.testing.test_action import PyTest as PyTest
from zbot.launch.testing.test_action import Test as Test
