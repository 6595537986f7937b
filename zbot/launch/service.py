"""Runs a launch: visits what is described, works on events, until nothing is left to wait for."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import signal
import threading
from typing import TYPE_CHECKING, Any

from zbot.launch.context import LaunchContext
from zbot.launch.errors import LaunchFileError
from zbot.launch.event import IncludeLaunchDescriptionEvent, Shutdown, TimerSkipped
from zbot.launch.event_handler import OnIncludeLaunchDescription
from zbot.launch.log import launch_config
from zbot.launch.signal_manager import AsyncSafeSignalManager

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from zbot.launch.description import LaunchDescription
    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.event import Event


class LaunchService:
    """Runs launch descriptions.

    Args:
        argv: Arguments of the launch, for those that ask for them.
        noninteractive: Whether processes get no terminal to read from.
        debug: Whether debug lines are shown.
        log_file_name: The file that the launch writes to, in the folder of its log; its own lines
            are told apart by the name, too.
        find_program: Called with a package and an executable before a node is started; raises
            where there is none.
    """

    def __init__(
        self,
        *,
        argv: Sequence[str] | None = None,
        noninteractive: bool = False,
        debug: bool = False,
        log_file_name: str | None = None,
        find_program: Callable[[str, str], object] | None = None,
    ) -> None:
        self._logger_name = (log_file_name or "launch").removesuffix(".log")
        self._log_file_name = f"{self._logger_name}.log"
        if log_file_name is not None:
            launch_config.log_file_name = self._log_file_name
        self.__context = LaunchContext(
            argv=argv, noninteractive=noninteractive, find_program=find_program, debug=debug
        )
        self.__context.register_event_handler(OnIncludeLaunchDescription())
        self.__task: asyncio.Task[Any] | None = None
        self._interrupts = 0

    @property
    def context(self) -> LaunchContext:
        """What the launch knows."""
        return self.__context

    @property
    def event_loop(self) -> asyncio.AbstractEventLoop | None:
        """The loop that the launch runs in; None while it does not run."""
        return self.__context.asyncio_loop

    @property
    def task(self) -> asyncio.Task[Any] | None:
        """The task that the launch ran in last."""
        return self.__task

    def _is_idle(self) -> bool:
        # Tests of launch_pytest ask for it by launch's own name.
        return self.context.is_idle

    def include_launch_description(self, launch_description: LaunchDescription) -> None:
        """Launch a description, now or as soon as the service runs; from any thread."""
        self.emit_event(IncludeLaunchDescriptionEvent(launch_description))

    def emit_event(self, event: Event) -> None:
        """Let something happen; from any thread."""
        self.context.emit_event_sync(event)

    def shutdown(self, force_sync: bool = False) -> None:
        """End the launch and its processes; from any thread."""
        del force_sync  # the event is worked on at once, either way
        if not self.context.is_shutdown:
            self.emit_event(Shutdown(reason="LaunchService.shutdown() called"))

    def run(self, *, shutdown_when_idle: bool = True) -> int:
        """Run until the launch has ended.

        Args:
            shutdown_when_idle: Whether it ends when nothing is left to wait for.

        Returns:
            The exit code: 1 if the launch failed, else 0. Of programs that died by themselves tells
            `context.program_failed`, as for launch they are no failure.
        """
        # asyncio.run() would take the thread's own loop away, which programs have plans for.
        loop = asyncio.new_event_loop()
        try:
            return loop.run_until_complete(self.run_async(shutdown_when_idle=shutdown_when_idle))
        finally:
            _close(loop)

    async def run_async(self, *, shutdown_when_idle: bool = True) -> int:
        """Run until the launch has ended; see `run`."""
        context, loop = self.context, asyncio.get_running_loop()
        journal = context.journal
        context.begin(loop)
        self.__task = asyncio.current_task(loop)
        self._interrupts = 0
        journal.info(self._logger_name, f"All log files can be found below {journal.folder}")
        level = "DEBUG" if journal.shows_debug else logging.getLevelName(launch_config.level)
        journal.info(self._logger_name, f"Default logging verbosity is set to {level}")
        stay = None if shutdown_when_idle else loop.create_future()
        if stay is not None:
            context.add_completion_future(stay)
        try:
            with self._signals(loop):
                await self._work(stay)
        finally:
            context.close()
        return int(context.failed)

    async def _work(self, stay: asyncio.Future[None] | None) -> None:
        while True:
            event = await self.context.next_event()
            if event is None and self.context.is_shutdown:
                return
            self._process(event or Shutdown(reason="idle"))
            if self.context.is_shutdown and stay is not None and not stay.done():
                stay.set_result(None)

    def _process(self, event: Event) -> None:
        context = self.context
        if isinstance(event, Shutdown):
            context.is_shutdown = True
            context.journal.debug(self._logger_name, f"shutdown: {event.reason}")
        for handler in context.event_handlers:
            if handler.matches(event):
                depth = context.depth
                context.extend_locals({**context.locals_of(handler), "event": event})
                try:
                    self._handle(lambda one=handler: one.handle(event, context))  # type: ignore[misc]
                finally:
                    context.cut(depth)

    def _handle(self, function: Callable[[], Sequence[LaunchDescriptionEntity]]) -> None:
        depth = self.context.depth
        try:
            for entity in function():
                self._visit(entity)
        except Exception as error:  # noqa: BLE001 - a launch file's mistakes end the launch in order
            self.context.cut(depth)
            self.context.fail(error)

    def _visit(self, entity: LaunchDescriptionEntity) -> None:
        try:
            following = entity.visit(self.context)
        except LaunchFileError:
            raise
        except Exception as error:
            origin = getattr(entity, "origin", None)
            if origin is None:
                raise
            raise LaunchFileError.at(origin, error) from error
        future = entity.get_asyncio_future()
        if future is not None:
            self.context.add_completion_future(future)
        for one in following or ():
            self._visit(one)

    @contextlib.contextmanager
    def _signals(self, loop: asyncio.AbstractEventLoop) -> Iterator[None]:
        """Let Ctrl-C and SIGTERM end the launch in order."""
        if threading.current_thread() is not threading.main_thread():
            yield  # Python lets no other thread handle signals
            return
        names = ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT")
        with AsyncSafeSignalManager(loop) as manager:
            for number in [getattr(signal, name) for name in names if hasattr(signal, name)]:
                manager.handle(number, self._interrupt)
            yield

    def _interrupt(self, number: int) -> None:
        self._interrupts += 1
        warn, name = self.context.journal.warning, signal.Signals(number).name
        if self._interrupts > 1:
            warn(
                self._logger_name,
                f"user interrupted again ({name}): processes get the next signal now",
            )
            self.emit_event(TimerSkipped())
        elif number == signal.SIGINT:
            warn(self._logger_name, "user interrupted with ctrl-c (SIGINT)")
            self.emit_event(Shutdown(reason="ctrl-c (SIGINT)", due_to_sigint=True))
        else:
            warn(self._logger_name, f"the launch was told to end ({name})")
            self.emit_event(Shutdown(reason=name))


def _close(loop: asyncio.AbstractEventLoop) -> None:
    """Close a loop after what still runs in it."""
    tasks = asyncio.all_tasks(loop)
    for task in tasks:
        task.cancel()
    try:
        loop.run_until_complete(asyncio.wait(tasks) if tasks else asyncio.sleep(0))
        loop.run_until_complete(loop.shutdown_asyncgens())
        loop.run_until_complete(loop.shutdown_default_executor())
    finally:
        loop.close()
