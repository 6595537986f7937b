"""What a launch file under test can have done."""

from zbot.launch.actions.testing import ReadyToTest as ReadyToTest
