"""Tests of `zbot interface` against recorded output of ros2; comments are zbot's own."""

from __future__ import annotations

import importlib.util
import io
import json
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import yaml

from tests.cli.command import zbot
from zbot.interfaces import interface_names, packages
from zbot_cli.domain.kinds import TOPIC
from zbot_cli.domain.types import find_types
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from tests.cli.conftest import Command

TWIST = """\
Vector3  linear
\tfloat64 x
\tfloat64 y
\tfloat64 z
Vector3  angular
\tfloat64 x
\tfloat64 y
\tfloat64 z
"""
POSE_STAMPED = """\
std_msgs/Header header
\tbuiltin_interfaces/Time stamp
\t\tint32 sec
\t\tuint32 nanosec
\tstring frame_id
Pose pose
\tPoint position
\t\tfloat64 x
\t\tfloat64 y
\t\tfloat64 z
\tQuaternion orientation
\t\tfloat64 x 0
\t\tfloat64 y 0
\t\tfloat64 z 0
\t\tfloat64 w 1
"""
SET_BOOL = "bool data\n---\nbool success\nstring message\n"
FIBONACCI = "int32 order\n---\nint32[] sequence\n---\nint32[] sequence\n"
TWIST_PROTOTYPE = """\
"linear:
  x: 0.0
  y: 0.0
  z: 0.0
angular:
  x: 0.0
  y: 0.0
  z: 0.0
"
"""


@pytest.mark.parametrize(
    ("name", "wanted"),
    [
        ("geometry_msgs/msg/Twist", TWIST),
        ("geometry_msgs/msg/PoseStamped", POSE_STAMPED),
        ("std_srvs/srv/SetBool", SET_BOOL),
        ("example_interfaces/action/Fibonacci", FIBONACCI),
        ("std_msgs/msg/Empty", ""),
    ],
)
def test_show_without_comments(zbot_command: Command, name: str, wanted: str) -> None:
    result = zbot_command("interface", "show", name, "--no-comments")
    assert (result.code, result.out, result.err) == (0, wanted, "")


def test_show_keeps_the_comments_of_the_requested_type(zbot_command: Command) -> None:
    comment, blank, *rest = zbot_command("interface", "show", "geometry_msgs/msg/Twist").out.split(
        "\n"
    )
    assert comment.startswith("# Velocity in free space")
    assert blank == ""
    assert "\n".join(rest) == TWIST


def test_show_of_a_service_keeps_its_comments_in_place(zbot_command: Command) -> None:
    shown = zbot_command("interface", "show", "std_srvs/srv/SetBool").out.splitlines()
    assert [line.partition("#")[0].rstrip() for line in shown] == SET_BOOL.splitlines()
    assert all("#" in line for line in shown if line != "---")


def test_show_can_keep_all_comments(zbot_command: Command) -> None:
    short = zbot_command("interface", "show", "geometry_msgs/msg/PoseStamped").out
    full = zbot_command("interface", "show", "geometry_msgs/msg/PoseStamped", "--all-comments").out
    assert "\n\t\t# " not in short
    assert "\n\t\t# " in full
    code = [line for line in full.splitlines() if line.strip() and not line.strip().startswith("#")]
    assert "\n".join(line.partition("#")[0].rstrip() for line in code) == POSE_STAMPED.rstrip()


def test_every_shipped_type_can_be_shown_and_has_a_prototype(zbot_command: Command) -> None:
    for name in ("sensor_msgs/msg/LaserScan", "nav_msgs/msg/Odometry", "turtlesim/srv/Spawn"):
        assert zbot_command("interface", "show", name).code == 0
        prototype = zbot_command("interface", "proto", name, "--no-quotes")
        assert isinstance(yaml.safe_load(prototype.out), dict)


