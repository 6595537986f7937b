"""State of a running launch, e.g. configurations, environment, event handlers, event queue."""

from __future__ import annotations

import asyncio
import queue
import threading
import traceback
from collections import deque
from functools import cached_property
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.launch.environment import Environment
from zbot.launch.errors import (
    LaunchUsageError,
    SubstitutionError,
    describe,
)
from zbot.launch.event import Shutdown
from zbot.launch.log_writer import LogWriter
from zbot.launch.process_group import ProcessGroups

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Mapping, Sequence

    from zbot.launch.event import Event
    from zbot.launch.event_handler import BaseEventHandler
    from zbot.launch.substitution import Substitution


class _Locals:
    """Names that are defined only while the launch processes one event or one included file."""

    _values: Mapping[str, Any]

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.__dict__["_values"] = values

    def __getattr__(self, name: str) -> Any:
        try:
            return self._values[name]
        except KeyError:
            known = ", ".join(self._values) or "none"
            raise AttributeError(f"no local '{name}' here; known locals: {known}") from None

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"local '{name}' cannot be assigned: use extend_locals()")


class LaunchContext:
    """The state of one launch.

    Args:
        argv: The arguments of the launch.
        noninteractive: Whether processes always get a pipe as stdin. Otherwise they get the
            terminal of the launch, if there is a terminal.
        find_program: Function that is called with package and executable before a node starts. The
            function raises an error if the executable does not exist.
        debug: Whether debug lines are shown.
        strict: Whether the launch fails if something in it cannot run in zbot.
    """

    def __init__(
        self,
        *,
        argv: Sequence[str] | None = None,
        noninteractive: bool = False,
        find_program: Callable[[str, str], object] | None = None,
        debug: bool = False,
        strict: bool = False,
    ) -> None:
        self.argv = list(argv or ())
        self.debug, self.strict = debug, strict
        self.noninteractive = noninteractive
        self.find_program = find_program
        self._environment = Environment()
        self.launch_configurations: dict[str, Any] = {}
        self.declared: set[str] = set()  #: names of arguments that files declare
        self.is_shutdown = False
        self.failed = False  #: whether an error occurred, so that the exit code is 1
        self.program_failed = False  #: whether a program exited with an error by itself
        self._saved: list[tuple[str, dict[str, Any]]] = []
        self._locals: list[dict[str, Any]] = []
        self._globals: dict[str, Any] = {}
        self._marks: list[int] = []
        self._event_handlers: deque[BaseEventHandler] = deque()
        self._locals_of: dict[BaseEventHandler, dict[str, Any]] = {}
        self._event_queue: queue.SimpleQueue[Event] = queue.SimpleQueue()
        self._pending: set[asyncio.Future[Any]] = set()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._wake: asyncio.Event | None = None
        self._thread: threading.Thread | None = None
        self._labels = 0
        self._closers: list[Callable[[], object]] = []

    # Methods for substitutions

    def perform_substitution(self, substitution: Substitution) -> str:
        """Return the text of a substitution.

        Raises:
            SubstitutionError: `perform` of the substitution does not return a string.
        """
        text = substitution.perform(self)
        if not isinstance(text, str):
            what = substitution.describe()
            raise SubstitutionError(
                f"{what} must become a str, not {type(text).__name__}: {text!r}"
            )
        return text

    def get_locals_as_dict(self) -> dict[str, Any]:
        """Return globals and locals. A new local replaces an older local of the same name."""
        return {**self._globals, **self._inner_locals()}

    def _inner_locals(self) -> dict[str, Any]:
        return {key: value for extension in self._locals for key, value in extension.items()}

    @property
    def locals(self) -> _Locals:
        """The locals as attributes of one object."""
        return _Locals(self.get_locals_as_dict())

    def extend_globals(self, extensions: Mapping[str, Any]) -> None:
        """Set names that stay defined until the launch ends."""
        self._globals.update(extensions)

    def extend_locals(self, extensions: Mapping[str, Any]) -> None:
        """Add locals to the present locals, until `pop_locals` removes them."""
        self._locals.append(dict(extensions))

    def pop_locals(self) -> None:
        """Remove the locals that the last `extend_locals` set."""
        self._locals.pop()

    @property
    def locals_depth(self) -> int:
        """Number of `extend_locals` calls that are still in effect."""
        return len(self._locals)

    def truncate_locals(self, depth: int) -> None:
        """Undo `extend_locals` calls until `depth` calls are left."""
        del self._locals[depth:]

    # Scopes

    @property
    def environment(self) -> Environment:
        """The environment of the programs, which is that of this process."""
        return self._environment

    @environment.setter
    def environment(self, variables: Mapping[str, str]) -> None:
        self._environment.replace(variables)

    def push(self, kind: str) -> None:
        """Save the `environment` or the `launch_configurations` for a later `pop`."""
        self._saved.append((kind, dict(getattr(self, kind))))

    def pop(self, kind: str) -> None:
        """Restore the values that the last `push` of the same kind saved."""
        for index in range(len(self._saved) - 1, -1, -1):
            if self._saved[index][0] == kind:
                setattr(self, kind, self._saved.pop(index)[1])
                return

    # Events

    def register_event_handler(self, event_handler: BaseEventHandler, append: bool = False) -> None:
        """Register a handler. It is called before the other handlers, or with `append` after them.

        The actions of the handler get the present locals. So `ThisLaunchFile` in these actions is
        the file that registered the handler.
        """
        self._locals_of[event_handler] = self._inner_locals()
        if append:
            self._event_handlers.append(event_handler)
        else:
            self._event_handlers.appendleft(event_handler)

    def unregister_event_handler(self, event_handler: BaseEventHandler) -> None:
        """Remove a handler, so that it gets no more events.

        Raises:
            LaunchUsageError: The handler is not registered.
        """
        if event_handler not in self._event_handlers:
            raise LaunchUsageError(f"this event handler is not registered: {event_handler!r}")
        self._event_handlers.remove(event_handler)
        self._locals_of.pop(event_handler, None)

    def locals_of(self, event_handler: BaseEventHandler) -> dict[str, Any]:
        """Return the locals at the time when a handler was registered."""
        return self._locals_of.get(event_handler, {})

    @property
    def event_handlers(self) -> tuple[BaseEventHandler, ...]:
        """The registered handlers, in the order in which they are called."""
        return tuple(self._event_handlers)

    def would_handle_event(self, event: Event) -> bool:
        """Return whether a registered handler matches an event."""
        return any(handler.matches(event) for handler in self._event_handlers)

    def emit_event_sync(self, event: Event) -> None:
        """Put an event at the end of the queue. Any thread may call this method."""
        if self._loop is None or threading.current_thread() is self._thread:
            self._emit(event)
        else:
            self._loop.call_soon_threadsafe(self._emit, event)

    async def emit_event(self, event: Event) -> None:
        """Put an event at the end of the queue."""
        self._emit(event)

    def _emit(self, event: Event) -> None:
        self._event_queue.put(event)
        self.wake()

    def fail(self, error: BaseException) -> None:
        """Log an error, and shut the launch down with exit code 1."""
        text = str(error) if isinstance(error, ZbotError) else describe(error)
        hint = getattr(error, "hint", "")
        self.writer.error("launch", f"{text} ({hint})" if hint else text)
        trace = traceback.format_exception(type(error), error, error.__traceback__)
        self.writer.debug("launch", "".join(trace))
        self.failed = True
        if not self.is_shutdown:
            self.emit_event_sync(Shutdown(reason=text))

    # Methods for the `LaunchService` that runs this launch

    def begin(self, loop: asyncio.AbstractEventLoop) -> None:
        """Begin a run, which processes its events in this loop. Reset the flags of the last run."""
        self._loop, self._wake = loop, asyncio.Event()
        self._thread = threading.current_thread()
        self.is_shutdown = self.failed = False

    def wake(self) -> None:
        """Wake the `LaunchService`, so that it checks for events and finished futures."""
        if self._wake is not None:
            self._wake.set()

    async def next_event(self) -> Event | None:
        """Wait for the next event and return it. Return None if the launch is idle."""
        while self._event_queue.empty():
            if self._wake is None or not self._pending:
                return None
            self._wake.clear()
            await self._wake.wait()
        return self._event_queue.get_nowait()

    def add_completion_future(self, future: asyncio.Future[Any]) -> None:
        """Keep the launch running until a future is done."""
        if not future.done():
            self._pending.add(future)
            future.add_done_callback(self._on_future_done)

    def _on_future_done(self, future: asyncio.Future[Any]) -> None:
        self._pending.discard(future)
        if not future.cancelled() and (error := future.exception()) is not None:
            self.fail(error)
        self.wake()

    @property
    def pending(self) -> frozenset[asyncio.Future[Any]]:
        """The futures that the launch still waits for."""
        return frozenset(self._pending)

    @property
    def is_idle(self) -> bool:
        """Whether no event is queued and no future is pending."""
        return self._event_queue.empty() and not self._pending

    def create_task(self, coroutine: Coroutine[Any, Any, Any]) -> asyncio.Task[Any]:
        """Run a coroutine in the launch's loop. The launch waits for the end of the coroutine."""
        task = self.running_loop.create_task(coroutine)
        self.add_completion_future(task)
        return task

    @property
    def asyncio_loop(self) -> asyncio.AbstractEventLoop | None:
        """The event loop of the launch, or None while the launch does not run."""
        return self._loop

    @property
    def running_loop(self) -> asyncio.AbstractEventLoop:
        """The event loop of the launch.

        Raises:
            SubstitutionError: The launch does not run.
        """
        if self._loop is None:
            raise SubstitutionError("this launch is not running yet")
        return self._loop

    @cached_property
    def writer(self) -> LogWriter:
        """Writer of the launch's log lines. The first use creates it."""
        writer = LogWriter(debug=self.debug)
        self.on_close(writer.close)
        return writer

    @cached_property
    def process_groups(self) -> ProcessGroups:
        """The process groups of this launch. The first use creates them."""
        process_groups = ProcessGroups()
        self.on_close(process_groups.close)
        return process_groups

    def next_label(self, name: str) -> str:
        """Return a new label for a process, e.g. `talker-1`."""
        self._labels += 1
        return f"{name}-{self._labels}"

    def on_close(self, function: Callable[[], object]) -> None:
        """Register a function to call when the launch has ended.

        The function that was registered last is called first.
        """
        self._closers.append(function)

    def close(self) -> None:
        """Release the resources of the launch. A second call does nothing."""
        while self._closers:
            self._closers.pop()()
        self._environment.undo()
        self._loop = self._wake = self._thread = None
        for held in ("writer", "process_groups"):  # a second run creates them again
            self.__dict__.pop(held, None)

    # ROS 2's LaunchContext has methods with these private names. The tests of ROS 2 and the actions
    # of other packages call them.

    def _set_asyncio_loop(self, loop: asyncio.AbstractEventLoop | None) -> None:
        self._loop = loop
        self._thread = threading.current_thread()

    def _set_is_shutdown(self, state: bool) -> None:
        self.is_shutdown = state

    def _push_locals(self) -> None:
        self._marks.append(len(self._locals))

    def _pop_locals(self) -> None:
        if not self._marks:
            raise LaunchUsageError("no locals were pushed that could be popped")
        self.truncate_locals(self._marks.pop())

    def _push_launch_configurations(self) -> None:
        self.push("launch_configurations")

    def _pop_launch_configurations(self) -> None:
        self._pop_pushed("launch_configurations")

    def _push_environment(self) -> None:
        self.push("environment")

    def _pop_environment(self) -> None:
        self._pop_pushed("environment")

    def _pop_pushed(self, kind: str) -> None:
        if not any(saved == kind for saved, _ in self._saved):
            what = kind.replace("_", " ")
            raise LaunchUsageError(f"no {what} were pushed that could be popped")
        self.pop(kind)
