"""Tests of the moment in which a router gets a new session."""

from __future__ import annotations

import time
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest
import zenoh

from tests.conftest import wait_until
from zbot.transport import router_renewal
from zbot.transport.router_renewal import RouterRenewal

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

LIMIT = 20


class Router:
    """Takes the place of a router's session, and counts the requests for a new one."""

    def __init__(self) -> None:
        self.count = 0
        self.kinds: list[zenoh.WhatAmI] = []  #: of the linked programs
        info = SimpleNamespace(transports=self.transports)
        session: Any = SimpleNamespace(liveliness=lambda: self, info=info)
        self.renewal = RouterRenewal(session, self.renew, 3 * LIMIT)

    def declare_subscriber(self, *_: object) -> None:
        """Declare nothing: the test itself gives the tokens."""

    def transports(self) -> list[SimpleNamespace]:
        return [SimpleNamespace(whatami=kind) for kind in self.kinds]

    def renew(self) -> None:
        self.count += 1

    def end_tokens(self, count: int, name: str = "token") -> None:
        for number in range(count):
            self.renewal.note(f"{name}{number}", appeared=True)
            self.renewal.note(f"{name}{number}", appeared=False)


@pytest.fixture
def router(monkeypatch: pytest.MonkeyPatch) -> Iterator[Router]:
    monkeypatch.setattr(router_renewal, "_QUIET_PART", 1 / 3)
    monkeypatch.setattr(router_renewal, "_QUIET_S", 0.05)
    monkeypatch.setattr(router_renewal, "_QUIET_SHARE", 100.0)
    made = Router()
    yield made
    made.renewal.end()


def test_a_quiet_router_is_renewed_once_after_many_tokens(router: Router) -> None:
    router.end_tokens(LIMIT)
    assert wait_until(lambda: router.count == 1)
    router.end_tokens(LIMIT, "other")
    router.renewal.end()
    assert router.count == 1


def test_tokens_that_come_again_cost_nothing(router: Router) -> None:
    for _ in range(5):
        router.end_tokens(LIMIT - 1)
    router.renewal.end()
    assert router.count == 0


def test_a_router_is_renewed_if_two_threads_pass_the_limit_together(router: Router) -> None:
    router.renewal._ended.update(range(LIMIT))  # the other thread has not counted its tokens yet
    router.end_tokens(2)
    assert wait_until(lambda: router.count == 1)


class Pauses:
    """Takes the place of the event that ends a renewal. Something happens during each wait."""

    def __init__(self, during: Callable[[], object]) -> None:
        self.count = 0
        self._during = during

    def wait(self, _timeout_s: float) -> bool:
        self.count += 1
        self._during()
        return False

    def set(self) -> None:
        """Do nothing: the renewal ends by itself."""


def test_a_router_whose_tokens_come_and_go_is_renewed_only_at_the_last_limit(
    router: Router, monkeypatch: pytest.MonkeyPatch
) -> None:
    pauses = Pauses(lambda: router.end_tokens(1, f"more{pauses.count}-"))
    monkeypatch.setattr(router.renewal, "_is_over", pauses)
    router.end_tokens(LIMIT)
    assert wait_until(lambda: router.count == 1)
    assert pauses.count == 2 * LIMIT


def test_a_router_with_clients_is_renewed_when_they_have_left(
    router: Router, monkeypatch: pytest.MonkeyPatch
) -> None:
    def leave() -> None:
        if pauses.count == 5:
            router.kinds.remove(zenoh.WhatAmI.CLIENT)

    router.kinds += [zenoh.WhatAmI.PEER, zenoh.WhatAmI.CLIENT]
    pauses = Pauses(leave)
    monkeypatch.setattr(router.renewal, "_is_over", pauses)
    router.end_tokens(5 * LIMIT)
    assert wait_until(lambda: router.count == 1)
    assert pauses.count == 5


def test_a_router_with_clients_is_renewed_after_very_many_tokens(
    router: Router, monkeypatch: pytest.MonkeyPatch
) -> None:
    router.kinds.append(zenoh.WhatAmI.CLIENT)
    pauses = Pauses(lambda: router.end_tokens(1, f"more{pauses.count}-"))
    monkeypatch.setattr(router_renewal, "CLASS_LIMIT", 4 * LIMIT)
    monkeypatch.setattr(router.renewal, "_is_over", pauses)
    router.end_tokens(LIMIT)
    assert wait_until(lambda: router.count == 1)
    assert pauses.count == 3 * LIMIT


def test_a_router_that_works_is_renewed_in_the_first_quiet_moment(
    router: Router, monkeypatch: pytest.MonkeyPatch
) -> None:
    used_s = [0.0]

    def work() -> None:
        used_s[0] += 1.0 if pauses.count < 5 else 0.0

    pauses = Pauses(work)
    monkeypatch.setattr(router_renewal, "_QUIET_SHARE", 0.1)
    monkeypatch.setattr(router.renewal, "_is_over", pauses)
    monkeypatch.setattr(time, "process_time", lambda: used_s[0])
    router.end_tokens(LIMIT)
    assert wait_until(lambda: router.count == 1)
    assert pauses.count == 5


def test_a_router_that_ends_is_not_renewed(router: Router, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(router_renewal, "_QUIET_SHARE", 0.0)
    router.end_tokens(LIMIT)
    router.renewal.end()
    assert router.count == 0
