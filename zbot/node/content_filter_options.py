"""Options of a subscription whose callback gets only some of the messages."""

from __future__ import annotations

from typing import NamedTuple

from zbot.errors import ZbotError


class ContentFilterOptions(NamedTuple):
    """Content filter of a subscription, for `create_subscription`.

    `zbot.interfaces.content_filter` describes the expressions.
    """

    filter_expression: str  #: an empty expression selects every message
    expression_parameters: list[str]  #: values of `%0`, `%1` ..., written as in an expression


class NoContentFilterError(ZbotError, LookupError):
    """`get_content_filter` was called on a subscription without a filter."""

    def __init__(self, topic: str) -> None:
        self.topic = topic
        super().__init__(f"the subscription of {topic} has no content filter")