@pytest.mark.parametrize(
    "word", ["geometry_msgs/Twist", "geometry_msgs.msg.Twist", "Twist", "geometry_msgs/msg/Twist"]
)
def test_a_type_may_be_written_in_several_forms(zbot_command: Command, word: str) -> None:
    assert zbot_command("interface", "show", word, "--no-comments").out == TWIST


@pytest.mark.parametrize(
    ("word", "sentence", "hint"),
    [
        ("nope/msg/Nope", "Unknown package 'nope'", "`zbot interface packages` lists all packages"),
        ("std_msg/msg/String", "Unknown package 'std_msg'", "did you mean 'std_msgs'?"),
        (
            "std_msgs/msg/Strin",
            "Interface 'msg/Strin' not found in package 'std_msgs'",
            "msg/String'?",
        ),
        (
            "std_msgs/srv/String",
            "Interface 'srv/String' not found",
            "did you mean 'std_msgs/msg/String'?",
        ),
        ("Twst", "Invalid name 'Twst'. Expected three parts separated by '/'", "msg/Twist'?"),
        ("String", "Invalid name 'String'. Expected three", "there are several: example_interf"),
        ("a/b/c/d", "Invalid name 'a/b/c/d'. Expected three", "`zbot interface list` shows all"),
        ("", "Invalid name ''. Expected three parts separated by '/'", "std_msgs/msg/String"),
    ],
)
@pytest.mark.parametrize("verb", ["show", "proto"])
def test_an_unknown_type_is_refused(
    zbot_command: Command, verb: str, word: str, sentence: str, hint: str
) -> None:
    result = zbot_command("interface", verb, word)
    assert (result.code, result.out) == (1, "")
    error, _, advice = result.err.partition("\n\nhint: ")
    assert error.startswith(sentence)
    assert hint in advice


def test_the_type_is_read_from_a_pipe() -> None:
    shown = zbot("interface", "show", "-", "--no-comments", stdin="geometry_msgs/msg/Twist\n")
    assert (shown.code, shown.out) == (0, TWIST)


