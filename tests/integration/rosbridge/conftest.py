"""Session of rosbridge with a running system, and a node of the same domain."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot
from tests.integration.rosbridge.web_program import WebProgram
from zbot.observer.system import System
from zbot.web.rosbridge.bridge import Bridge

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


@pytest.fixture
def system(domain: int) -> Iterator[System]:
    with System(domain_id=domain) as system:
        yield system


@pytest.fixture
def web(system: System) -> Iterator[WebProgram]:
    bridge = Bridge(system)
    program = WebProgram(bridge)
    yield program
    program.dispatcher.close()
    bridge.close()


@pytest.fixture
def node(make_context: Callable[[], zbot.Context]) -> zbot.Node:
    return zbot.Node("robot", context=make_context())
