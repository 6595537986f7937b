"""Where tests may begin."""

from zbot.launch.actions.testing import ReadyToTest as ReadyToTest
