"""Budget of each client of a server: what it may hold, send and use.

All limits of the page, of rosbridge and of the server for Foxglove are here. Programs of these
kinds that do useful work stay far below them. A client that exceeds a limit is told so, and other
clients do not notice it.
"""

from __future__ import annotations

import time
from collections import Counter
from typing import TYPE_CHECKING

from zbot.errors import ZbotError

if TYPE_CHECKING:
    from collections.abc import Callable

#: Clients of one server. A class of 30 students with three windows each has 90.
MAX_CLIENTS = 100
#: Clients of one other machine, so that a machine cannot keep the others away.
MAX_CLIENTS_OF_MACHINE = 50
#: Topics that one client publishes on. 20,000 publishers need 125 MB, and zbot shows the graph
#: slowly with them. A page for a robot has some tens, and a window for each topic some hundreds.
MAX_PUBLISHED = 500
#: Topics that one client receives. Foxglove receives the topics that its panels show.
MAX_SUBSCRIBED = 1000
#: Calls of services that wait for an answer.
MAX_CALLS = 200
#: Threads of a server that one client may use at the same time for calls that ask other nodes.
MAX_THREADS = 4
#: Size of one message. A picture of 2000 * 2000 pixels has 12 MB.
MAX_MESSAGE_BYTES = 16 * 1024 * 1024
#: Memory of the values that a message in JSON leaves out, besides 64 bytes for each of its bytes.
MAX_DEFAULT_BYTES = 2**20
#: Bytes of messages that wait for a client that reads slowly. Beyond this, the oldest are dropped.
#: `foxglove_bridge` has 10 MB (`send_buffer_limit`).
MAX_WAITING_BYTES = 6_000_000
#: Bytes of answers that wait, which are never dropped. Two maps of 2000 * 2000 cells have 8 MB.
MAX_ANSWER_BYTES = 10_000_000
#: Messages a second. A gamepad sends 60. A program may send twice as many at once, e.g. when it
#: starts and names its topics.
MESSAGES_PER_S = 1000
#: Bytes a second: pictures of 1 MB, 30 times a second.
BYTES_PER_S = 32_000_000
#: Requests a second that ask all nodes, e.g. for their parameters. Foxglove sends one at the start.
REQUESTS_PER_S = 10
#: Share of one processor that the messages of a client may use. After that, the client waits.
WORK_SHARE = 0.25
_BURST_S = 2.0
_REPORT_S = 1.0
_LONGEST_WAIT_S = 1.0


class OverBudgetError(ZbotError):
    """A client wants more than its share. The client gets the text of this error."""


class Clients:
    """Clients of one server. Only one thread may call the methods.

    Args:
        most: The largest number of clients.
        most_of_machine: The largest number of clients of one other machine.
    """

    def __init__(
        self, most: int = MAX_CLIENTS, most_of_machine: int = MAX_CLIENTS_OF_MACHINE
    ) -> None:
        self._most, self._most_of_machine = most, most_of_machine
        self._machines = Counter[str]()

    def add(self, machine: str) -> None:
        """Count a new client.

        Args:
            machine: The address of the other machine, or an empty text for this machine.

        Raises:
            OverBudgetError: There are too many clients already.
        """
        if self._machines.total() >= self._most:
            raise OverBudgetError(
                f"there are {self._most} clients already: close one of them first"
            )
        if machine and self._machines[machine] >= self._most_of_machine:
            raise OverBudgetError(f"{machine} has {self._most_of_machine} clients already")
        self._machines[machine] += 1

    def remove(self, machine: str) -> None:
        """Forget a client."""
        self._machines[machine] -= 1
        if not self._machines[machine]:
            del self._machines[machine]


class Rate:
    """Amount a second that may be used. What was not used for a while may be used at once.

    Args:
        per_s: The amount a second.
        burst_s: The seconds whose amount may be used at once.
        clock: Returns the time in seconds.
    """

    def __init__(
        self,
        per_s: float,
        burst_s: float = _BURST_S,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._per_s = per_s
        self._clock = clock
        self._left = self._most = per_s * burst_s
        self._at_s = clock()

    def take(self, amount: float) -> bool:
        """Use an amount, and return True. If too little is left, use nothing, and return False."""
        self._refill()
        # A single amount that is larger than the burst is possible if nothing else was used.
        if self._left < min(amount, self._most):
            return False
        self._left -= amount
        return True

    def use(self, amount: float) -> None:
        """Use an amount, even if it is not left."""
        self._refill()
        self._left -= amount

    @property
    def delay_s(self) -> float:
        """The time until something is left, in seconds."""
        self._refill()
        return max(0.0, -self._left / self._per_s)

    def _refill(self) -> None:
        now_s = self._clock()
        self._left = min(self._left + (now_s - self._at_s) * self._per_s, self._most)
        self._at_s = now_s


class ClientBudget:
    """What one client may still send. Only one thread at a time may call the methods.

    Args:
        clock: Returns the time in seconds.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._messages = Rate(MESSAGES_PER_S, clock=clock)
        self._bytes = Rate(BYTES_PER_S, clock=clock)
        self._requests = Rate(REQUESTS_PER_S, clock=clock)
        self._work = Rate(WORK_SHARE, clock=clock)
        self._refused = 0
        self._reported_s = -_REPORT_S

    def check_message(self, size: int) -> None:
        """Count a message of the client.

        Raises:
            OverBudgetError: The client sends too much, so the message must be ignored. The text is
                empty if the client was told so less than a second ago.
        """
        if not self._messages.take(1):
            self._refuse(f"{MESSAGES_PER_S} messages")
        if not self._bytes.take(size):
            self._refuse(f"{BYTES_PER_S} bytes")

    def check_request(self) -> None:
        """Count a request that asks many nodes. Raise the error of `check_message`."""
        if not self._requests.take(1):
            self._refuse(f"{REQUESTS_PER_S} requests to all nodes")

    def _refuse(self, limit: str) -> None:
        self._refused += 1
        now_s = self._clock()
        if now_s - self._reported_s < _REPORT_S:
            raise OverBudgetError("")
        self._reported_s = now_s
        raise OverBudgetError(
            f"you send more than {limit} a second: {self._refused} of your messages were ignored"
        )

    @staticmethod
    def refusal_pause_s(size: int) -> float:
        """Return the time to wait after a message that was refused, in seconds.

        It also takes time to receive such a message. So a client that sends ten times too much gets
        no more turns than one that sends a little too much.
        """
        return max(1 / MESSAGES_PER_S, size / BYTES_PER_S)

    def note_work(self, seconds: float) -> float:
        """Note the time of a processor that a message needed.

        Returns:
            The seconds to wait before the next message of the client, at most 1. The server does
            not notice the end of a client while it waits.
        """
        self._work.use(seconds)
        return min(self._work.delay_s, _LONGEST_WAIT_S)
