"""Helper that waits for messages of topics."""

from zbot.launch.testing.topics import WaitForTopics
