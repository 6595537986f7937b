"""Event handler that reacts to a text in the stdout of a process."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.event_handler import EventHandler
from zbot.launch.process_event import ProcessIO

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.launch.actions.execute import ExecuteLocal
    from zbot.launch.entity import LaunchDescriptionEntity


class StdoutReadyListener(EventHandler):
    """Visits actions when a process has written a text to stdout for the first time.

    Args:
        target_action: The process. None means any process.
        ready_txt: The text.
        actions: The actions, for example `ReadyToTest()`.
    """

    def __init__(
        self,
        *,
        target_action: ExecuteLocal | None = None,
        ready_txt: str,
        actions: Sequence[LaunchDescriptionEntity] | None = None,
    ) -> None:
        self._process, self._wanted = target_action, ready_txt.encode()
        self._seen = b""
        super().__init__(matcher=self._is_ready, entities=list(actions or ()), handle_once=True)

    def describe(self) -> tuple[str, list[LaunchDescriptionEntity]]:  # type: ignore[override]
        """Return a description in one line, and the actions, as launch_testing does."""
        actions = self.entities if isinstance(self.entities, list) else []
        return f"StdoutReadyListener(ready_txt={self._wanted.decode()!r})", actions

    def _is_ready(self, event: Any) -> bool:
        if not isinstance(event, ProcessIO) or not event.from_stdout:
            return False
        if self._process is not None and event.action is not self._process:
            return False
        self._seen += event.text  # a line may come in pieces
        if self._wanted in self._seen:
            return True
        self._seen = self._seen[-len(self._wanted) :]
        return False
