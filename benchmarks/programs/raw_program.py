"""Programs of raw Zenoh, which the benchmark measures. Usage: raw_program.py ROLE OPTIONS-AS-JSON.

A session has the settings, and a message has the attachment, that zbot gives them. Messages are
received in one of these ways: `direct` is a function that Zenoh's network thread calls, `thread` is
a function that a thread of the Python binding calls, `channel` is a queue that the main thread
reads. With `wake`, the network thread wakes the main thread. With `poll`, the main thread never
sleeps.
"""

from __future__ import annotations

import os
import struct
import threading
import time
from functools import partial
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any

import zenoh
from zenoh.shm import ShmProvider

from program_control import (
    Delays,
    Tally,
    Trips,
    arguments,
    call_repeatedly,
    cpu,
    publish_for,
    serve,
    sleep_repeatedly,
)

if TYPE_CHECKING:
    from collections.abc import Callable

FACTS = struct.Struct("<qqB16s")  # docs/wire.md: number, time, length of the id, id
STAMP = struct.Struct("<q")
GID = bytes(range(16))
LARGE_BYTES = 128 * 1024  # from this size on, zbot writes messages into shared memory itself
POOL_BYTES = 16 * 1024 * 1024
ENDPOINT = f"tcp/127.0.0.1:{os.environ.get('BENCH_PORT', '0')}"
_PAUSE_S = 0.01
_DEPTH = 10  # of a usual topic
_yield = getattr(os, "sched_yield", partial(time.sleep, 0))


def open_session(*, listens: bool) -> zenoh.Session:
    own, other = ("listen", "connect") if listens else ("connect", "listen")
    settings = {
        "mode": '"peer"',
        "scouting/multicast/enabled": "false",
        f"{own}/endpoints": f'["{ENDPOINT}"]',
        f"{other}/endpoints": "[]",
        "connect/timeout_ms": "-1",
        "connect/retry": "{period_init_ms: 20, period_max_ms: 100}",
        # As in zbot/transport/session.py
        "adminspace/enabled": "true",
        "transport/link/tx/queue/congestion_control/block/wait_before_close": "60000000",
        "transport/link/tx/queue/congestion_control/drop/wait_before_drop": "100000",
        "transport/shared_memory/transport_optimization/messages": '["put"]',
    }
    config = zenoh.Config()
    for path, value in settings.items():
        config.insert_json5(path, value)
    return zenoh.open(config)


class Publisher:
    """Sends payloads as zbot does: numbered, and large ones in shared memory."""

    def __init__(self, session: zenoh.Session, key: str, *, blocks: bool, large: bool) -> None:
        control = zenoh.CongestionControl
        self.declared: Any = session.declare_publisher(
            key,
            encoding="application/x-msgpack;std_msgs/msg/UInt8MultiArray",
            reliability=zenoh.Reliability.RELIABLE,
            congestion_control=control.BLOCK if blocks else control.DROP,
        )
        self._number = 0
        self._pool = ShmProvider.default_backend(POOL_BYTES) if large else None

    def publish(self, payload: bytes) -> None:
        self._number = number = self._number + 1
        attachment = FACTS.pack(number, time.time_ns(), 16, GID)
        sent = payload if self._pool is None else self._placed(self._pool, payload)
        self.declared.put(sent, attachment=attachment)

    def _placed(self, pool: ShmProvider, payload: bytes) -> Any:
        block = _block(pool, len(payload))
        if block is None:
            pool.garbage_collect()
            pool.defragment()
            block = _block(pool, len(payload))
            if block is None:
                return payload
        block[0 : len(payload)] = payload
        return zenoh.ZBytes(block)

    def wait_for_subscriber(self) -> None:
        while not self.declared.matching_status.matching:
            time.sleep(_PAUSE_S)


def _block(pool: ShmProvider, size: int) -> Any:
    try:
        return pool.alloc(size)
    except zenoh.ZError:
        return None


class Reader:
    """Reads number, time and payload of each sample, and gives the payload to a function."""

    def __init__(self, use: Callable[[bytes], object]) -> None:
        self._use = use
        self._next = 1
        self.missing = 0

    def read(self, sample: zenoh.Sample) -> None:
        attachment = sample.attachment
        if attachment is not None:
            number = FACTS.unpack(attachment.to_bytes())[0]
            if number != self._next:
                self.missing += number - self._next
            self._next = number + 1
        self.read_payload(sample)

    def read_payload(self, sample: zenoh.Sample) -> None:
        self._use(sample.payload.to_bytes())


def receive(
    session: zenoh.Session,
    key: str,
    use: Callable[[bytes], object],
    way: str,
    queue: int,
    *,
    is_plain: bool = False,
) -> Callable[[Callable[[], bool]], None]:
    """Subscribe. Return a function that runs until another function returns true."""
    reader = Reader(use)
    read: Callable[[Any], None] = reader.read_payload if is_plain else reader.read
    if way == "wake":
        return _wake(session, key, read)
    if way in {"direct", "thread"}:
        handler = zenoh.handlers.Callback(read, indirect=way == "thread")
        subscriber: Any = session.declare_subscriber(key, handler)
        return partial(_sleep, subscriber)
    channel = session.declare_subscriber(key, zenoh.handlers.FifoChannel(queue))
    return partial(_poll if way == "poll" else _drain, channel, read)


