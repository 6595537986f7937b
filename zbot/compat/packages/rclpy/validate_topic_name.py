"""Checks of topics' names."""

from zbot.errors import InvalidServiceNameError as InvalidServiceNameException
from zbot.errors import InvalidTopicNameError as InvalidTopicNameException
from zbot.names import validate_topic_name

TOPIC_SEPARATOR_STRING = "/"
