from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from zbot.errors import SetupError
from zbot.transport import config
from zbot.transport.config import DiscoveryRange, SessionConfig
from zbot.transport.errors import SettingError

NO_FILE = SessionConfig("nothing", "{}")


@pytest.fixture(autouse=True)
def elsewhere(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)


def set_all(monkeypatch: pytest.MonkeyPatch, variables: dict[str, str]) -> None:
    for name, value in variables.items():
        monkeypatch.setenv(name, value)


@pytest.mark.parametrize(
    ("given", "variables", "expected"),
    [
        (None, {}, 0),
        (None, {"ROS_DOMAIN_ID": "5"}, 5),
        (None, {"ZBOT_DOMAIN_ID": "7", "ROS_DOMAIN_ID": "5"}, 7),
        (None, {"ZBOT_DOMAIN_ID": "", "ROS_DOMAIN_ID": "5"}, 5),
        (None, {"ZBOT_DOMAIN_ID": " 232 "}, 232),
        (3, {"ZBOT_DOMAIN_ID": "7"}, 3),
        (0, {"ZBOT_DOMAIN_ID": "7"}, 0),
        (0, {"ZBOT_DOMAIN_ID": "nonsense"}, 0),
    ],
)
def test_the_domain_is_the_argument_or_the_first_variable(
    monkeypatch: pytest.MonkeyPatch, given: int | None, variables: dict[str, str], expected: int
) -> None:
    set_all(monkeypatch, variables)
    assert config.domain_id(given) == expected


@pytest.mark.parametrize("text", ["233", "-1", "seven", "1.5", "1e2", "0x10", "99999999999999999"])
def test_an_error_names_the_wrong_domain_variable(
    monkeypatch: pytest.MonkeyPatch, text: str
) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", text)
    with pytest.raises(SettingError, match=f"ROS_DOMAIN_ID is '{text}'.* 0 to 232") as raised:
        config.domain_id()
    assert isinstance(raised.value, (SetupError, ValueError))


@pytest.mark.parametrize("given", [-1, 233, 1.5, [1]])
def test_a_wrong_domain_argument_is_refused(given: Any) -> None:
    with pytest.raises(SettingError, match="domain_id"):
        config.domain_id(given)


@pytest.mark.parametrize(
    ("variables", "expected"),
    [
        ({}, DiscoveryRange.LOCALHOST),
        ({"ZBOT_DISCOVERY_RANGE": "subnet"}, DiscoveryRange.SUBNET),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "OFF"}, DiscoveryRange.OFF),
        ({"ROS_AUTOMATIC_DISCOVERY_RANGE": "SYSTEM_DEFAULT"}, DiscoveryRange.LOCALHOST),
        (
            {"ZBOT_DISCOVERY_RANGE": "LOCALHOST", "ROS_AUTOMATIC_DISCOVERY_RANGE": "OFF"},
            DiscoveryRange.LOCALHOST,
        ),
    ],
)
def test_the_range_is_the_first_variable(
    monkeypatch: pytest.MonkeyPatch, variables: dict[str, str], expected: DiscoveryRange
) -> None:
    set_all(monkeypatch, variables)
    assert config.discovery_range() is expected


def test_an_error_names_the_wrong_range(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ZBOT_DISCOVERY_RANGE", "WORLD")
    with pytest.raises(SettingError, match="ZBOT_DISCOVERY_RANGE is 'WORLD'"):
        config.discovery_range()


def test_configuration_files_are_found_in_order(monkeypatch: pytest.MonkeyPatch) -> None:
    assert config.load().source == "the packaged zenoh.json5"
    Path("zenoh.json5").write_text("{}", encoding="utf-8")
    assert config.load().source == "zenoh.json5"
    for variable in ("ZENOH_CONFIG", "ZBOT_CONFIG"):
        Path(f"{variable}.json5").write_text("{}", encoding="utf-8")
        monkeypatch.setenv(variable, f"{variable}.json5")
        assert config.load().source == f"{variable}.json5"


def test_a_named_file_must_exist(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ZBOT_CONFIG", "nowhere.json5")
    with pytest.raises(SettingError, match=r"nowhere\.json5: No such file or directory"):
        config.load()


def test_the_packaged_file_sets_nothing() -> None:
    packaged = config.load()
    assert packaged.build({}).get_json("mode") == NO_FILE.build({}).get_json("mode")


@pytest.mark.parametrize(
    ("text", "path", "fill", "expected"),
    [
        ("{}", "mode", "peer", "peer"),
        ('{ mode: "client" }', "mode", "peer", "client"),
        ("{}", "connect/endpoints", ["tcp/127.0.0.1:1"], ["tcp/127.0.0.1:1"]),
        (
            '{ connect: { endpoints: ["tcp/192.0.2.1:7447"] } }',
            "connect/endpoints",
            ["tcp/127.0.0.1:1"],
            ["tcp/192.0.2.1:7447"],
        ),
        ("{}", "adminspace/enabled", True, True),
        ("{ adminspace: { enabled: false } }", "adminspace/enabled", True, False),
        ("{ // adminspace\n }", "adminspace/enabled", True, True),
    ],
)
def test_a_value_in_the_file_has_priority(
    text: str, path: str, fill: object, expected: object
) -> None:
    built = SessionConfig("file", text).build({path: fill})
    assert json.loads(built.get_json(path)) == expected


def test_forced_values_have_priority_over_the_file() -> None:
    built = SessionConfig("file", '{ mode: "client" }').build({"mode": "peer"}, {"mode": "router"})
    assert json.loads(built.get_json("mode")) == "router"


@pytest.mark.parametrize("text", ["", "{", "nonsense", '{ mode: "captain" }', "{ unknown: 1 }"])
def test_an_error_names_the_file_that_is_not_a_configuration(text: str) -> None:
    with pytest.raises(SettingError, match=r"configuration f\.json5: ") as raised:
        SessionConfig("f.json5", text).build({})
    assert "\n" not in str(raised.value)


def test_an_id_for_all_sessions_is_refused() -> None:
    with pytest.raises(SettingError, match="remove `id`"):
        SessionConfig("zenoh.json5", '{ id: "abc" }').build({})
