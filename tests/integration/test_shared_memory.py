"""Tests of large messages in shared memory between real sessions."""

from __future__ import annotations

import os
import sys
from array import array
from collections import deque
from functools import partial
from itertools import accumulate, pairwise
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import wait_until
from zbot.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from zbot.transport import shared_memory, zenoh_session

from nav_msgs.srv import LoadMap
from std_msgs.msg import UInt8MultiArray

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext, Spin, Start

MEGABYTE = 1_000_000
KEEP_ALL = QoSProfile(history=HistoryPolicy.KEEP_ALL)
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)

pytestmark = [
    pytest.mark.own_dialect("ROS 2's sessions use shared memory only if a file says so"),
    pytest.mark.skipif(
        isinstance(shared_memory.place(b"x"), bytes), reason="this system gives no shared memory"
    ),
]


@pytest.fixture(autouse=True)
def _young_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the tests be the first in their process, because only its first sessions share memory."""
    monkeypatch.setattr(zenoh_session._Library, "opened", 0)


@pytest.fixture
def placed(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Return a list with the length of each payload that is put into shared memory."""
    lengths: list[int] = []

    def place(payload: bytes) -> object:
        block = original(payload)
        if block is not payload:
            lengths.append(len(payload))
        return block

    original = shared_memory.place
    monkeypatch.setattr(shared_memory, "place", place)
    return lengths


def image(seed: int) -> UInt8MultiArray:
    return UInt8MultiArray(data=array("B", bytes([seed]) * MEGABYTE))


def has(got: list[UInt8MultiArray], count: int) -> bool:
    return len(got) == count


def send(
    make_context: MakeContext, spin: Spin, profile: QoSProfile, *bursts: int
) -> list[UInt8MultiArray]:
    """Send bursts of numbered messages; the subscription keeps the first one during its burst."""
    talker = zbot.Node("talker", context=make_context())
    listener = zbot.Node("listener", context=make_context())
    got: list[UInt8MultiArray] = []
    listener.create_subscription(UInt8MultiArray, "images", got.append, profile)
    publisher = talker.create_publisher(UInt8MultiArray, "images", profile)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    for first, end in pairwise([0, *accumulate(bursts)]):
        for seed in range(first, end):
            publisher.publish(image(seed))
        if first == 0:
            spin(listener)
        assert wait_until(partial(has, got, end))
    return got


def test_messages_larger_than_the_pool_arrive(
    make_context: MakeContext, spin: Spin, placed: list[int]
) -> None:
    got = send(make_context, spin, KEEP_ALL, 40)

    assert got == [image(seed) for seed in range(40)]
    assert 0 < len(placed) < 40  # the others were sent without shared memory


def test_blocks_come_back_from_readers(
    make_context: MakeContext, spin: Spin, placed: list[int]
) -> None:
    send(make_context, spin, KEEP_ALL, 12, 12, 12)

    assert len(placed) == 36


def test_latched_messages_are_not_put_into_the_pool(
    make_context: MakeContext, spin: Spin, placed: list[int]
) -> None:
    assert send(make_context, spin, LATCHED, 1) == [image(0)]
    assert not placed