def _wake(
    session: zenoh.Session, key: str, read: Callable[[Any], None]
) -> Callable[[Callable[[], bool]], None]:
    arrived: SimpleQueue[zenoh.Sample] = SimpleQueue()
    handler = zenoh.handlers.Callback(arrived.put, indirect=False)
    subscriber: Any = session.declare_subscriber(key, handler)

    def run(is_done: Callable[[], bool]) -> None:
        assert subscriber
        while not is_done():
            read(arrived.get())

    return run


def _sleep(_: object, is_done: Callable[[], bool]) -> None:
    while not is_done():
        time.sleep(_PAUSE_S)


def _drain(channel: Any, read: Callable[[Any], None], is_done: Callable[[], bool]) -> None:
    receive_now = channel.handler.try_recv
    while not is_done():
        read(channel.handler.recv())
        for sample in iter(receive_now, None):
            read(sample)


def _poll(channel: Any, read: Callable[[Any], None], is_done: Callable[[], bool]) -> None:
    receive_now = channel.handler.try_recv
    while not is_done():
        while (sample := receive_now()) is None:
            _yield()
        read(sample)


def never() -> bool:
    return False


def sink(session: zenoh.Session, size: int, way: str, queue: int) -> None:  # noqa: ARG001
    tally = Tally()
    run = receive(session, "flood", tally.count, way, queue)
    serve(tally.result)
    run(never)


def flood(session: zenoh.Session, size: int, seconds: float, rate: float = 0.0, **_: Any) -> None:
    publisher = Publisher(session, "flood", blocks=True, large=size >= LARGE_BYTES)
    publisher.wait_for_subscriber()
    publish_for(partial(publisher.publish, bytes(size)), seconds, rate)


def listener(session: zenoh.Session, way: str, *, is_plain: bool = False) -> None:
    delays = Delays()

    def note(payload: bytes) -> None:
        delays.note(STAMP.unpack(payload)[0])

    run = receive(session, "time", note, way, _DEPTH, is_plain=is_plain)
    serve(delays.result)
    run(never)


def talker(
    session: zenoh.Session, seconds: float, rate: float, *, is_plain: bool = False, **_: Any
) -> None:
    if is_plain:
        declared: Any = session.declare_publisher("time")
        publish: Callable[[bytes], None] = declared.put
        while not declared.matching_status.matching:
            time.sleep(_PAUSE_S)
    else:
        publisher = Publisher(session, "time", blocks=False, large=False)
        publish = publisher.publish
        publisher.wait_for_subscriber()
    publish_for(lambda: publish(STAMP.pack(time.monotonic_ns())), seconds, rate)


def echo(session: zenoh.Session, size: int, way: str, queue: int) -> None:
    publisher = Publisher(session, "pong", blocks=False, large=size >= LARGE_BYTES)
    run = receive(session, "ping", publisher.publish, way, queue)
    serve(cpu)
    run(never)


def ping(session: zenoh.Session, size: int, count: int, way: str, queue: int) -> None:
    publisher = Publisher(session, "ping", blocks=False, large=size >= LARGE_BYTES)
    done = threading.Event()
    trips = Trips(partial(publisher.publish, bytes(size)), count, done.set)
    run = receive(session, "pong", trips.end, way, queue)
    publisher.wait_for_subscriber()
    trips.begin()
    run(done.is_set)


def server(session: zenoh.Session, size: int, way: str) -> None:
    def answer(query: zenoh.Query) -> None:
        payload = query.payload
        if payload is not None:
            query.reply("add", payload.to_bytes()[:size])

    handler = zenoh.handlers.Callback(answer, indirect=way == "thread")
    declared = session.declare_queryable("add", handler, complete=True)
    _sleep(declared, never)


def caller(session: zenoh.Session, size: int, count: int, **_: Any) -> None:
    querier: Any = session.declare_querier("add")
    request = bytes(size)
    while not querier.matching_status.matching:
        time.sleep(_PAUSE_S)

    def call() -> None:
        for reply in querier.get(
            payload=request, attachment=FACTS.pack(1, time.time_ns(), 16, GID)
        ):
            if reply.ok is not None:
                reply.ok.payload.to_bytes()

    call_repeatedly(call, count)


def main() -> None:
    role, options = arguments()
    if role == "timer":
        sleep_repeatedly(**options)
        return
    if options.get("size", 0) >= LARGE_BYTES:
        bytes(32 * 1024 * 1024 - 8192)  # as zbot/memory.py: glibc keeps freed blocks
    roles = {
        role.__name__: role for role in (sink, flood, listener, talker, echo, ping, server, caller)
    }
    with open_session(listens=role in {"sink", "listener", "ping", "caller"}) as session:
        roles[role](session, **options)


if __name__ == "__main__":
    main()
