"""Hidden names."""

from zbot.names import is_hidden as topic_or_service_is_hidden

HIDDEN_TOPIC_PREFIX = "_"
