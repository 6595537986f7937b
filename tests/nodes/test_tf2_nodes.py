"""Tests of the programs of tf2_ros."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import pytest

from zbot_nodes import tf2_echo
from zbot_nodes.static_transform_publisher import read_arguments, rotation

if TYPE_CHECKING:
    from tests.conftest import Start

PUBLISHER = ("zbot", "run", "tf2_ros", "static_transform_publisher")
ECHO = ("zbot", "run", "tf2_ros", "tf2_echo")
MONITOR = ("zbot", "run", "tf2_ros", "tf2_monitor")
FRAMES = ("--frame-id", "map", "--child-frame-id", "base")


def test_echo_shows_every_form_of_a_transform(start: Start) -> None:
    words = ("--x", "1", "--qz", "0.7", "--qw", "0.7", *FRAMES)
    start(*PUBLISHER, *words).wait_for("from 'map'")
    start(*PUBLISHER, *["0", "0", "0.5", "0", "0", "0", "base", "laser"]).wait_for("from 'base'")
    echo = start(*ECHO, "map", "laser", "10")
    echo.wait_for("At time 0.0")
    echo.wait_for("- Translation: [1.000, 0.000, 0.500]")
    echo.wait_for("- Rotation: in Quaternion (xyzw) [0.000, 0.000, 0.707, 0.707]")
    echo.wait_for("- Rotation: in RPY (radian) [0.000, 0.000, 1.571]")
    echo.wait_for("- Rotation: in RPY (degree) [0.000, 0.000, 90.000]")
    echo.wait_for("- Matrix:")
    assert echo.wait_for("1.000").split() == ["0.000", "-1.000", "0.000", "1.000"]
    assert echo.stop() == -2
    stands_still = ("--ros-args", "-p", "use_sim_time:=true")
    start(*ECHO, "map", "nowhere", *stands_still).wait_for('"nowhere" passed to lookupTransform')


@pytest.mark.parametrize(
    "words",
    [
        ("--x=1", "--y=2", "--z=3", "--yaw=1.5708", *FRAMES),
        ["1", "2", "3", "1.5708", "0", "0", "map", "base"],
        ["1", "2", "3", "0", "0", "0.7", "0.7", "map", "base"],
    ],
)
def test_a_transform_can_be_given_in_three_forms(words: list[str]) -> None:
    options = read_arguments(list(words))
    assert (options.frame_id, options.child_frame_id) == ("map", "base")
    assert (options.x, options.y, options.z) == (1, 2, 3)
    assert rotation(options) == pytest.approx((0, 0, 0.5**0.5, 0.5**0.5), abs=1e-5)


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--frame-id", "map", "--child-frame-id", "map"), "from 'map' to itself"),
        (("--qw", "0", *FRAMES), "are all 0"),
        (("--yaw", "1", "--qz", "1", *FRAMES), "not by both"),
        (("--x", "1"), "--frame-id"),
    ],
)
def test_invalid_arguments_are_refused(
    words: tuple[str, ...], sentence: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit, match="2"):
        read_arguments(list(words))
    assert sentence in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("map",), "Usage: tf2_echo source_frame target_frame"),
        (("map", "base", "fast"), "echo_rate must be a number above 0, not 'fast'"),
        (("map", "base", "0"), "echo_rate must be a number above 0, not '0'"),
    ],
)
def test_echo_refuses_invalid_arguments(
    words: tuple[str, ...], sentence: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "argv", ["tf2_echo", *words])
    with pytest.raises(SystemExit, match=sentence):
        tf2_echo.main()


def test_echo_and_monitor_say_why_they_wait(start: Start) -> None:
    start(*PUBLISHER, *FRAMES).wait_for("from 'map'")
    start(*PUBLISHER, "--frame-id", "odom", "--child-frame-id", "wheel").wait_for("from 'odom'")
    reason = "no transform from wheel to map: `map` and `odom` are two trees; nobody publishes map"
    command = "zbot run tf2_ros static_transform_publisher --frame-id map --child-frame-id odom"
    for program in (start(*ECHO, "map", "wheel", "5"), start(*MONITOR, "map", "wheel")):
        program.wait_for("Waiting for transform map ->  wheel: Could not find a connection")
        program.wait_for(reason)
        program.wait_for(command)
