"""Carry frames between pairs of interfaces, late and not all of them: netem for kernels without it.

Run: relay.py DELAY_MS JITTER_MS LOSS ONE:OTHER ...

Each frame waits DELAY_MS plus or minus up to JITTER_MS, so frames overtake each other as behind
netem, and LOSS of them (0 to 1) vanish, in each direction. What TCP makes of that is the kernel's
own doing. Prints `relaying` when it does.
"""

from __future__ import annotations

import heapq
import itertools
import random
import selectors
import socket
import sys
import time

assert sys.platform == "linux"  # other systems have no AF_PACKET

_ALL_PROTOCOLS = 0x0003
_SOL_PACKET = 263
_VNET_HEADER = 15  # PACKET_VNET_HDR: checksums and segments that the kernel still has to make
_IGNORE_OUTGOING = 23  # PACKET_IGNORE_OUTGOING: what we send is not to be carried back
_LARGEST_FRAME = 70_000
_LONGEST_QUEUE = 1000  # frames, netem's own default


def open_interface(name: str) -> socket.socket:
    opened = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(_ALL_PROTOCOLS))
    opened.setsockopt(_SOL_PACKET, _VNET_HEADER, 1)
    opened.setsockopt(_SOL_PACKET, _IGNORE_OUTGOING, 1)
    opened.bind((name, _ALL_PROTOCOLS))
    opened.setblocking(False)
    return opened


class Relay:
    """Frames on their way, ordered by the time at which they arrive."""

    def __init__(self, delay_s: float, jitter_s: float, loss: float) -> None:
        self._delay_s, self._jitter_s, self._loss = delay_s, jitter_s, loss
        self._selector = selectors.DefaultSelector()
        self._under_way: list[tuple[float, int, socket.socket, bytes]] = []
        self._order = itertools.count()
        self._dice = random.Random(1)

    def connect(self, one: socket.socket, other: socket.socket) -> None:
        self._selector.register(one, selectors.EVENT_READ, (one, other))
        self._selector.register(other, selectors.EVENT_READ, (other, one))

    def run(self) -> None:
        while True:
            next_s = self._under_way[0][0] - time.monotonic() if self._under_way else None
            for key, _ in self._selector.select(next_s if next_s is None else max(0, next_s)):
                self._take(*key.data)
            self._deliver()

    def _take(self, source: socket.socket, target: socket.socket) -> None:
        while True:
            try:
                frame = source.recv(_LARGEST_FRAME)
            except BlockingIOError:
                return
            if self._dice.random() < self._loss or len(self._under_way) >= _LONGEST_QUEUE:
                continue
            late_s = self._delay_s + self._dice.uniform(-self._jitter_s, self._jitter_s)
            entry = (time.monotonic() + late_s, next(self._order), target, frame)
            heapq.heappush(self._under_way, entry)

    def _deliver(self) -> None:
        while self._under_way and self._under_way[0][0] <= time.monotonic():
            _, _, target, frame = heapq.heappop(self._under_way)
            try:
                target.send(frame)
            except (BlockingIOError, OSError):  # full, or its interface is down: lost
                continue


def main() -> None:
    delay_ms, jitter_ms, loss = map(float, sys.argv[1:4])
    relay = Relay(delay_ms / 1000, jitter_ms / 1000, loss)
    for pair in sys.argv[4:]:
        one, other = map(open_interface, pair.split(":"))
        relay.connect(one, other)
    print("relaying", flush=True)
    relay.run()


if __name__ == "__main__":
    main()
