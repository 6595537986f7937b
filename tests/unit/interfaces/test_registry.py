from __future__ import annotations

import os
import threading
from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import in_threads
from zbot.errors import WrongValueError
from zbot.interfaces import (
    definition_text,
    get_action,
    get_interface,
    get_message,
    get_service,
    get_spec,
    interface_names,
    packages,
    register_spec,
    registry,
    type_name,
)
from zbot.interfaces.errors import InterfaceSyntaxError, UnknownInterfaceError, UnknownPackageError
from zbot.interfaces.location import shipped_packages
from zbot.interfaces.parser import parse, parse_message

if TYPE_CHECKING:
    from pathlib import Path


def write(folder: Path, **files: str) -> None:
    """Write definition files by name and kind: `write(folder, Num_msg="int64 num")`."""
    for name, text in files.items():
        short, kind = name.split("_")
        file = folder / kind / f"{short}.{kind}"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a workspace with a `src` folder; the current folder is inside it."""
    source = tmp_path / "ws" / "src"
    source.mkdir(parents=True)
    monkeypatch.chdir(source)
    return source


@pytest.mark.parametrize(
    ("name", "full"),
    [
        ("std_msgs/msg/String", "std_msgs/msg/String"),
        ("std_msgs/String", "std_msgs/msg/String"),
        ("std_srvs/SetBool", "std_srvs/srv/SetBool"),
        ("std_srvs/srv/SetBool_Request", "std_srvs/srv/SetBool_Request"),
        ("std_srvs/srv/SetBool_Event", "std_srvs/srv/SetBool_Event"),
        ("example_interfaces/Fibonacci", "example_interfaces/action/Fibonacci"),
        (
            "example_interfaces/action/Fibonacci_SendGoal_Response",
            "example_interfaces/action/Fibonacci_SendGoal_Response",
        ),
        ("turtlesim_msgs/msg/Pose", "turtlesim_msgs/msg/Pose"),
    ],
)
def test_types_are_found_by_full_and_short_names(name: str, full: str) -> None:
    assert get_spec(name).name == full
    assert type_name(get_interface(name)) == full


def test_a_known_kind_may_be_left_out() -> None:
    assert get_service("std_srvs/SetBool") is get_service("std_srvs/srv/SetBool")
    assert get_action("example_interfaces/Fibonacci")._TYPE_NAME.count("/action/") == 1


@pytest.mark.parametrize(
    ("name", "error", "hint"),
    [
        ("std_msgs/msg/Strng", UnknownInterfaceError, "did you mean 'std_msgs/msg/String'"),
        ("std_msgs/msg/string", UnknownInterfaceError, "did you mean 'std_msgs/msg/String'"),
        ("std_msg/msg/String", UnknownPackageError, "did you mean 'std_msgs'"),
        ("String", UnknownInterfaceError, "'std_msgs/msg/String'"),
        ("zzz", UnknownInterfaceError, "Unknown interface 'zzz'"),
        ("std_srvs/srv/SetBool_Nothing", UnknownInterfaceError, "SetBool"),
        ("a/b/c/d", UnknownPackageError, "Unknown package 'a'"),
        ("../../etc/msg/Passwd", UnknownPackageError, "Unknown package '..'"),
        ("std_msgs/../String", UnknownInterfaceError, "String"),
        ("std_msgs/msg/../../String", UnknownInterfaceError, "String"),
        ("", UnknownInterfaceError, "''"),
    ],
)
def test_an_unknown_name_has_suggestions(name: str, error: type[Exception], hint: str) -> None:
    with pytest.raises(error) as caught:
        get_spec(name)
    assert hint in str(caught.value)


def test_a_service_is_not_a_message() -> None:
    with pytest.raises(UnknownInterfaceError):
        get_message("std_srvs/srv/SetBool")
    with pytest.raises(UnknownInterfaceError):
        get_service("std_msgs/msg/String")


def test_interfaces_are_listed() -> None:
    known = packages()
    assert known == sorted(known)
    assert {"std_msgs", "turtlesim", "turtlesim_msgs", "example_interfaces"} <= set(known)
    assert interface_names("std_srvs") == [
        "std_srvs/srv/Empty",
        "std_srvs/srv/SetBool",
        "std_srvs/srv/Trigger",
    ]
    with pytest.raises(UnknownPackageError, match="did you mean 'std_srvs'"):
        interface_names("std_srv")


def test_every_shipped_interface_has_a_class_and_text() -> None:
    for package in shipped_packages():
        for name in interface_names(package):
            assert type_name(get_interface(name)) == name
            assert definition_text(name)


def test_types_of_the_workspace_need_no_build(workspace: Path) -> None:
    write(workspace / "ws_one_interfaces", Num_msg="int64 num", Twice_srv="Num a\n---\nNum b")
    message: Any = get_message("ws_one_interfaces/msg/Num")
    service: Any = get_service("ws_one_interfaces/Twice")
    assert message(num=3).num == 3
    assert service.Request(a=message(num=3)).a.num == 3
    assert "ws_one_interfaces" in packages()
    assert interface_names("ws_one_interfaces") == [
        "ws_one_interfaces/msg/Num",
        "ws_one_interfaces/srv/Twice",
    ]


def test_the_workspace_is_found_from_deep_inside(
    workspace: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(workspace / "group" / "ws_two_interfaces", Num_msg="int64 num")
    inside = workspace / "other_package" / "other_package"
    inside.mkdir(parents=True)
    (inside.parent / "package.xml").write_text("<package/>", encoding="utf-8")
    monkeypatch.chdir(inside)
    assert get_spec("ws_two_interfaces/msg/Num")


def test_the_workspace_is_found_from_its_root(
    workspace: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(workspace / "ws_three_interfaces", Num_msg="int64 num")
    monkeypatch.chdir(workspace.parent)
    assert get_spec("ws_three_interfaces/msg/Num")


def test_a_package_alone_is_a_workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "folder"
    write(package, Num_msg="int64 num")
    (package / "package.xml").write_text(
        "<package><name>ws_four_interfaces</name></package>", encoding="utf-8"
    )
    (package / "scripts").mkdir()
    monkeypatch.chdir(package / "scripts")
    assert get_spec("ws_four_interfaces/msg/Num")


def test_zbot_workspace_names_the_folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path / "a" / "ws_five_interfaces", Num_msg="int64 num")
    write(tmp_path / "b" / "ws_six_interfaces", Num_msg="int64 num")
    monkeypatch.setenv(
        "ZBOT_WORKSPACE", os.pathsep.join([str(tmp_path / "a"), str(tmp_path / "b")])
    )
    assert get_spec("ws_five_interfaces/msg/Num")
    assert get_spec("ws_six_interfaces/msg/Num")


def test_share_folders_of_ros_are_searched(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path / "share" / "installed_interfaces", Num_msg="int64 num")
    index = tmp_path / "share" / "ament_index" / "resource_index" / "rosidl_interfaces"
    index.mkdir(parents=True)
    (index / "installed_interfaces").touch()
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    assert get_spec("installed_interfaces/msg/Num")
    assert "installed_interfaces" in packages()


def test_python_packages_with_definitions_are_searched(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path / "python_interfaces", Num_msg="int64 num")
    (tmp_path / "python_interfaces" / "__init__.py").touch()
    monkeypatch.syspath_prepend(str(tmp_path))
    assert get_spec("python_interfaces/msg/Num")
    assert "python_interfaces" in packages()


@pytest.mark.parametrize("folder", ["build", "install", ".git", "node_modules"])
def test_folders_of_tools_are_not_searched(workspace: Path, folder: str) -> None:
    write(workspace / folder / "hidden_interfaces", Num_msg="int64 num")
    with pytest.raises(UnknownPackageError):
        get_spec("hidden_interfaces/msg/Num")


def test_folders_marked_to_be_ignored_are_not_searched(workspace: Path) -> None:
    write(workspace / "ignored_interfaces", Num_msg="int64 num")
    (workspace / "ignored_interfaces" / "COLCON_IGNORE").touch()
    with pytest.raises(UnknownPackageError):
        get_spec("ignored_interfaces/msg/Num")


def test_the_home_folder_is_not_searched(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path / "homeless_interfaces", Num_msg="int64 num")
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    with pytest.raises(UnknownPackageError):
        get_spec("homeless_interfaces/msg/Num")


def test_a_broken_definition_names_its_file_and_line(workspace: Path) -> None:
    write(workspace / "broken_interfaces", Num_msg="# Number\nint num")
    with pytest.raises(InterfaceSyntaxError) as caught:
        get_message("broken_interfaces/msg/Num")
    assert caught.value.file == str(workspace / "broken_interfaces" / "msg" / "Num.msg")
    assert caught.value.line == 2


def test_a_definition_that_is_not_text(workspace: Path) -> None:
    write(workspace / "binary_interfaces", Num_msg="")
    (workspace / "binary_interfaces" / "msg" / "Num.msg").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InterfaceSyntaxError, match="not UTF-8"):
        get_message("binary_interfaces/msg/Num")


def test_an_unknown_type_inside_names_the_line(workspace: Path) -> None:
    write(workspace / "lost_interfaces", Num_msg="int64 a\nstd_msgs/Strng b")
    with pytest.raises(InterfaceSyntaxError, match=r"Num\.msg:2: .*did you mean 'std_msgs/msg/Str"):
        get_message("lost_interfaces/msg/Num")


@pytest.mark.parametrize(
    ("number", "line", "advice"),
    [
        (1, "String name", "wrong1_interfaces has no message String: write string"),
        (2, "Pose[] path", "wrong2_interfaces has no message Pose: write geometry_msgs/Pose"),
        (3, "std_msgs/Pose pose", "std_msgs has no message Pose: write geometry_msgs/Pose"),
    ],
)
def test_a_type_of_another_package_is_told_with_the_line_of_the_file(
    workspace: Path, number: int, line: str, advice: str
) -> None:
    write(workspace / f"wrong{number}_interfaces", Num_msg=f"int64 a\n{line}  # comment")
    with pytest.raises(InterfaceSyntaxError, match=rf"Num\.msg:2: {advice}") as told:
        get_message(f"wrong{number}_interfaces/msg/Num")
    assert str(told.value).endswith(f"\n  {line}  # comment")


def test_messages_that_contain_themselves_are_refused(workspace: Path) -> None:
    write(workspace / "cyclic_interfaces", Me_msg="Me me", A_msg="int32 x\nB b", B_msg="A[] a")
    with pytest.raises(InterfaceSyntaxError, match=r"Me\.msg:1: a message cannot contain itself"):
        get_message("cyclic_interfaces/msg/Me")
    with pytest.raises(InterfaceSyntaxError, match=r"cyclic_interfaces/msg/A -> .*/B -> .*/A"):
        get_message("cyclic_interfaces/msg/A")


def test_too_deep_nesting_is_refused(workspace: Path) -> None:
    files = {f"T{i}_msg": f"T{i + 1} x" for i in range(200)}
    write(workspace / "deep_interfaces", **files, T200_msg="int32 x")
    with pytest.raises(InterfaceSyntaxError, match="nested deeper"):
        get_message("deep_interfaces/msg/T0")
    assert get_message("deep_interfaces/msg/T190")


def test_definitions_from_elsewhere_can_be_registered() -> None:
    register_spec(parse_message("remote_interfaces/msg/Num", "int64 num"))
    register_spec(parse("remote_interfaces/srv/Twice", "Num a\n---\nNum b"))
    assert get_message("remote_interfaces/msg/Num")(num=3).num == 3  # type: ignore[attr-defined]
    assert get_interface("remote_interfaces/srv/Twice_Request")().a.num == 0
    assert interface_names("remote_interfaces") == [
        "remote_interfaces/msg/Num",
        "remote_interfaces/srv/Twice",
    ]


def test_a_different_definition_of_a_known_name_is_rejected() -> None:
    register_spec(parse_message("std_msgs/msg/String", "int32 A=1\nstring data 'default'"))
    with pytest.raises(WrongValueError, match="std_msgs/msg/String is defined differently"):
        register_spec(parse_message("std_msgs/msg/String", "wstring data"))


def test_threads_get_the_same_class(workspace: Path) -> None:
    write(workspace / "threaded_interfaces", Num_msg="int64 num", Pair_msg="Num a\nNum b")
    found: list[type[Any]] = []
    start = threading.Barrier(8)

    def look_up(_: int) -> None:
        start.wait()
        found.append(get_message("threaded_interfaces/msg/Pair"))

    in_threads(look_up, 8)
    assert len(set(found)) == 1


def test_a_spec_is_looked_up_without_suggestions(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "packages", lambda: pytest.fail("all folders are scanned"))
    assert registry.find_spec("std_msgs/String") is get_spec("std_msgs/msg/String")
    for name in ("nobody_msgs/msg/Thing", "std_msgs/msg/Thing", "Thing", "../msg/Thing"):
        assert registry.find_spec(name) is None
