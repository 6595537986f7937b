"""What a launch knows while it runs: configurations, environment, handlers, the next event."""

from __future__ import annotations

import asyncio
import os
import queue
import threading
import traceback
from collections import deque
from functools import cached_property
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.launch.errors import (
    SubstitutionError,
    UnbalancedPopError,
    UnknownHandlerError,
    describe,
)
from zbot.launch.event import Shutdown
from zbot.launch.journal import Journal
from zbot.launch.process_group import ProcessGroup

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Mapping, Sequence

    from zbot.launch.event import Event
    from zbot.launch.event_handler import BaseEventHandler
    from zbot.launch.substitution import Substitution


class _Locals:
    """Names that hold only while one event, or one included file, is worked on."""

    _values: Mapping[str, Any]

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.__dict__["_values"] = values

    def __getattr__(self, name: str) -> Any:
        try:
            return self._values[name]
        except KeyError:
            known = ", ".join(self._values) or "none"
            raise AttributeError(f"no local '{name}' here; there are: {known}") from None

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"local '{name}' cannot be set here: use extend_locals()")


class LaunchContext:
    """The state of one launch.

    Args:
        argv: The arguments that the launch was given.
        noninteractive: Whether processes get no terminal to read from.
        find_program: Called with a package and an executable before a node is started; raises
            where there is none.
        debug: Whether debug lines are shown.
    """

    def __init__(
        self,
        *,
        argv: Sequence[str] | None = None,
        noninteractive: bool = False,
        find_program: Callable[[str, str], object] | None = None,
        debug: bool = False,
    ) -> None:
        self.argv = list(argv or ())
        self.debug = debug
        self.noninteractive = noninteractive
        self.find_program = find_program
        self.environment: dict[str, str] = dict(os.environ)
        self.launch_configurations: dict[str, Any] = {}
        self.is_shutdown = False
        self.failed = False  #: something went wrong that the exit code has to tell
        self.program_failed = False  #: a program died by itself, with an error
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

    # What substitutions ask for

    def perform_substitution(self, substitution: Substitution) -> str:
        """Return the text of a substitution.

        Raises:
            SubstitutionError: It has none.
        """
        text = substitution.perform(self)
        if not isinstance(text, str):
            what = substitution.describe()
            raise SubstitutionError(
                f"{what} must become a str, not {type(text).__name__}: {text!r}"
            )
        return text

    def get_locals_as_dict(self) -> dict[str, Any]:
        """Return the locals, the innermost first."""
        return {**self._globals, **self._inner_locals()}

    def _inner_locals(self) -> dict[str, Any]:
        return {key: value for extension in self._locals for key, value in extension.items()}

    @property
    def locals(self) -> _Locals:
        """The locals, as attributes."""
        return _Locals(self.get_locals_as_dict())

    def extend_globals(self, extensions: Mapping[str, Any]) -> None:
        """Set locals that hold until the launch ends."""
        self._globals.update(extensions)

    def extend_locals(self, extensions: Mapping[str, Any]) -> None:
        """Set locals on top of those that hold, until `pop_locals`."""
        self._locals.append(dict(extensions))

    def pop_locals(self) -> None:
        """Forget what the last `extend_locals` set."""
        self._locals.pop()

    @property
    def depth(self) -> int:
        """How many `extend_locals` are in force."""
        return len(self._locals)

    def cut(self, depth: int) -> None:
        """Forget what was set since there were so many."""
        del self._locals[depth:]

    # Scopes

    def push(self, kind: str) -> None:
        """Remember the `environment` or the `launch_configurations`, to return to them later."""
        self._saved.append((kind, dict(getattr(self, kind))))

    def pop(self, kind: str) -> None:
        """Return to what the last `push` of that kind remembered."""
        for index in range(len(self._saved) - 1, -1, -1):
            if self._saved[index][0] == kind:
                setattr(self, kind, self._saved.pop(index)[1])
                return

    # Events

    def register_event_handler(self, event_handler: BaseEventHandler, append: bool = False) -> None:
        """Let a handler see every event from now on; the newest sees them first.

        What it leads to has the locals of now: `ThisLaunchFile` means the file it stands in.
        """
        self._locals_of[event_handler] = self._inner_locals()
        if append:
            self._event_handlers.append(event_handler)
        else:
            self._event_handlers.appendleft(event_handler)

    def unregister_event_handler(self, event_handler: BaseEventHandler) -> None:
        """Let a handler see no more events.

        Raises:
            UnknownHandlerError: It saw none.
        """
        if event_handler not in self._event_handlers:
            raise UnknownHandlerError(event_handler)
        self._event_handlers.remove(event_handler)
        self._locals_of.pop(event_handler, None)

    def locals_of(self, event_handler: BaseEventHandler) -> dict[str, Any]:
        """Return the locals that held when a handler was registered."""
        return self._locals_of.get(event_handler, {})

    @property
    def event_handlers(self) -> tuple[BaseEventHandler, ...]:
        """Those registered, in the order in which they see an event."""
        return tuple(self._event_handlers)

    def would_handle_event(self, event: Event) -> bool:
        """Return whether anybody waits for such an event."""
        return any(handler.matches(event) for handler in self._event_handlers)

    def emit_event_sync(self, event: Event) -> None:
        """Put an event at the end of the queue; from any thread."""
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
        """Say what went wrong and end the launch, with exit code 1."""
        text = str(error) if isinstance(error, ZbotError) else describe(error)
        hint = getattr(error, "hint", "")
        self.journal.error("launch", f"{text} ({hint})" if hint else text)
        trace = traceback.format_exception(type(error), error, error.__traceback__)
        self.journal.debug("launch", "".join(trace))
        self.failed = True
        if not self.is_shutdown:
            self.emit_event_sync(Shutdown(reason=text))

    # For the service that runs this launch

    def begin(self, loop: asyncio.AbstractEventLoop) -> None:
        """Work on events in this loop from now on."""
        self._loop, self._wake = loop, asyncio.Event()
        self._thread = threading.current_thread()
        self.is_shutdown = self.failed = False

    def wake(self) -> None:
        """Let the service look at what changed."""
        if self._wake is not None:
            self._wake.set()

    async def next_event(self) -> Event | None:
        """Return the next event; None if none can come any more."""
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
            future.add_done_callback(self._forget)

    def _forget(self, future: asyncio.Future[Any]) -> None:
        self._pending.discard(future)
        if not future.cancelled() and (error := future.exception()) is not None:
            self.fail(error)
        self.wake()

    @property
    def pending(self) -> frozenset[asyncio.Future[Any]]:
        """What the launch still waits for."""
        return frozenset(self._pending)

    @property
    def is_idle(self) -> bool:
        """Whether nothing is left to happen and nothing to wait for."""
        return self._event_queue.empty() and not self._pending

    def create_task(self, coroutine: Coroutine[Any, Any, Any]) -> asyncio.Task[Any]:
        """Run a coroutine, and keep the launch running until it ends."""
        task = self.running_loop.create_task(coroutine)
        self.add_completion_future(task)
        return task

    @property
    def asyncio_loop(self) -> asyncio.AbstractEventLoop | None:
        """The loop that the launch runs in; None while it does not run."""
        return self._loop

    @property
    def running_loop(self) -> asyncio.AbstractEventLoop:
        """The loop that the launch runs in.

        Raises:
            SubstitutionError: It does not run.
        """
        if self._loop is None:
            raise SubstitutionError("this launch is not running yet")
        return self._loop

    @cached_property
    def journal(self) -> Journal:
        """Where lines are written to."""
        journal = Journal(debug=self.debug)
        self.on_close(journal.close)
        return journal

    @cached_property
    def family(self) -> ProcessGroup:
        """The processes of this launch."""
        family = ProcessGroup()
        self.on_close(family.close)
        return family

    def next_label(self, name: str) -> str:
        """Return the name that a process goes by: `talker-1`."""
        self._labels += 1
        return f"{name}-{self._labels}"

    def on_close(self, function: Callable[[], object]) -> None:
        """Have a function called when the launch has ended."""
        self._closers.append(function)

    def close(self) -> None:
        """Give back what the launch holds; may be called twice."""
        while self._closers:
            self._closers.pop()()
        self._loop = self._wake = self._thread = None
        for held in ("journal", "family"):  # made anew if it is run again
            self.__dict__.pop(held, None)

    # What launch calls these: its tests, and actions of other packages, use the names

    def _set_asyncio_loop(self, loop: asyncio.AbstractEventLoop | None) -> None:
        self._loop = loop
        self._thread = threading.current_thread()

    def _set_is_shutdown(self, state: bool) -> None:
        self.is_shutdown = state

    def _push_locals(self) -> None:
        self._marks.append(len(self._locals))

    def _pop_locals(self) -> None:
        if not self._marks:
            raise UnbalancedPopError("locals")
        self.cut(self._marks.pop())

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
            raise UnbalancedPopError(kind)
        self.pop(kind)
