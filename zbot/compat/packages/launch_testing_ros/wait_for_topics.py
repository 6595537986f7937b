"""Whether messages come."""

from zbot.launch.testing.topics import WaitForTopics as WaitForTopics
