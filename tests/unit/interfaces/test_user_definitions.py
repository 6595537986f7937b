"""Tests of the definitions that the user has added for all projects."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.errors import WrongValueError
from zbot.interfaces import user_definitions
from zbot.interfaces.collection import FoundPackage
from zbot.interfaces.errors import InterfaceSyntaxError
from zbot.interfaces.location import core_packages, definition_file, known_packages
from zbot.interfaces.user_definitions import StoreError
from zbot.package.user_folders import definitions_folder, settings_folder

if TYPE_CHECKING:
    from pathlib import Path


def package(name: str, **texts: str) -> FoundPackage:
    return FoundPackage(name, "x", {f"msg/{short}.msg": text for short, text in texts.items()})


def text_of(name: str, short: str) -> str:
    file = definition_file(name, "msg", short)
    return file.read_text() if file else ""


def test_an_added_package_is_found_until_it_is_removed() -> None:
    user_definitions.store(package("box_msgs", Box="int32 a\n", Lid="int32 b\n"))
    assert user_definitions.added_packages() == ["box_msgs"]
    assert "box_msgs" in known_packages()
    assert text_of("box_msgs", "Box") == "int32 a\n"
    user_definitions.store(package("box_msgs", Box="int64 a\n"))
    assert text_of("box_msgs", "Box") == "int64 a\n"
    assert text_of("box_msgs", "Lid") == ""
    user_definitions.remove("box_msgs")
    assert text_of("box_msgs", "Box") == ""
    assert "box_msgs" not in known_packages()
    with pytest.raises(WrongValueError, match="'box_msgs' was not added"):
        user_definitions.remove("box_msgs")
    with pytest.raises(WrongValueError):
        user_definitions.remove("..")
    folder = definitions_folder()
    assert folder is not None
    assert list(folder.iterdir()) == []


def test_the_workspace_then_the_added_then_zbots_own_is_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    own = text_of("control_msgs", "PidState")
    assert own
    user_definitions.store(package("control_msgs", PidState="int32 added\n"))
    assert text_of("control_msgs", "PidState") == "int32 added\n"
    folder = tmp_path / "src" / "control_msgs" / "msg"
    folder.mkdir(parents=True)
    (folder / "PidState.msg").write_text("int32 workspace\n")
    (folder.parent / "package.xml").write_text("<package><name>control_msgs</name></package>")
    monkeypatch.setenv("ZBOT_WORKSPACE", str(tmp_path / "src"))
    assert text_of("control_msgs", "PidState") == "int32 workspace\n"


def test_packages_of_ros_itself_are_not_replaced() -> None:
    user_definitions.store(package("std_msgs", String="int32 wrong\n"))
    assert "wrong" not in text_of("std_msgs", "String")
    assert {"std_msgs", "rcl_interfaces", "sensor_msgs"} <= set(core_packages())
    assert "control_msgs" not in core_packages()


def test_a_wrong_definition_is_an_error_with_its_line() -> None:
    with pytest.raises(InterfaceSyntaxError, match=r"x/msg/Box\.msg:2: .*"):
        user_definitions.check(package("box_msgs", Box="int32 a\nint b\n"))


def test_packages_that_the_types_use_and_that_are_missing_are_returned() -> None:
    box = package("box_msgs", Box="std_msgs/Header a\nant_msgs/Leaf b\nLid lid\n", Lid="int32 a\n")
    assert user_definitions.check(box) == {"ant_msgs"}


def test_a_folder_that_cannot_be_written_is_reported() -> None:
    settings_folder().mkdir(parents=True)
    (settings_folder() / "interfaces").write_text("a file")
    with pytest.raises(StoreError, match="cannot store the definitions of box_msgs: "):
        user_definitions.store(package("box_msgs", Box="int32 a\n"))
