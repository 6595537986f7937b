"""Launch that runs in its own thread while its tests run in another thread."""

from __future__ import annotations

import asyncio
import threading
from typing import TYPE_CHECKING, Any

from zbot.launch.event import Shutdown
from zbot.launch.event_handler import EventHandler
from zbot.launch.process_event import ProcessExited, ProcessIO, ProcessStarted
from zbot.launch.service import LaunchService
from zbot.launch.testing.error import LaunchTestError
from zbot.launch.testing.record import ExitRecord, OutputRecord
from zbot.launch.testing.test_action import ReadyToTest, ReadyToTestEvent

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Mapping

    from zbot.launch.description import LaunchDescription
    from zbot.launch.entity import LaunchDescriptionEntity

READY_TIMEOUT_S = 15.0  # the default of launch_testing
# Longest time in which a launch may end. By default, SIGTERM comes 5 s after SIGINT, and SIGKILL
# 5 s after SIGTERM. An action may set longer times.
_LONGEST_END_S = 60.0


class RunningLaunch:
    """A launch in its own thread.

    Args:
        description: The launch description.
        arguments: The launch arguments.
        keep_alive: Whether the launch continues when all its processes have ended.
        must_get_ready: Whether a description without `ReadyToTest` is an error.
        debug: Whether debug lines are shown.
    """

    def __init__(
        self,
        description: LaunchDescription,
        arguments: Mapping[str, str] | None = None,
        *,
        keep_alive: bool = False,
        must_get_ready: bool = True,
        debug: bool = False,
    ) -> None:
        self.proc_output = OutputRecord()
        self.proc_info = ExitRecord()
        self.service = LaunchService(noninteractive=True, debug=debug)
        self._keep_alive = keep_alive
        self._state_changed = threading.Condition()
        self._is_ready = not (must_get_ready or any(ready_actions(description.entities)))
        self.is_over = False  #: whether the launch has ended
        context = self.service.context
        context.launch_configurations.update(arguments or {})
        for kind, function in (
            (ProcessStarted, self.proc_info.append),
            (ProcessStarted, self.proc_output.track),
            (ProcessExited, self.proc_info.append),
            (ProcessIO, self.proc_output.append),
            (ReadyToTestEvent, self._on_ready),
        ):
            context.register_event_handler(_handler(kind, function))
        self.service.include_launch_description(description)
        self._thread = threading.Thread(
            target=lambda: asyncio.run(self._run()), name="launch under test", daemon=True
        )
        self._thread.start()

    async def _run(self) -> None:
        try:
            await self.service.run_async(shutdown_when_idle=not self._keep_alive)
        finally:
            with self._state_changed:
                self.is_over = True
                self._state_changed.notify_all()

    def _on_ready(self, event: object) -> None:
        del event
        with self._state_changed:
            self._is_ready = True
            self._state_changed.notify_all()

    def wait_until_ready(self, timeout_s: float = READY_TIMEOUT_S) -> None:
        """Wait for `ReadyToTest`. A launch that does not need `ReadyToTest` is ready immediately.

        Raises:
            LaunchTestError: The launch did not reach `ReadyToTest` in time, or it ended first.
        """
        with self._state_changed:
            self._state_changed.wait_for(lambda: self._is_ready or self.is_over, timeout_s)
            if self._is_ready:
                return
        if self.is_over:
            raise LaunchTestError("the launch ended before its tests could begin")
        self.stop()
        raise LaunchTestError(
            f"the launch did not reach ReadyToTest within {timeout_s:g} s",
            "put launch_testing.actions.ReadyToTest() into the launch description",
        )

    def stop(self) -> None:
        """End the launch and wait until its processes have ended. A second call does nothing.

        Raises:
            LaunchTestError: The launch did not end within 60 s.
        """
        with self._state_changed:
            if not self.is_over:
                self.service.emit_event(Shutdown(reason="the tests are over"))
        self._thread.join(_LONGEST_END_S)
        if self._thread.is_alive():
            raise LaunchTestError(
                f"the launch did not end within {_LONGEST_END_S:g} s",
                "set sigterm_timeout and sigkill_timeout to shorter times",
            )


def _handler(kind: type[Any], function: Any) -> EventHandler:
    return EventHandler(
        matcher=lambda event: isinstance(event, kind), entities=lambda event, _: function(event)
    )


def on_ready_to_test(function: Callable[[], object]) -> EventHandler:
    """Return a handler that calls a function when the launch reaches `ReadyToTest`."""

    def begin(event: object) -> None:
        del event
        function()

    return _handler(ReadyToTestEvent, begin)


def ready_actions(entities: Iterable[LaunchDescriptionEntity]) -> Iterator[ReadyToTest]:
    """Yield the `ReadyToTest` actions of a description."""
    for entity in entities:
        if isinstance(entity, ReadyToTest):
            yield entity
        yield from ready_actions(entity.describe_sub_entities())
        for _, some in entity.describe_conditional_sub_entities():
            yield from ready_actions(some)
