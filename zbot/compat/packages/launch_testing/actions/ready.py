"""`ReadyToTest` under its own module's name."""

from zbot.launch.actions.testing import ReadyToTest
