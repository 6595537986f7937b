"""Problems of the topics that a command reads, e.g. that a topic has an unknown type."""

from __future__ import annotations

import contextlib
import sys
from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot_cli.input.domain_names import as_typed

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator


class TopicProblems:
    """Problems of topics. They end the command only if the user has named the topic.

    Other topics fit a pattern or `--all`. Anybody may publish on them.

    Args:
        named: Full names of the topics that the user has named.
    """

    def __init__(self, named: Collection[str]) -> None:
        self._named = named
        self.topics: set[str] = set()  #: topics whose problem was printed

    @contextlib.contextmanager
    def of(self, topic: str) -> Iterator[None]:
        """Print the error of the `with` block on stderr, once for each topic.

        Raises:
            ZbotError: The error is that of a topic that the user has named.
        """
        try:
            yield
        except ZbotError as error:
            if topic in self._named:
                raise
            if topic not in self.topics:
                self.topics.add(topic)
                print(f"cannot show {as_typed(topic)}: {error}", file=sys.stderr, flush=True)
