"""State of a context, from `init()` to `shutdown()`, and what runs when it ends."""

from __future__ import annotations

import contextlib
import os
import threading
from typing import TYPE_CHECKING, Literal

from zbot.errors import ArgumentTypeError, ForkedProcessError, WrongStateError
from zbot.process import signals
from zbot.threads.foreign_call import defers_signals

if TYPE_CHECKING:
    from collections.abc import Callable


class ContextState:
    """State of a context. The subclass has the session. Any thread may call the methods."""

    def __init__(self) -> None:
        self._lock = threading.RLock()
        self._state: Literal["new", "valid", "shut down"] = "new"
        self._interrupted = False
        self.is_inherited = False  #: whether the parent of this forked process opened the session
        self._process: int | None = None  # id of the process that called `init`
        self._wakers: list[Callable[[], None]] = []
        self._on_shutdown: list[Callable[[], object]] = []

    def close(self) -> None:
        """Close the session."""
        raise NotImplementedError

    def _require_new(self) -> None:
        if self._state != "new":
            raise WrongStateError(
                "Context.init() must only be called once: call shutdown() before another init()"
            )

    def _begin(self) -> None:
        self._state, self._process = "valid", os.getpid()

    def ok(self) -> bool:
        """Return whether the context is initialised, not shut down, and not interrupted.

        If SIGTERM interrupted the context and the main thread calls this, the program is expected
        to end on its own. Otherwise the signal ends it after 3 s.
        """
        if self._state == "valid" and not self._interrupted:
            return True
        signals.note_look()
        return False

    @property
    def is_running(self) -> bool:
        """Whether `ok()` is true. zbot reads this, because a call of `ok()` has an effect."""
        return self._state == "valid" and not self._interrupted

    @property
    def is_valid(self) -> bool:
        """Whether the context is initialised and not shut down. It may be interrupted."""
        return self._state == "valid"

    @property
    def is_over(self) -> bool:
        """Whether the context was shut down. Such a context cannot be initialised again."""
        return self._state == "shut down"

    @property
    def is_of_parent(self) -> bool:
        """Whether the parent of this forked process has initialised the context."""
        return self._state == "valid" and self._process != os.getpid()

    @property
    def is_interrupted(self) -> bool:
        """Whether a signal interrupted the context."""
        return self._interrupted

    def interrupt(self) -> None:
        """Let all `spin` calls return. Publishing stays possible until `shutdown()`."""
        self._interrupted = True
        self._wake()

    def shutdown(self) -> None:
        """Close the session and all its entities. The second call does nothing."""
        with self._lock:
            if self._state != "valid":
                return
            self._state = "shut down"
            callbacks, self._on_shutdown = self._on_shutdown, []
        self._wake()
        with contextlib.ExitStack() as stack:  # an exception of one does not skip the others
            stack.callback(self.close)
            for callback in reversed(callbacks):
                stack.callback(callback)

    def try_shutdown(self) -> None:
        """Shut down if the context is not shut down yet."""
        self.shutdown()

    def destroy(self) -> None:
        """Shut down."""
        self.shutdown()

    def on_shutdown(self, callback: Callable[[], object]) -> None:
        """Add a callback that `shutdown()` calls first. Callbacks may be added before `init()`.

        Raises:
            ArgumentTypeError: The callback is not a function.
        """
        if not callable(callback):
            raise ArgumentTypeError("callback", "a function", callback)
        self._on_shutdown.append(callback)

    def add_waker(self, waker: Callable[[], None]) -> None:
        """Add a function that lets a waiting thread check `ok()` again. It must return quickly."""
        with self._lock:
            self._wakers.append(waker)

    def remove_waker(self, waker: Callable[[], None]) -> None:
        """Remove a function that was given to `add_waker`. Do nothing if it was not given."""
        with self._lock:
            if waker in self._wakers:
                self._wakers.remove(waker)

    @defers_signals
    def _wake(self) -> None:
        for waker in list(self._wakers):
            waker()

    def require_valid(self, what: str) -> None:
        """Check that the context is initialised and not shut down.

        Args:
            what: The subject of the error's sentence.

        Raises:
            ForkedProcessError: The context belongs to the parent of this forked process.
            NotInitializedError: The context is not initialised, or it was shut down.
        """
        if self.is_inherited:
            raise ForkedProcessError(what)
        if self._state != "valid":
            signals.raise_not_initialized(what)

    def leave_to_parent(self) -> None:
        """In a forked child, leave the session and all entities to the parent process.

        As in rclpy, `ok()` is still true, and `shutdown()` and `destroy_node()` have no effect on
        the parent. All that needs the session raises a `ForkedProcessError`.
        """
        self.is_inherited = True
        self._lock = threading.RLock()  # a thread of the parent may hold the old lock
        self._wakers = []
