"""Tests of `zbot doctor --tf` with programs that publish broken transforms."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import Outcome, zbot

if TYPE_CHECKING:
    from tests.conftest import Start

STATIC = ("zbot", "run", "tf2_ros", "static_transform_publisher")
#: Publishes links ten times a second. `simulated` means a time that starts at 0. Another word is
#: the error of the clock in seconds.
BROADCASTER = """
import zbot
from rclpy.utilities import remove_ros_args
from zbot.tf2 import TransformBroadcaster

from geometry_msgs.msg import TransformStamped

error, *links = remove_ros_args()[1:]
zbot.init()
node = zbot.create_node("broadcaster")
broadcaster = TransformBroadcaster(node)
count = 0


def publish():
    global count
    count += 1
    now = node.get_clock().now().nanoseconds
    stamp = count * 10**8 if error == "simulated" else now + int(float(error) * 1e9)
    for link in links:
        message = TransformStamped()
        message.header.frame_id, message.child_frame_id = link.split(">")
        message.header.stamp = zbot.Time(nanoseconds=stamp).to_msg()
        message.transform.translation.x = float(count)
        broadcaster.sendTransform(message)


node.create_timer(0.1, publish)
print("ready", flush=True)
zbot.spin(node)
"""


def fix(start: Start, parent: str, child: str) -> None:
    start(*STATIC, "--frame-id", parent, "--child-frame-id", child).wait_for("from '")


def drive(start: Start, error: str, *links: str, ros_args: tuple[str, ...] = ()) -> None:
    words = (error, *links, *(("--ros-args", *ros_args) if ros_args else ()))
    start(*words, source=BROADCASTER).wait_for("ready")


def doctor(*frames: str, seconds: str = "1.5") -> Outcome:
    return zbot("doctor", "--tf", "--seconds", seconds, *frames)


def test_a_whole_tree_is_printed_without_a_problem(start: Start) -> None:
    fix(start, "base_link", "laser")
    drive(start, "0", "odom>base_link")
    done = doctor()
    assert (done.code, done.err) == (0, "")
    heading, root, base, laser, *_ = done.out.splitlines()
    assert heading == "Heard on /tf and /tf_static for 1.5 s:"
    assert root == "  odom"
    assert base.split()[0] == "base_link"
    assert base.endswith(" old   /broadcaster")
    assert laser.split()[:2] == ["laser", "static"]
    assert done.out.endswith("\nNo problem found\n")
    shown = doctor("odom", "laser")
    assert (shown.code, shown.out.splitlines()[-1]) == (
        0,
        "ok    the transform from laser to odom is known",
    )


@pytest.mark.usefixtures("domain")
def test_a_domain_without_transforms_is_a_problem() -> None:
    done = doctor(seconds="0.2")
    assert done.code == 1
    assert "FAIL  no publisher: nobody publishes on /tf and /tf_static\n      -> " in done.out
    assert done.out.endswith("\n1 problem(s)\n")


def test_two_trees_are_named_as_text_and_as_json(start: Start) -> None:
    fix(start, "earth", "map")
    drive(start, "0", "odom>base_link")
    sentence = "`earth` and `odom` are two trees; nobody publishes map -> odom"
    done = doctor()
    assert done.code == 1
    assert f"FAIL  two trees: {sentence}\n" in done.out
    found = zbot("doctor", "--tf", "--seconds", "1.5", "--json", "map", "base_link")
    assert found.code == 1
    (problem,) = json.loads(found.out)["problems"]
    assert problem["text"] == f"no transform from base_link to map: {sentence}"
    assert problem["frames"] == ["map", "odom"]


def test_two_parents_name_their_nodes(start: Start) -> None:
    fix(start, "base_footprint", "base_link")
    drive(start, "0", "odom>base_link")
    out = doctor().out
    assert "two parents: `base_link` has 2 parents, `odom` (/broadcaster on /tf) and " in out
    assert "zbot node info /broadcaster" in out


def test_simulated_time_beside_the_time_of_day_is_named(start: Start) -> None:
    drive(start, "simulated", "odom>base_link")
    drive(start, "0", "map>odom", ros_args=("-r", "__node:=slam"))
    done = doctor()
    assert done.code == 1
    assert (
        "mixed time: `odom -> base_link` (/broadcaster on /tf) has simulated or recorded time, and "
        "`map -> odom` (/slam on /tf) has the time of day"
    ) in done.out
    assert "zbot param set /slam use_sim_time true" in done.out


def test_stamps_in_the_future_are_a_warning(start: Start) -> None:
    drive(start, "0.4", "odom>base_link")
    done = doctor()
    assert done.code == 0
    assert (
        "WARN  stamped ahead: `odom -> base_link` (/broadcaster on /tf) is stamped 0." in done.out
    )


def test_transforms_in_a_namespace_are_named(start: Start) -> None:
    drive(start, "0", "odom>base_link", ros_args=("-r", "/tf:=/robot1/tf"))
    done = doctor("odom", "base_link")
    assert done.code == 1
    assert "`odom` and `base_link` are on /robot1/tf, and the program hears /tf" in done.out
    assert "--ros-args -r /tf:=/robot1/tf" in done.out


def test_a_transform_that_has_stopped_is_named(start: Start) -> None:
    stopping = BROADCASTER.replace("count += 1", "count += 1\n    if count > 30: return")
    start("0", "odom>base_link", source=stopping).wait_for("ready")
    done = doctor(seconds="5")
    assert done.code == 1
    assert "stale: `odom -> base_link` (/broadcaster on /tf) was last heard " in done.out
    assert "stopped" in done.out


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("map", "laser"), "frames need the option --tf"),
        (("--tf", "map"), "name two frames, e.g. zbot doctor --tf map laser"),
    ],
)
@pytest.mark.usefixtures("domain")
def test_a_wrong_command_line_is_refused(words: tuple[str, ...], sentence: str) -> None:
    done = zbot("doctor", *words)
    assert done.code == 2
    assert sentence in done.err
