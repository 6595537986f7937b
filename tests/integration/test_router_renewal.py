"""Tests of routers that get a new session after many tokens have ended."""

from __future__ import annotations

import os
import sys
import threading
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.classroom.talk import free_port
from tests.cli.command import zbot as zbot_command
from tests.conftest import allowed, wait_until
from tests.torture.processes import memory_mb
from zbot.classroom.hub import process as hub_process
from zbot.classroom.hub.process import HubProcess
from zbot.classroom.hub.router import HubSettings, open_router
from zbot.classroom.teacher.student import user_of
from zbot.classroom.teacher.student_number import NUMBERS
from zbot.memory import give_back_freed_memory
from zbot.security.access import teacher_access
from zbot.transport import __main__ as router_program
from zbot.transport import background_process, membership, router_process, router_renewal

from std_msgs.msg import Int64

if TYPE_CHECKING:
    from collections.abc import Iterator

    import zenoh

    from tests.conftest import MakeContext, Spin

pytestmark = pytest.mark.own_dialect("ROS 2 has a router that the user starts")

LIMIT = 20


@pytest.fixture(autouse=True)
def low_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(router_renewal, "_QUIET_PART", LIMIT / router_renewal.MACHINE_LIMIT)
    monkeypatch.setattr(router_renewal, "_QUIET_SHARE", 100.0)  # this process also does other work


@pytest.fixture
def domain(free_domain: int, monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """Return a domain whose router's program runs in a thread of this process."""
    monkeypatch.setattr(sys, "argv", ["router", str(free_domain)])
    codes: list[int] = []
    membership.folder().mkdir(parents=True, exist_ok=True)
    with background_process.lock_path(f"router-{free_domain}").open("w") as file:
        assert background_process.lock(file)
        thread = threading.Thread(target=lambda: codes.append(router_program.main()))
        thread.start()
        yield free_domain
        thread.join(allowed(20))
    assert codes == [0]


def spend(session: zenoh.Session, count: int) -> None:
    """Declare tokens, and remove them again."""
    for number in range(count):
        token = session.liveliness().declare_token(f"@zbot/0/a/{number}/{number}/NN/%/%/visitor")
        token.undeclare()


def routers(node: zbot.Node) -> set[str]:
    return set(map(str, node.context.session.info.routers_zid()))


def test_the_router_of_a_domain_gets_a_new_session(
    make_context: MakeContext, spin: Spin, domain: int
) -> None:
    talker = zbot.Node("talker", context=make_context())
    listener = zbot.Node("listener", context=make_context())
    received: list[int] = []
    listener.create_subscription(
        Int64, "numbers", lambda message: received.append(message.data), 100
    )
    publisher = talker.create_publisher(Int64, "numbers", 10)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    spin(listener)
    before = routers(talker)
    assert len(before) == 1
    os.utime(background_process.lock_path(f"router-{domain}"), (0, 0))
    spend(talker.context.session, LIMIT)
    count = 0
    while not (routers(talker) and routers(listener) and not routers(talker) & before):
        publisher.publish(Int64(data=count))
        count += 1
        assert wait_until(lambda: len(received) == count)  # noqa: B023 - called in this turn
    assert received == list(range(count))
    assert router_process.age_s(domain) < 60  # a young router is not ended if it does not answer
    done = zbot_command("node", "list")
    assert done.code == 0
    assert sorted(done.out.split()) == ["/listener", "/talker"]


def test_the_hub_of_a_machine_gets_a_new_session_right_after_the_router(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(hub_process, "MACHINE_LIMIT", 4 * LIMIT)
    # A hub of one machine dials another hub.
    endpoint = f"tcp/127.0.0.1:{free_port()}"
    settings = HubSettings((endpoint,), ("tcp/127.0.0.1:1",))
    asked = threading.Event()
    hub = HubProcess(open_router(settings), settings, asked.set)

    def link_router() -> None:
        router = open_router(HubSettings(("tcp/127.0.0.1:0",), (endpoint,)))
        assert wait_until(lambda: bool(list(hub.session.info.routers_zid())))
        router.close()
        assert wait_until(lambda: not list(hub.session.info.routers_zid()))

    def spend_noted(count: int) -> None:
        spend(hub.session, count)
        # A thread notes the ends later.
        assert wait_until(lambda: len(hub._renewal._ended) == count)

    spend_noted(LIMIT - 1)
    spend_noted(LIMIT - 1)
    link_router()
    assert not asked.is_set()
    spend_noted(LIMIT)
    assert not asked.is_set()
    link_router()
    assert asked.wait(allowed(10))
    hub.close()


@pytest.mark.skipif(sys.platform != "linux", reason="needs Linux's list of processes")
def test_a_hub_that_is_opened_again_needs_no_more_memory() -> None:
    students = {user_of(number): number for number in NUMBERS}
    settings = HubSettings(("tcp/127.0.0.1:0",), extra=teacher_access(students))
    used_mb = []
    for _ in range(5):
        open_router(settings).close()
        give_back_freed_memory()
        used_mb.append(memory_mb(os.getpid()))
    assert used_mb[-1] < used_mb[0] + 20  # 60 MB, if the configurations were kept
