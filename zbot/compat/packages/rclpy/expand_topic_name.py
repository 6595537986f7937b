"""Full names of topics."""

from zbot.names import expand_topic_name