def test_no_type_is_read_from_a_tty(zbot_command: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = io.StringIO()
    monkeypatch.setattr(terminal, "isatty", lambda: True)
    monkeypatch.setattr(sys, "stdin", terminal)
    result = zbot_command("interface", "show", "-")
    assert result.code == 2
    assert "expected stdin pipe" in result.err


def test_show_as_json_is_the_type_description(zbot_command: Command) -> None:
    found = json.loads(zbot_command("interface", "show", "geometry_msgs/Twist", "--json").out)
    assert found["type_description"]["type_name"] == "geometry_msgs/msg/Twist"


def test_prototypes_equal_the_recorded_output(zbot_command: Command) -> None:
    assert zbot_command("interface", "proto", "geometry_msgs/msg/Twist").out == TWIST_PROTOTYPE
    assert zbot_command("interface", "proto", "std_msgs/msg/String").out == "\"data: ''\n\"\n"
    bare = zbot_command("interface", "proto", "geometry_msgs/msg/Twist", "--no-quotes").out
    assert bare.rstrip("\n") == TWIST_PROTOTYPE.strip('"\n')


@pytest.mark.parametrize(
    ("name", "wanted"),
    [
        ("std_srvs/srv/SetBool", "data: false\n"),
        ("example_interfaces/action/Fibonacci", "order: 0\n"),
        ("std_srvs/srv/Trigger", "{}\n"),
    ],
)
def test_a_prototype_is_of_the_request_or_goal(
    zbot_command: Command, name: str, wanted: str
) -> None:
    assert zbot_command("interface", "proto", name, "--no-quotes").out.rstrip() == wanted.rstrip()


def test_list_prints_three_sections(zbot_command: Command) -> None:
    lines = zbot_command("interface", "list").out.splitlines()
    titles = [line for line in lines if not line.startswith("    ")]
    assert titles == ["Messages:", "Services:", "Actions:"]
    messages = lines[1 : lines.index("Services:")]
    assert messages == sorted(messages)
    assert "    std_msgs/msg/String" in messages
    everything = [name for package in packages() for name in interface_names(package)]
    assert sorted(line.strip() for line in lines if line.startswith(" ")) == sorted(everything)


@pytest.mark.parametrize(
    ("option", "title", "kind"),
    [
        ("-m", "Messages:", "msg"),
        ("-s", "Services:", "srv"),
        ("--only-actions", "Actions:", "action"),
    ],
)
def test_list_of_one_kind(zbot_command: Command, option: str, title: str, kind: str) -> None:
    first, *rest = zbot_command("interface", "list", option).out.splitlines()
    assert first == title
    assert rest
    assert all(f"/{kind}/" in line for line in rest)
    found = json.loads(zbot_command("interface", "list", option, "--json").out)
    assert found == {kind: [line.strip() for line in rest]}


def test_a_package_lists_its_types(zbot_command: Command) -> None:
    wanted = ["std_srvs/srv/Empty", "std_srvs/srv/SetBool", "std_srvs/srv/Trigger"]
    assert zbot_command("interface", "package", "std_srvs").out.split() == wanted
    assert json.loads(zbot_command("interface", "package", "std_srvs", "--json").out) == wanted
    assert zbot_command("interface", "package", "std_srvs", "-m").out == ""


def test_an_unknown_package_is_refused(zbot_command: Command) -> None:
    result = zbot_command("interface", "package", "std_srv")
    assert (result.code, result.out) == (1, "")
    assert result.err == "Unknown package 'std_srv'\n\nhint: did you mean 'std_srvs'?\n"


def test_packages_are_listed(zbot_command: Command) -> None:
    found = zbot_command("interface", "packages").out.split()
    assert found == sorted(packages())
    only_actions = zbot_command("interface", "packages", "-a").out.split()
    assert "example_interfaces" in only_actions
    assert "std_msgs" not in only_actions
    assert json.loads(zbot_command("interface", "packages", "--json").out) == found


def test_a_type_of_the_workspace_needs_no_build(workspace: Path, zbot_command: Command) -> None:
    package = workspace / "cli_interfaces"
    (package / "msg").mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>cli_interfaces</name></package>")
    (package / "msg" / "Caster.msg").write_text("# one caster\nfloat32 speed 1.5 # m/s\n")
    assert (
        zbot_command("interface", "package", "cli_interfaces").out == "cli_interfaces/msg/Caster\n"
    )
    shown = zbot_command("interface", "show", "cli_interfaces/msg/Caster").out
    assert shown == "# one caster\nfloat32 speed 1.5 # m/s\n"
    assert zbot_command("interface", "proto", "Caster", "--no-quotes").out == "speed: 1.5\n\n"


# -- words for types -------------------------------------------------------------------------------


def test_a_short_name_may_match_several_types() -> None:
    assert find_types("String") == ["example_interfaces/msg/String", "std_msgs/msg/String"]
    assert find_types("std_srvs/SetBool") == ["std_srvs/srv/SetBool"]
    assert find_types("nothing") == []


@pytest.mark.parametrize(
    ("word", "hint"),
    [
        ("std_msgs/msg/Strin", "did you mean 'std_msgs/msg/String'?"),
        ("std_msgs/string", "did you mean 'std_msgs/msg/String'?"),
        ("String", "there are several: example_interfaces/msg/String, std_msgs/msg/String"),
        ("Twst", "did you mean 'geometry_msgs/msg/Twist'?"),
        ("std_srvs/srv/SetBool", "`zbot interface list` shows all types"),
    ],
)
def test_a_short_name_without_a_match_is_refused(word: str, hint: str) -> None:
    with pytest.raises(CommandError, match="The passed message type is invalid") as caught:
        TOPIC.resolve_type(word)
    assert caught.value.hint == hint


# -- add -----------------------------------------------------------------------------------------


def test_types_are_added_for_all_projects(zbot_command: Command, tmp_path: Path) -> None:
    source = tmp_path / "box_msgs"
    (source / "msg").mkdir(parents=True)
    (source / "msg" / "Box.msg").write_text("int32 size\n")
    result = zbot_command("interface", "add", str(source))
    assert (result.code, result.out, result.err) == (0, "box_msgs: 1 type added\n", "")
    shutil.rmtree(source)
    assert zbot_command("interface", "show", "box_msgs/msg/Box").out == "int32 size\n"
    assert "box_msgs" in zbot_command("pkg", "list").out.split()
    assert zbot_command("interface", "remove", "box_msgs").out == "box_msgs: removed\n"
    result = zbot_command("interface", "remove", "box_msgs")
    assert (result.code, result.out) == (1, "")
    assert "'box_msgs' was not added with `zbot interface add`" in result.err


def test_what_cannot_be_added_is_one_sentence(zbot_command: Command, tmp_path: Path) -> None:
    result = zbot_command("interface", "add", "no/such/folder")
    assert result.code == 1
    assert "there is no folder or archive 'no/such/folder'" in result.err
    (tmp_path / "std_msgs" / "msg").mkdir(parents=True)
    (tmp_path / "std_msgs" / "msg" / "String.msg").write_text("int32 data\n")
    result = zbot_command("interface", "add", str(tmp_path))
    assert (result.code, result.out) == (1, "")
    assert "std_msgs is not added: it is part of ROS 2 and of zbot" in result.err
    (tmp_path / "box_msgs" / "msg").mkdir(parents=True)
    (tmp_path / "box_msgs" / "msg" / "Box.msg").write_text("px4_msgs/VehicleStatus status\n")
    result = zbot_command("interface", "add", str(tmp_path))
    assert (result.code, result.out) == (1, "box_msgs: 1 type added\n")
    assert "the types use px4_msgs: download https://github.com/PX4/px4_msgs" in result.err


def test_a_missing_package_of_a_known_repository_is_named(zbot_command: Command) -> None:
    result = zbot_command("interface", "show", "px4_msgs/msg/VehicleStatus")
    assert "Unknown package 'px4_msgs'" in result.err
    assert "download https://github.com/PX4/px4_msgs" in result.err


@pytest.mark.parametrize("program", ["pip", "uv"])
def test_a_name_is_downloaded(
    program: str, zbot_command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def run(command: list[str], **__: object) -> subprocess.CompletedProcess[str]:
        *_, folder, name = command
        assert name == "box-msgs"
        if program == "pip":
            assert "--only-binary=:all:" in command
            with zipfile.ZipFile(Path(folder, "a.whl"), "w") as wheel:
                wheel.writestr("box_msgs/msg/Box.msg", "int32 size\n")
        else:
            assert command[:3] == ["/bin/uv", "pip", "install"]
            (Path(folder) / "share" / "box_msgs" / "msg").mkdir(parents=True)
            Path(folder, "share/box_msgs/msg/Box.msg").write_text("int32 size\n")
        return subprocess.CompletedProcess(command, 0, "", "")

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(subprocess, "run", run)
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda _: program if program == "pip" else None
    )
    monkeypatch.setattr(shutil, "which", lambda name: f"/bin/{name}")
    assert zbot_command("interface", "add", "box-msgs").out == "box_msgs: 1 type added\n"
    failed = subprocess.CompletedProcess("pip", 1, "", "x\nERROR: No matching distribution\n")
    monkeypatch.setattr(subprocess, "run", lambda *_, **__: failed)
    result = zbot_command("interface", "add", "box-msgs")
    assert result.code == 1
    assert result.err.strip() == "cannot download box-msgs: No matching distribution"
    if program == "uv":
        monkeypatch.setattr(shutil, "which", lambda _: None)
        result = zbot_command("interface", "add", "box-msgs")
        assert "neither pip nor uv is installed" in result.err
