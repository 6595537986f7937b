"""Whether messages come."""

from zbot.launch_test.topics import WaitForTopics as WaitForTopics
