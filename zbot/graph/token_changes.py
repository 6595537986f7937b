"""Changes of liveliness tokens, in the order in which Zenoh received them.

Zenoh's network threads put the changes into a queue of Zenoh, without Python. A second Zenoh
subscriber calls a function for each change, also in these threads. That function takes Python's
lock, so its calls may come in another order. It only starts the thread that empties the queue.
"""

from __future__ import annotations

import contextlib
import threading
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.threads.foreign_call import without_interruption
from zbot.threads.on_demand_thread import OnDemandThread
from zbot.transport import admin_query

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

# Zenoh may call the function a moment before it puts the change into the queue, and on a busy
# machine its thread may stop in between. So the queue is looked at again after these times.
_LATE_S = (0.01, 0.1, 1.0)


class TokenChanges:
    """Gives each change of followed tokens to a function.

    Args:
        session: The session that receives the tokens.
        use: Called with each change, in a thread that exists only while there are changes.
        receiver: Returns a Zenoh handler that calls a function (see `Context.receiver`).
        start_thread: Starts a thread with a name, a function, and a function that lets it end (see
            `Context.start_thread`).
    """

    def __init__(
        self,
        session: zenoh.Session,
        use: Callable[[zenoh.Sample], None],
        receiver: Callable[[Callable[[Any], object]], Any],
        start_thread: Callable[[str, Callable[[], None], Callable[[], object]], None],
    ) -> None:
        self._session = session
        self._use = use
        self._receiver = receiver
        self._subscribers: list[Any] = []  # Zenoh undeclares one that nobody refers to
        self._notifiers: list[Any] = []
        self._one_at_a_time = threading.RLock()  # a signal handler may catch up, too
        self._was_told = False
        self._late = iter(_LATE_S)
        self._start_thread = start_thread
        self._work = OnDemandThread(self._start, self._turn)

    def _start(self, run: Callable[[], None]) -> None:
        self._start_thread("zbot graph", run, self._work.end)

    def follow(self, key: str) -> None:
        """Receive the present tokens of a key expression, and their changes from now on."""
        with unless_closed(self._session):
            subscriber = declare_subscriber(self._session, key, admin_query.large_queue())
            self._subscribers.append(subscriber)
            tell = self._receiver(self._tell)
            self._notifiers.append(declare_subscriber(self._session, key, tell))
            self._tell(None)

    def catch_up(self) -> None:
        """Use the changes that have arrived, in this thread. Any thread may call this.

        A token arrives before the messages of its owner. So a caller that has such a message can
        call this, and then knows the token.
        """
        with self._one_at_a_time, unless_closed(self._session):
            for subscriber in list(self._subscribers):
                for change in iter(subscriber.handler.try_recv, None):
                    self._use(change)

    def close(self) -> None:
        """Follow no tokens any more. A change that comes meanwhile may still be used."""
        ended = [*self._subscribers, *self._notifiers]
        self._subscribers, self._notifiers = [], []
        for subscriber in ended:
            subscriber.undeclare()

    def _tell(self, _: object) -> None:
        self._was_told = True
        self._work.wake()

    def _turn(self) -> float | None:
        if self._was_told:
            self._was_told = False
            self._late = iter(_LATE_S)
        self.catch_up()
        if not self._subscribers or self._session.is_closed():
            return None
        return next(self._late, None)


@contextlib.contextmanager
def unless_closed(session: zenoh.Session) -> Iterator[None]:
    """Run a block that uses a session. If another thread closes the session, only end the block."""
    try:
        yield
    except zenoh.ZError:
        if not session.is_closed():
            raise


def declare_subscriber(session: zenoh.Session, key: str, handler: Any) -> Any:
    """Subscribe to the present liveliness tokens of a key expression, and to their changes."""
    subscribe = session.liveliness().declare_subscriber
    return without_interruption(subscribe, key, handler, history=True)
