from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.security.access import accepted_users, credentials, teacher_access
from zbot.security.errors import SecurityError
from zbot.security.secret import Secret

if TYPE_CHECKING:
    from pathlib import Path


@pytest.mark.parametrize(
    "name", ["", "a:b", "a\nb", "../17", "a/b", "a b", "<b>", "ä", "x" * 65, "teacher", "lobby"]
)
def test_invalid_user_names_are_refused(name: str) -> None:
    with pytest.raises(SecurityError, match="is not a user name"):
        teacher_access({name: 17})


def test_a_students_user_name_may_differ_from_the_number() -> None:
    rules = teacher_access({"Ana.Lopez": 17})["access_control"]
    assert {"id": "Ana.Lopez", "usernames": ["Ana.Lopez"]} in rules["subjects"]
    assert any("17/**" in rule["key_exprs"] for rule in rules["rules"])


def test_the_user_file_is_configured_only_if_there_is_one(tmp_path: Path) -> None:
    found = credentials("17", Secret("s"), tmp_path / "users")
    assert found["transport/auth/usrpwd/dictionary_file"] == str(tmp_path / "users")
    assert set(credentials("17", Secret("s"))) == {
        "transport/auth/usrpwd/user",
        "transport/auth/usrpwd/password",
    }


def test_accepted_users_are_one_per_line() -> None:
    assert accepted_users({"17": Secret("a"), "18": Secret("b")}) == b"17:a\n18:b\n"
    with pytest.raises(SecurityError):
        accepted_users({"17:x\n18": Secret("a")})


def test_a_driver_may_write_to_one_robot_and_nobody_else_may() -> None:
    rules = teacher_access({"ana": 17, "ben": 18}, drivers={"ana": "arm"})["access_control"]
    writers = [rule for rule in rules["rules"] if "class/arm/**" in rule["key_exprs"]]
    assert {rule["id"] for rule in writers} == {
        "student ana drives: write",
        "student ana drives: write (other side)",
    }
    assert not any("class/base/**" in rule["key_exprs"] for rule in rules["rules"])
