"""Launch service, which visits entities and handles events until the launch ends."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import signal
import sys
import threading
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.launch.context import LaunchContext
from zbot.launch.errors import LaunchFileError
from zbot.launch.event import IncludeLaunchDescriptionEvent, SecondInterrupt, Shutdown
from zbot.launch.event_handler import OnIncludeLaunchDescription
from zbot.launch.log import launch_config
from zbot.launch.not_runnable import leave_out, missing_file
from zbot.launch.signal_manager import AsyncSafeSignalManager
from zbot.package.absent import absent_packages_reported
from zbot.package.errors import NotRunnableError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

    from zbot.launch.description import LaunchDescription
    from zbot.launch.entity import LaunchDescriptionEntity, Origin
    from zbot.launch.event import Event
    from zbot.launch.event_handler import BaseEventHandler

#: Errors of launch files. A function of a launch file may call `sys.exit`, as xacro does.
_ERRORS = (Exception, SystemExit)
_END_S = 2.0  #: longest wait for tasks that were cancelled


class _InterruptedError(KeyboardInterrupt):
    """A signal ends the visit of an entity, e.g. the code of a launch file that takes long."""


class LaunchService:
    """Runs launch descriptions.

    Args:
        argv: Arguments of the launch, which are also in `context.argv`.
        noninteractive: Whether processes always get a pipe as stdin. Otherwise they get the
            terminal of the launch, if there is a terminal.
        debug: Whether debug lines are shown.
        log_file_name: The name of the launch's log file. The launch's logger has the same name
            without `.log`.
        find_program: Function that is called with package and executable before a node starts. The
            function raises an error if the executable does not exist.
        strict: Whether the launch fails if something in it cannot run in zbot. Otherwise the
            launch logs a warning and continues.
    """

    def __init__(
        self,
        *,
        argv: Sequence[str] | None = None,
        noninteractive: bool = False,
        debug: bool = False,
        log_file_name: str | None = None,
        find_program: Callable[[str, str], object] | None = None,
        strict: bool = False,
    ) -> None:
        self._logger_name = (log_file_name or "launch").removesuffix(".log")
        self._log_file_name = f"{self._logger_name}.log"
        if log_file_name is not None:
            launch_config.log_file_name = self._log_file_name
        self.__context = LaunchContext(
            argv=argv,
            noninteractive=noninteractive,
            find_program=find_program,
            debug=debug,
            strict=strict,
        )
        self.__context.register_event_handler(OnIncludeLaunchDescription())
        self.__task: asyncio.Task[Any] | None = None
        self._interrupts = 0
        self._is_visiting = False
        self._interrupted_by = 0  #: signal that ended a visit and is not handled yet

    @property
    def context(self) -> LaunchContext:
        """The state of the launch."""
        return self.__context

    @property
    def event_loop(self) -> asyncio.AbstractEventLoop | None:
        """The event loop of the launch, or None while the launch does not run."""
        return self.__context.asyncio_loop

    @property
    def task(self) -> asyncio.Task[Any] | None:
        """The task of the last run."""
        return self.__task

    def _is_idle(self) -> bool:
        # Tests of launch_pytest use this private name.
        return self.context.is_idle

    def include_launch_description(self, launch_description: LaunchDescription) -> None:
        """Launch a description, now or when the service runs. Any thread may call this method."""
        self.emit_event(IncludeLaunchDescriptionEvent(launch_description))

    def emit_event(self, event: Event) -> None:
        """Emit an event. Any thread may call this method."""
        self.context.emit_event_sync(event)

    def shutdown(self, force_sync: bool = False) -> None:
        """End the launch and its processes. Any thread may call this method."""
        del force_sync  # has no effect: the event is always put into the queue
        if not self.context.is_shutdown:
            self.emit_event(Shutdown(reason="LaunchService.shutdown() called"))

    def run(self, *, shutdown_when_idle: bool = True) -> int:
        """Run until the launch has ended.

        Args:
            shutdown_when_idle: Whether the launch ends when it has nothing left to wait for.

        Returns:
            The exit code, which is 1 if the launch failed and otherwise 0. As in ROS 2, the launch
            does not fail if a program exits with an error. But `context.program_failed` is true
            after such an exit.
        """
        # asyncio.run() would remove the thread's event loop, which the program may still use.
        loop = asyncio.new_event_loop()
        try:
            return loop.run_until_complete(self.run_async(shutdown_when_idle=shutdown_when_idle))
        finally:
            _close(loop)

    async def run_async(self, *, shutdown_when_idle: bool = True) -> int:
        """Run until the launch has ended. See `run`."""
        context, loop = self.context, asyncio.get_running_loop()
        writer = context.writer
        context.begin(loop)
        self.__task = asyncio.current_task(loop)
        self._interrupts = self._interrupted_by = 0
        if writer.folder is not None:
            writer.info(self._logger_name, f"All log files can be found below {writer.folder}")
        level = "DEBUG" if writer.shows_debug else logging.getLevelName(launch_config.level)
        writer.info(self._logger_name, f"Default logging verbosity is set to {level}")
        keep_running = None if shutdown_when_idle else loop.create_future()
        if keep_running is not None:
            context.add_completion_future(keep_running)
        try:
            with self._signals(loop), absent_packages_reported(partial(leave_out, context)):
                await self._work(keep_running)
        finally:
            context.close()
        return int(context.failed)

    async def _work(self, keep_running: asyncio.Future[None] | None) -> None:
        while True:
            event = await self.context.next_event()
            if event is None and self.context.is_shutdown:
                return
            self._process(event or Shutdown(reason="idle"))
            if self.context.is_shutdown and keep_running is not None and not keep_running.done():
                keep_running.set_result(None)

    def _process(self, event: Event) -> None:
        context = self.context
        if isinstance(event, Shutdown):
            context.is_shutdown = True
            context.writer.debug(self._logger_name, f"shutdown: {event.reason}")
        for handler in context.event_handlers:
            if self._matches(handler, event):
                depth = context.locals_depth
                context.extend_locals({**context.locals_of(handler), "event": event})
                try:
                    self._handle(lambda one=handler: one.handle(event, context))  # type: ignore[misc]
                finally:
                    context.truncate_locals(depth)

    def _matches(self, handler: BaseEventHandler, event: Event) -> bool:
        try:
            return handler.matches(event)
        except _ERRORS as error:  # of the launch file's own matcher
            with contextlib.suppress(ValueError):
                self.context.unregister_event_handler(handler)  # it would fail at each event
            self.context.fail(error)
            return False

    def _handle(self, function: Callable[[], Sequence[LaunchDescriptionEntity]]) -> None:
        depth = self.context.locals_depth
        try:
            for entity in function():
                self._visit_interruptibly(entity)
        except _InterruptedError:
            self.context.truncate_locals(depth)
        except _ERRORS as error:  # errors in launch files end the launch
            self.context.truncate_locals(depth)
            self.context.fail(error)
        if self._interrupted_by:  # also if the code of a launch file has caught the error
            number, self._interrupted_by = self._interrupted_by, 0
            self._interrupt(number)

    def _visit_interruptibly(self, entity: LaunchDescriptionEntity) -> None:
        self._is_visiting = True
        try:
            self._visit(entity)
        finally:
            self._is_visiting = False

    def _interruption(self, number: int) -> BaseException | None:
        """Return the error that a signal raises in the code that runs now, or None.

        The programs of a launch start when the visit of all entities has ended. So no program is
        left behind.
        """
        if not self._is_visiting:
            return None
        self._is_visiting = False
        self._interrupted_by = number
        return _InterruptedError()

    def _visit(self, entity: LaunchDescriptionEntity) -> None:
        if self._interrupted_by or (self._interrupts and not self.context.is_shutdown):
            return
        origin = getattr(entity, "origin", None)
        try:
            following = self._following(entity, origin)
        except LaunchFileError:
            raise
        except _ERRORS as error:
            if origin is None:
                raise
            from zbot.launch.python_file import located  # noqa: PLC0415 - only for mistakes

            raise located(Path(origin.path), error, origin.line) from error
        future = entity.get_asyncio_future()
        if future is not None:
            self.context.add_completion_future(future)
        for following_entity in following:
            self._visit(following_entity)

    def _following(
        self, entity: LaunchDescriptionEntity, origin: Origin | None
    ) -> Iterable[LaunchDescriptionEntity]:
        stdout = sys.stdout
        try:
            return entity.visit(self.context) or ()
        except NotRunnableError as error:
            leave_out(self.context, error, origin)
        except _InterruptedError:
            sys.stdout = stdout
            raise
        except _ERRORS as error:
            sys.stdout = stdout  # a call of `xacro.process` that fails leaves another stdout
            absent = missing_file(error)
            if absent is None or origin is None:  # the command line has no origin
                raise
            leave_out(self.context, absent, origin)
        return ()

    @contextlib.contextmanager
    def _signals(self, loop: asyncio.AbstractEventLoop) -> Iterator[None]:
        """Shut the launch down at Ctrl-C, SIGTERM, SIGHUP and SIGQUIT."""
        if threading.current_thread() is not threading.main_thread():
            yield  # Python handles signals only in the main thread
            return
        names = ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT")
        with AsyncSafeSignalManager(loop, self._interruption) as manager:
            for number in [getattr(signal, name) for name in names if hasattr(signal, name)]:
                manager.handle(number, self._interrupt)
            yield

    def _interrupt(self, number: int) -> None:
        self._interrupts += 1
        warn, name = self.context.writer.warning, signal.Signals(number).name
        if self._interrupts > 1:
            warn(
                self._logger_name,
                f"user interrupted again ({name}): processes get the next signal now",
            )
            self.emit_event(SecondInterrupt())
        elif number == signal.SIGINT:
            warn(self._logger_name, "user interrupted with ctrl-c (SIGINT)")
            self.emit_event(Shutdown(reason="ctrl-c (SIGINT)", due_to_sigint=True))
        else:
            warn(self._logger_name, f"the launch was asked to end ({name})")
            self.emit_event(Shutdown(reason=name))


def _close(loop: asyncio.AbstractEventLoop) -> None:
    tasks = asyncio.all_tasks(loop)
    for task in tasks:
        task.cancel()
    try:
        if tasks:
            loop.run_until_complete(asyncio.wait(tasks, timeout=_END_S))
        loop.run_until_complete(loop.shutdown_asyncgens())
        loop.run_until_complete(loop.shutdown_default_executor())
    finally:
        loop.close()
