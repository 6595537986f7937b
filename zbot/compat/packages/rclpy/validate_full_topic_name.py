"""Checks of full names."""

from zbot.errors import InvalidServiceNameError as InvalidServiceNameException
from zbot.errors import InvalidTopicNameError as InvalidTopicNameException
from zbot.names import validate_full_topic_name
