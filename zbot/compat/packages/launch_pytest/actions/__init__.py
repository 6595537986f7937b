"""Action that marks when tests may begin."""

from zbot.launch.actions.testing import ReadyToTest
