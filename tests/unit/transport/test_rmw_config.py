"""Settings of sessions in ROS 2's dialect, and the variables that choose and change them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.transport import rmw_choice
from zbot.transport.config import SessionConfig, setting
from zbot.transport.errors import SettingError
from zbot.transport.rmw_choice import RMW_VARIABLE, RMW_ZENOH, dialect_of_rmw
from zbot.transport.rmw_config import RmwConfig, endpoints, is_local, router_attempts
from zbot.wire.dialect import CLASSROOM, NATIVE
from zbot.wire.rmw_zenoh import ROS2

if TYPE_CHECKING:
    from pathlib import Path

FILE = SessionConfig("x.json5", '{ metadata: { rmw_implementation: "rmw_zenoh_cpp" } }')


@pytest.fixture(autouse=True)
def no_choice(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.delenv(RMW_VARIABLE, raising=False)
    monkeypatch.chdir(tmp_path)


def test_the_dialect_is_zbots_own_by_default() -> None:
    assert dialect_of_rmw(None, in_class=False) is NATIVE
    assert dialect_of_rmw(None, in_class=True) is CLASSROOM


def test_argument_variable_and_file_choose_the_dialect_in_this_order(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert dialect_of_rmw(RMW_ZENOH, in_class=True) is ROS2
    assert dialect_of_rmw(None, in_class=False, file=FILE) is ROS2
    monkeypatch.setenv(RMW_VARIABLE, "rmw_zbot_zenoh")
    assert dialect_of_rmw(None, in_class=False, file=FILE) is NATIVE
    monkeypatch.setenv(RMW_VARIABLE, RMW_ZENOH)
    assert dialect_of_rmw(None, in_class=False) is ROS2
    assert dialect_of_rmw("rmw_zbot_zenoh", in_class=False) is NATIVE


def test_a_variable_for_another_middleware_of_ros_2_is_ignored(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv(RMW_VARIABLE, "rmw_fastrtps_cpp")
    assert dialect_of_rmw(None, in_class=False) is NATIVE


def test_an_unknown_middleware_is_refused_with_one_sentence() -> None:
    with pytest.raises(SettingError, match="choose rmw_zbot_zenoh or rmw_zenoh_cpp"):
        dialect_of_rmw("rmw_fastrtps_cpp", in_class=False)
    with pytest.raises(SettingError, match="'x'"):
        rmw_choice.known("x")


def test_the_settings_are_those_of_ros_2() -> None:
    built = RmwConfig().session({})
    assert setting(built, "mode") == "peer"
    assert endpoints(built, "connect/endpoints") == ["tcp/localhost:7447"]
    assert endpoints(built, "listen/endpoints") == ["tcp/localhost:0"]
    assert setting(built, "scouting/multicast/enabled") is False
    assert setting(built, "timestamping/enabled")["peer"] is True
    router = RmwConfig().router({"listen/endpoints": ["tcp/[::]:7447"]}, {})
    assert setting(router, "mode") == "router"
    assert setting(router, "routing/router/peers_failover_brokering") is False
    assert endpoints(router, "listen/endpoints") == ["tcp/[::]:7447"]


def test_the_variable_wins_over_the_file(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    file = tmp_path / "ros.json5"
    file.write_text('{ mode: "client", connect: { endpoints: ["tcp/a:1"] } }', encoding="utf-8")
    monkeypatch.setenv("ZENOH_SESSION_CONFIG_URI", str(file))
    assert endpoints(RmwConfig().session({}), "connect/endpoints") == ["tcp/a:1"]
    monkeypatch.setenv(
        "ZENOH_CONFIG_OVERRIDE", 'connect/endpoints=["tcp/b:2"]; scouting/multicast/enabled=true;'
    )
    config = RmwConfig()
    built = config.session({})
    assert endpoints(built, "connect/endpoints") == ["tcp/b:2"]
    assert setting(built, "scouting/multicast/enabled") is True
    assert setting(built, "mode") == "client"
    assert not config.names_mode
    assert setting(config.router({}, {}), "mode") == "router"


def test_the_router_has_a_file_of_its_own(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    file = tmp_path / "router.json5"
    file.write_text('{ listen: { endpoints: ["tcp/[::]:9"] } }', encoding="utf-8")
    monkeypatch.setenv("ZENOH_ROUTER_CONFIG_URI", str(file))
    fill = {"listen/endpoints": ["tcp/[::]:7447"]}
    assert endpoints(RmwConfig().router(fill, {}), "listen/endpoints") == ["tcp/[::]:9"]
    assert endpoints(RmwConfig().session({}), "listen/endpoints") == ["tcp/localhost:0"]


@pytest.mark.parametrize("text", ["mode", "=1", 'mode="pigeon"', "no/such/path=1"])
def test_an_invalid_override_is_refused_with_one_sentence(
    text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", text)
    with pytest.raises(SettingError, match="ZENOH_CONFIG_OVERRIDE"):
        RmwConfig().session({})


def test_a_file_that_does_not_exist_is_refused_with_one_sentence(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("ZENOH_SESSION_CONFIG_URI", "no/such/file")
    with pytest.raises(SettingError, match="no/such/file"):
        RmwConfig()


@pytest.mark.parametrize(("text", "number"), [("", 1), ("3", 3), ("0", None), ("-1", -1)])
def test_the_number_of_attempts_is_that_of_the_variable(
    text: str, number: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZENOH_ROUTER_CHECK_ATTEMPTS", text)
    assert router_attempts() == number


@pytest.mark.parametrize("text", ["x", "1.5", "--1", "9" * 20])
def test_a_number_of_attempts_that_is_no_number_is_refused(
    text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZENOH_ROUTER_CHECK_ATTEMPTS", text)
    with pytest.raises(SettingError):
        router_attempts()


@pytest.mark.parametrize(
    ("endpoint", "expected"),
    [
        ("tcp/localhost:7447", True),
        ("tcp/127.0.0.1:7447", True),
        ("tcp/[::1]:7447?x=1#iface=lo", True),
        ("unixsock-stream/tmp/a.sock", True),
        ("tcp/192.168.1.10:7447", False),
        ("tls/robot.local:7447", False),
    ],
)
def test_an_endpoint_of_this_machine_is_local(endpoint: str, expected: bool) -> None:
    assert is_local(endpoint) is expected
