from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from zbot.transport import config, membership
from zbot.transport.membership import Membership, MembershipError

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


def test_a_students_domain_is_the_number_unless_a_variable_sets_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    membership.save(STUDENT)
    assert config.domain_id() == 17
    monkeypatch.setenv("ZBOT_DOMAIN_ID", "5")
    assert config.domain_id() == 5
    assert config.domain_id(9) == 9


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
