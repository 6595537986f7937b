"""Messages as text, beside what the recorded ros2 printed and what PyYAML prints."""

from __future__ import annotations

import array
import json
from typing import Any

import pytest
import yaml

import zbot  # noqa: F401 - makes the message packages importable
from zbot_cli.echo import Form
from zbot_cli.message_text import FieldPathError, formatter, parse_path, select

from geometry_msgs.msg import PoseWithCovariance, Twist  # isort: skip
from sensor_msgs.msg import JointState, LaserScan  # isort: skip
from std_msgs.msg import ByteMultiArray, Float32, Header, String  # isort: skip

INFO: Any = {
    "source_timestamp": 2,
    "received_timestamp": 3,
    "publication_sequence_number": 4,
    "reception_sequence_number": 5,
}


def text(message: Any, **form: Any) -> str:
    return formatter(Form(**form))("/topic", message, INFO)


def scan(count: int) -> LaserScan:
    ranges = array.array("f", map(float, range(count)))
    return LaserScan(header=Header(frame_id="laser"), ranges=ranges)


def test_a_twist_looks_as_recorded() -> None:
    message = Twist()
    message.linear.x, message.angular.z = 0.25, -1.5
    assert text(message) == (
        "linear:\n  x: 0.25\n  y: 0.0\n  z: 0.0\nangular:\n  x: 0.0\n  y: 0.0\n  z: -1.5\n---\n"
    )
    assert text(message, csv=True) == "0.25,0.0,0.0,0.0,0.0,-1.5\n"
    assert text(message, flow_style=True) == text(message)


@pytest.mark.parametrize(
    "value",
    [
        "",
        "hi",
        "Hello World: 42",
        "yes",
        "1.0",
        "null",
        "a: b",
        "- x",
        "#x",
        "grüße",
        "a\nb",
        "'",
        '"',
        "x" * 100,
    ],
)
def test_strings_are_quoted_as_pyyaml_quotes_them(value: str) -> None:
    wanted = yaml.safe_dump({"data": value}, allow_unicode=True, width=2**31 - 1)
    assert text(String(data=value)) == f"{wanted}---\n"


@pytest.mark.parametrize("value", [0.0, -1.5, 1e-5, 1e20, float("inf"), float("-inf"), 0.1])
def test_floats_look_as_pyyaml_writes_them(value: float) -> None:
    assert text(Float32(data=value)) == yaml.safe_dump({"data": value}) + "---\n"


def test_long_lists_and_strings_are_cut() -> None:
    lines = text(scan(200)).splitlines()
    start = lines.index("ranges:")
    assert lines[start + 1 : start + 3] == ["- 0.0", "- 1.0"]
    assert lines[start + 128 : start + 130] == ["- 127.0", "- '...'"]
    assert lines[-2:] == ["intensities: []", "---"]
    assert text(String(data="x" * 200)) == "data: " + "x" * 128 + "...\n---\n"
    assert text(String(data="x" * 200), length=None) == "data: " + "x" * 200 + "\n---\n"
    assert text(scan(200), length=2).splitlines()[start : start + 4] == [
        "ranges:",
        "- 0.0",
        "- 1.0",
        "- '...'",
    ]


def test_contents_can_be_left_out() -> None:
    lines = text(scan(200), no_arr=True).splitlines()
    assert "ranges: '<sequence type: float, length: 200>'" in lines
    assert "covariance: '<array type: double[36]>'" in text(PoseWithCovariance(), no_arr=True)
    assert text(String(data="abc"), no_str=True) == "data: '<string length: <3>>'\n---\n"


def test_short_numeric_lists_stand_on_one_line() -> None:
    message = JointState(name=["a", "b"], position=[0.5, 1.5])
    lines = text(message).splitlines()
    assert "position: [0.5, 1.5]" in lines
    assert lines[lines.index("name:") + 1 :][:2] == ["- a", "- b"]


def test_a_field_can_be_chosen() -> None:
    message = Twist()
    message.linear.x = 0.25
    assert text(message, fields=("linear.x",)) == "0.25\n---\n"
    assert text(message, fields=("linear",)) == "x: 0.25\ny: 0.0\nz: 0.0\n---\n"
    assert text(scan(5), fields=("ranges[3]",)) == "3.0\n---\n"
    assert text(message, fields=("linear.x", "angular.z")) == "0.25\n---\n0.0\n---\n"


@pytest.mark.parametrize("path", ["", ".", "a..b", "a[", "a[x]", "a[1:2:3:4]", "a b"])
def test_a_malformed_path_is_refused(path: str) -> None:
    with pytest.raises(FieldPathError, match="Invalid field"):
        parse_path(path)


def test_a_path_that_leads_nowhere_is_told_with_the_nearest_field() -> None:
    with pytest.raises(FieldPathError, match="'Twist' object has no attribute 'linar'") as caught:
        select(Twist(), parse_path("linar.x"))
    assert caught.value.hint == "did you mean 'linear'?"
    with pytest.raises(FieldPathError, match="index out of range"):
        select(scan(2), parse_path("ranges[7]"))


def test_times_and_numbers_come_first() -> None:
    assert text(String(data="x"), with_info=True) == (
        "publication_sequence_number: 4\nreceived_timestamp: 3\nreception_sequence_number: 5\n"
        "source_timestamp: 2\n---\ndata: x\n---\n"
    )
    assert text(String(data="x"), with_info=True, csv=True) == "2,3,4,5,x\n"


def test_json_is_one_object_a_line() -> None:
    message = scan(2)
    message.angle_min = float("nan")
    found = json.loads(text(message, json=True))
    assert found["ranges"] == [0.0, 1.0]
    assert found["angle_min"] is None
    assert found["header"]["frame_id"] == "laser"
    assert text(message, json=True).count("\n") == 1


def test_bytes_are_shown_as_characters() -> None:
    assert "- A" in text(ByteMultiArray(data=[b"A"])).splitlines()
