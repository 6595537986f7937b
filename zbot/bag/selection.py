"""Selection of the topics to record or to play."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

from zbot.bag.description import action_name, is_service_event, service_name
from zbot.bag.errors import BagValueError
from zbot.names import ACTION_PART

_ACTION_TOPICS = (
    "feedback",
    "status",
    "send_goal/_service_event",
    "cancel_goal/_service_event",
    "get_result/_service_event",
)


@dataclass(frozen=True)
class Selection:
    """Rules of rosbag2 that select topics. A service's calls are recorded as a topic of events.

    An action is recorded as its topics and the calls of its services.

    If `all_topics` is true, `topics` and `topic_types` have no effect. The `exclude_...` rules
    override the other rules.

    Raises:
        BagValueError: A regular expression is not valid.
    """

    all_topics: bool = False
    topics: frozenset[str] = frozenset()
    topic_types: frozenset[str] = frozenset()
    regex: str = ""
    all_services: bool = False
    services: frozenset[str] = frozenset()
    all_actions: bool = False
    actions: frozenset[str] = frozenset()
    exclude_topics: frozenset[str] = frozenset()
    exclude_types: frozenset[str] = frozenset()
    exclude_services: frozenset[str] = frozenset()
    exclude_actions: frozenset[str] = frozenset()
    exclude_regex: str = ""

    @classmethod
    def narrowed(
        cls,
        *,
        topics: frozenset[str],
        services: frozenset[str],
        actions: frozenset[str],
        regex: str,
        **exclusions: Any,
    ) -> Selection:
        """Return rules that select everything if they name nothing. `exclusions` override them."""
        is_all = not (topics or services or actions or regex)
        return cls(
            all_topics=is_all,
            all_services=is_all,
            all_actions=is_all,
            topics=topics,
            services=services,
            actions=actions,
            regex=regex,
            **exclusions,
        )

    def __post_init__(self) -> None:
        for pattern in (self.regex, self.exclude_regex):
            try:
                re.compile(pattern)
            except (re.error, OverflowError, RecursionError) as error:
                # Python has other errors for very large numbers and very many brackets.
                raise BagValueError(
                    f"'{pattern[:200]}' is not a regular expression: {error!s}"
                ) from None

    @property
    def is_list(self) -> bool:
        """Whether only topics, services and actions with given names are selected."""
        is_all = self.all_topics or self.all_services or self.all_actions
        return not (is_all or self.topic_types or self.regex)

    @property
    def names(self) -> frozenset[str]:
        """The topics that are selected by name, also those of services and actions."""
        events = {f"{service}/_service_event" for service in self.services}
        parts = {
            f"{action}{ACTION_PART}{part}" for action in self.actions for part in _ACTION_TOPICS
        }
        return self.topics | events | parts

    def takes(self, topic: str, type_name: str) -> bool:
        """Return whether a topic is selected."""
        action = action_name(topic)
        if action:
            name = action
            is_in = self.all_actions or action in self.actions or topic in self.topics
            is_out = action in self.exclude_actions or topic in self.exclude_topics
        elif is_service_event(topic, type_name):
            name = service_name(topic)
            is_in = self.all_services or name in self.services
            is_out = name in self.exclude_services
        else:
            name = topic
            is_in = self.all_topics or topic in self.topics or type_name in self.topic_types
            is_out = topic in self.exclude_topics or type_name in self.exclude_types
        if not is_in and self.regex:
            is_in = re.search(self.regex, name) is not None
        if not is_out and self.exclude_regex:
            is_out = re.search(self.exclude_regex, name) is not None
        return is_in and not is_out
