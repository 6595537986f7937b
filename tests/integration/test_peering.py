"""Tests of the links between the sessions of a domain, and of sessions that introduce them."""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import zenoh

import zbot
from tests.conftest import allowed, wait_until
from zbot.transport import admin_query, config
from zbot.transport.peering import Peering
from zbot.transport.process_facts import process_facts
from zbot.transport.session import MeetingPoint

if TYPE_CHECKING:
    from tests.conftest import MakeContext

pytestmark = pytest.mark.own_dialect("ROS 2 has a router that the user starts, and no meeting port")


def test_waiting_ends_when_the_session_is_closed(domain: int) -> None:
    point = MeetingPoint(config.load(), domain, config.discovery_range(), process_facts("0"))
    session = point.open_node_session()
    watch = Peering(session, point, zenoh.handlers.Callback)
    session.close()
    begin = time.monotonic()
    assert not watch.wait_for_answers(60)
    assert time.monotonic() - begin < allowed(5)
    point.close()


def test_a_check_ends_when_the_session_is_closed_meanwhile(
    domain: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    point = MeetingPoint(config.load(), domain, config.discovery_range(), process_facts("0"))
    point.start_router()
    session = point.open_node_session()
    watch = Peering(session, point, zenoh.handlers.Callback)
    assert watch.wait_for_router(allowed(5))
    routers = watch._routers()
    monkeypatch.setattr(watch, "_routers", lambda: routers)  # as they were before the end
    session.close()
    assert watch._check() is None
    point.close()


@pytest.mark.skipif(sys.platform != "linux", reason="needs Linux's list of descriptors")
def test_a_session_that_introduces_peers_leaves_no_open_file(
    domain: int, make_context: MakeContext
) -> None:
    node = zbot.Node("node", context=make_context())
    point = MeetingPoint(config.load(), domain, config.discovery_range(), {})
    counts = []
    for _ in range(6):
        with point.open_introducer() as session:
            assert wait_until(lambda: bool(list(session.info.peers_zid())))
        # On a busy machine, a link may stay half open (docs/design/zenoh-faults.md).
        wait_until(lambda: not list(node.context.session.info.peers_zid()), 2)
        counts.append(len(list(Path("/proc/self/fd").iterdir())))
    assert counts[-1] < counts[0] + 4  # each kept one
    point.close()


def test_peers_of_a_router_that_answers_late_are_found(
    domain: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    def late(session: zenoh.Session, _router: str, timeout_s: float) -> dict[str, str]:
        return {str(session.info.zid()): "peer", "1": "peer"} if timeout_s > 0.5 else {}

    point = MeetingPoint(config.load(), domain, config.discovery_range(), process_facts("0"))
    point.start_router()
    session = point.open_node_session()
    watch = Peering(session, point, zenoh.handlers.Callback)
    assert watch.wait_for_router(allowed(5))
    introduced: list[bool] = []
    monkeypatch.setattr(admin_query, "sessions", late)
    monkeypatch.setattr(watch, "_introduce", lambda: introduced.append(True))
    assert watch._check() is not None
    assert introduced == [True]
    monkeypatch.setattr(MeetingPoint, "uses_port", False)  # as with routers of ROS 2
    assert watch.unreachable() == {"1"}
    session.close()
    point.close()