def test_a_configuration_can_disable_shared_memory(
    make_context: MakeContext,
    spin: Spin,
    placed: list[int],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    settings = tmp_path / "zenoh.json5"
    settings.write_text("{ transport: { shared_memory: { enabled: false } } }", encoding="utf-8")
    monkeypatch.setenv("ZBOT_CONFIG", str(settings))

    assert send(make_context, spin, KEEP_ALL, 2) == [image(0), image(1)]
    assert not placed


def test_messages_of_a_program_that_ends_at_once_arrive(
    make_context: MakeContext, spin: Spin, start: Start
) -> None:
    listener = zbot.Node("listener", context=make_context())
    got: list[UInt8MultiArray] = []
    listener.create_subscription(UInt8MultiArray, "images", got.append, KEEP_ALL)
    spin(listener)
    source = """
import array, zbot
from std_msgs.msg import UInt8MultiArray
with zbot.init():
    node = zbot.Node("brief")
    publisher = node.create_publisher(UInt8MultiArray, "images", 10)
    for seed in range(3):
        publisher.publish(UInt8MultiArray(data=array.array("B", bytes([seed]) * 1_000_000)))
"""
    start(source=source)

    assert wait_until(lambda: len(got) == 3)
    assert got == [image(seed) for seed in range(3)]


def test_large_requests_and_responses_use_shared_memory(
    make_context: MakeContext, spin: Spin, placed: list[int]
) -> None:
    server = zbot.Node("server", context=make_context())
    client_node = zbot.Node("client", context=make_context())

    def answer(request: LoadMap.Request, response: LoadMap.Response) -> LoadMap.Response:
        response.map.data = array("b", request.map_url.encode())
        return response

    server.create_service(LoadMap, "load", answer)
    spin(server)
    client = client_node.create_client(LoadMap, "load")
    assert client.wait_for_service(5)

    url = "ab" * (MEGABYTE // 2)
    response = client.call(LoadMap.Request(map_url=url))

    assert response is not None
    assert response.map.data.tobytes() == url.encode()
    assert len(placed) == 2


@pytest.mark.skipif(sys.platform != "linux", reason="Linux tells what is mapped")
def test_graph_queries_allocate_no_message_pool(domain: int, start: Start) -> None:
    source = f"""
import zbot
for number in range(16):
    context = zbot.Context()
    context.init([], domain_id={domain})
    zbot.Node(f"node_{{number}}", context=context)
context.wait_for_discovery()
sizes = []
for line in open("/proc/self/maps"):
    if ".zenoh" in line:
        first, last = line.split()[0].split("-")
        sizes.append(int(last, 16) - int(first, 16))
print(max(sizes) < 8_000_000, max(sizes))
zbot.shutdown()
"""
    start(source=source).wait_for("True")


# Each of the first pools loses its files, as if another program of Zenoh had removed them.
LOSING = """
from pathlib import Path
import zenoh.shm
from zbot.transport import shared_memory

make, made = zenoh.shm.ShmProvider.default_backend, []

class Provider:
    @staticmethod
    def default_backend(size):
        pool = make(size)
        made.append(size)
        if len(made) <= LOSSES:
            for area in Path("/proc/self/maps").read_text().splitlines():
                if area.endswith(".zenoh"):
                    Path(area.split()[-1]).unlink()
        return pool

zenoh.shm.ShmProvider = Provider
payload = bytes(1_000_000)
print("is shared:", [shared_memory.place(payload) is not payload for _ in range(2)])
print("pools:", len(made))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere, Zenoh removes no files of others")
@pytest.mark.parametrize(
    ("losses", "is_shared", "pools"), [(0, True, 1), (1, True, 2), (9, False, 4)]
)
def test_a_pool_whose_file_another_program_removes_is_not_used(
    start: Start, losses: int, is_shared: bool, pools: int
) -> None:
    program = start(source=LOSING.replace("LOSSES", str(losses)))
    program.wait_for(f"is shared: {[is_shared, is_shared]}")
    program.wait_for(f"pools: {pools}")


def test_blocks_of_many_sizes_are_allocated() -> None:
    sizes = (1_000_014, 300_000, 1_000_037, 140_000, 2_000_000, 921_600)
    held: deque[object] = deque(maxlen=3)
    for size in sizes * 200:
        payload = bytes(size)
        held.append(shared_memory.place(payload))
        assert held[-1] is not payload


def test_a_block_replaces_several_freed_smaller_ones() -> None:
    held = [shared_memory.place(bytes(MEGABYTE)) for _ in range(20)]
    held.clear()
    payload = bytes(MEGABYTE + 1)

    assert shared_memory.place(payload) is not payload


def test_a_payload_too_large_for_the_pool_is_unchanged() -> None:
    payload = os.urandom(20 * MEGABYTE)

    assert shared_memory.place(payload) is payload
