from __future__ import annotations

import os
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from zbot.transport import background_process, config, environment, membership
from zbot.transport.membership import Membership, MembershipError, Role

STUDENT = Membership(
    "student", "10.0.0.1", 7447, class_name="Robots", number=17, user="student17", secret="s3"
)


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))


def test_without_a_membership_the_domain_is_0() -> None:
    assert membership.load() is None
    assert config.domain_id() == 0


def test_a_membership_is_stored_until_it_is_removed() -> None:
    membership.save(STUDENT, [("student17", "s3")])
    assert membership.load() == STUDENT
    membership.forget()
    membership.forget()
    assert membership.load() is None


def test_a_students_domain_is_the_number_also_if_a_variable_differs(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    membership.save(STUDENT)
    monkeypatch.setenv("ZBOT_DOMAIN_ID", "5")
    monkeypatch.setenv("ROS_DOMAIN_ID", "nonsense")
    assert config.domain_id() == 17
    monkeypatch.setenv(config.COMMAND_DOMAIN, "6")
    assert config.domain_id() == 6
    assert config.domain_id(9) == 9


def test_a_hub_without_a_class_has_all_domains(monkeypatch: pytest.MonkeyPatch) -> None:
    membership.save(Membership("partner", "10.0.0.1", 7447))
    monkeypatch.setenv("ROS_DOMAIN_ID", "5")
    assert config.domain_id() == 5
    assert environment.differences() == []


def test_the_port_of_the_own_hub_is_the_one_at_joining(monkeypatch: pytest.MonkeyPatch) -> None:
    membership.save(replace(STUDENT, hub_port=7500))
    monkeypatch.setenv("ZBOT_HUB_PORT", "7501")
    assert config.hub_port() == 7500
    assert [difference.setting for difference in environment.differences()] == [
        "ZBOT_HUB_PORT=7501"
    ]


@pytest.mark.parametrize(
    ("role", "variable", "settings"),
    [
        ("student", ("ROS_DOMAIN_ID", "17"), []),
        ("student", ("ROS_DOMAIN_ID", "7"), ["ROS_DOMAIN_ID=7"]),
        ("student", (config.COMMAND_DOMAIN, "7"), ["--domain 7"]),
        ("teacher", (config.COMMAND_DOMAIN, "7"), ["--domain 7"]),
        ("student", ("ZBOT_DISCOVERY_RANGE", "LOCALHOST"), []),
        ("student", ("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET"), [
            "ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET"
        ]),
        ("student", ("ROS_LOCALHOST_ONLY", "1"), ["ROS_LOCALHOST_ONLY=1"]),
        ("student", ("ROS_LOCALHOST_ONLY", "0"), []),
    ],
)  # fmt: skip
def test_settings_that_differ_from_the_class_are_listed(
    monkeypatch: pytest.MonkeyPatch, role: Role, variable: tuple[str, str], settings: list[str]
) -> None:
    membership.save(replace(STUDENT, role=role))
    monkeypatch.setenv(*variable)
    found = environment.differences()
    assert [difference.setting for difference in found] == settings
    assert not any(difference.hides for difference in found)


@pytest.mark.parametrize(
    ("endpoints", "is_seen"),
    [
        ('["tcp/10.9.9.9:7447"]', False),
        ('{ peer: ["tcp/10.9.9.9:7447"] }', False),
        ('["tcp/127.0.0.1:7467"]', True),  # domain 17
        ('["tcp/127.0.0.1:7447"]', True),  # this machine's hub
        ('["tcp/10.0.0.1:7447"]', False),  # the class itself accepts only the hubs of laptops
        ("[]", True),
    ],
)
def test_a_configuration_that_connects_elsewhere_hides_nodes(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, endpoints: str, is_seen: bool
) -> None:
    membership.save(replace(STUDENT, hub_port=7447))
    (tmp_path / "far.json5").write_text(f"{{ connect: {{ endpoints: {endpoints} }} }}")
    monkeypatch.setenv("ZENOH_CONFIG", str(tmp_path / "far.json5"))
    monkeypatch.delenv("ZBOT_HUB_PORT")
    assert [difference.hides for difference in environment.differences()] == [True] * (not is_seen)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no file modes")
def test_only_the_user_can_read_the_membership() -> None:
    membership.save(STUDENT, [("student17", "s3")])
    for path in membership.folder().iterdir():
        assert path.stat().st_mode & 0o077 == 0
    assert membership.folder().stat().st_mode & 0o077 == 0


def test_the_repr_does_not_show_the_secret() -> None:
    assert "s3" not in repr(STUDENT)


def test_a_file_of_a_later_version_is_read() -> None:
    membership.save(STUDENT)
    path = membership.folder() / membership.FILE
    path.write_text(path.read_text().replace("{", '{"colour": "green",', 1))
    assert membership.load() == STUDENT


@pytest.mark.parametrize("content", [b"", b"[]", b"{}", b"\xff", b'"x"', b"{"])
def test_a_damaged_file_raises_a_one_line_error(content: bytes) -> None:
    membership.save(STUDENT)
    (membership.folder() / membership.FILE).write_bytes(content)
    with pytest.raises(MembershipError, match="zbot leave"):
        membership.load()


def test_the_folder_is_the_settings_folder_of_the_system(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("XDG_CONFIG_HOME")
    monkeypatch.setattr(sys, "platform", "linux")
    assert membership.folder() == Path.home() / ".config" / "zbot"
    monkeypatch.setattr(sys, "platform", "darwin")
    assert membership.folder() == Path.home() / "Library" / "Application Support" / "zbot"
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setitem(os.environ, "APPDATA", str(Path("roaming")))
    assert membership.folder() == Path("roaming") / "zbot"


def test_sessions_log_in_only_with_a_user_name() -> None:
    assert membership.session_settings(None) == {}
    assert membership.session_settings(Membership("partner", "h", 1)) == {}
    assert membership.session_settings(STUDENT)["transport/auth/usrpwd/user"] == "student17"


def test_a_hub_that_does_not_run_is_named() -> None:
    assert environment.missing_hub() == ""
    membership.save(STUDENT)
    assert "`zbot join` starts it again" in environment.missing_hub()
    membership.save(replace(STUDENT, role="partner"))
    assert "the hub at 10.0.0.1" in environment.missing_hub()
    membership.save(replace(STUDENT, role="teacher"))
    assert "`zbot class start` continues it" in environment.missing_hub()
    with background_process.hub_lock_path().open("w", encoding="utf-8") as file:
        assert background_process.lock(file)
        assert environment.missing_hub() == ""
