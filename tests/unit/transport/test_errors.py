"""Tests of the errors about a port that another program uses."""

from __future__ import annotations

import pytest

from zbot.classroom.errors import hub_port_error
from zbot.transport.errors import router_port_error

_TAKEN = "cannot open the hub: Can not create a new TCP listener bound to tcp/0.0.0.0:7447: "
_LINUX = f"{_TAKEN}[0.0.0.0:7447: Address already in use (os error 98)"
_WINDOWS = f"{_TAKEN}[Only one usage of each socket address is permitted. (os error 10048)"


@pytest.mark.parametrize("reason", [_LINUX, _WINDOWS])
def test_a_taken_port_of_a_hub_is_one_sentence(reason: str) -> None:
    assert str(hub_port_error("tcp/0.0.0.0:7447", reason)) == (
        "cannot listen on tcp/0.0.0.0:7447, because another program of this machine uses the port, "
        "perhaps the hub of another user: stop that program, or choose another port, e.g. "
        "`zbot class start --port 7448` or `zbot hub --listen 0.0.0.0:7448`"
    )


def test_a_taken_port_of_a_router_is_one_sentence() -> None:
    assert str(router_port_error(["tcp/[::]:7447"], _LINUX)) == (
        "cannot listen on tcp/[::]:7447, because another program uses the port; if a router runs "
        "there already, it is enough: a machine needs one"
    )


def test_another_reason_is_shown() -> None:
    reason = "Cannot assign requested address (os error 99)"
    assert str(hub_port_error("tcp/192.0.2.1:7447", reason)) == (
        f"cannot listen on tcp/192.0.2.1:7447: {reason}"
    )
