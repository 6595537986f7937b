"""Tests of messages as text against recorded output of ros2 and of PyYAML."""

from __future__ import annotations

import array
import json
from typing import Any

import hypothesis
import pytest
import yaml
from hypothesis import strategies

import zbot  # noqa: F401 - makes the message packages importable
from zbot.interfaces.field_path import FieldPath, FieldPathError
from zbot.interfaces.yaml_text import dump
from zbot_cli.input.message_values import Template
from zbot_cli.output.message_text import Form, Formatter

from geometry_msgs.msg import Pose, PoseArray, PoseWithCovariance, Twist  # isort: skip
from sensor_msgs.msg import JointState, LaserScan  # isort: skip
from shape_msgs.msg import SolidPrimitive  # isort: skip
from std_msgs.msg import Byte, ByteMultiArray, Float32, Header, String, UInt8MultiArray  # isort: skip
from unique_identifier_msgs.msg import UUID  # isort: skip

INFO: Any = {
    "source_timestamp": 2,
    "received_timestamp": 3,
    "publication_sequence_number": 4,
    "reception_sequence_number": 5,
}


def text(message: Any, **form: Any) -> str:
    return Formatter(Form(**form)).text("/topic", message, INFO)


def scan(count: int) -> LaserScan:
    ranges = array.array("f", map(float, range(count)))
    return LaserScan(header=Header(frame_id="laser"), ranges=ranges)


def test_a_twist_equals_the_recorded_output() -> None:
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


def test_long_lists_and_strings_are_shortened() -> None:
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


def test_lists_and_strings_can_be_left_out() -> None:
    lines = text(scan(200), no_arr=True).splitlines()
    assert "ranges: '<sequence type: float, length: 200>'" in lines
    assert "covariance: '<array type: double[36]>'" in text(PoseWithCovariance(), no_arr=True)
    assert text(String(data="abc"), no_str=True) == "data: '<string length: <3>>'\n---\n"


def test_short_numeric_lists_are_on_one_line() -> None:
    message = JointState(name=["a", "b"], position=[0.5, 1.5])
    lines = text(message).splitlines()
    assert "position: [0.5, 1.5]" in lines
    assert lines[lines.index("name:") + 1 :][:2] == ["- a", "- b"]


def test_a_field_can_be_selected() -> None:
    message = Twist()
    message.linear.x = 0.25
    assert text(message, fields=("linear.x",)) == "0.25\n---\n"
    assert text(message, fields=("linear",)) == "x: 0.25\ny: 0.0\nz: 0.0\n---\n"
    assert text(scan(5), fields=("ranges[3]",)) == "3.0\n---\n"
    assert text(scan(5), fields=("ranges.[3]",)) == "3.0\n---\n"
    assert text(message, fields=("linear.x", "angular.z")) == "0.25\n0.0\n---\n"


@pytest.mark.parametrize("path", ["", ".", "[0]", "a..b", "a.", "a[", "a[x]", "a[1:2:3:4]", "a b"])
def test_a_malformed_path_is_refused(path: str) -> None:
    with pytest.raises(FieldPathError, match="Invalid field"):
        FieldPath(path)


def test_an_unknown_path_is_refused_with_the_nearest_field() -> None:
    with pytest.raises(FieldPathError, match="'Twist' object has no attribute 'linar'") as caught:
        FieldPath("linar.x").select(Twist())
    assert caught.value.hint == "did you mean 'linear'?"
    with pytest.raises(FieldPathError, match="index out of range"):
        FieldPath("ranges[7]").select(scan(2))


def test_message_info_comes_before_the_message() -> None:
    assert text(String(data="x"), with_info=True) == (
        "publication_sequence_number: 4\nreceived_timestamp: 3\nreception_sequence_number: 5\n"
        "source_timestamp: 2\n---\ndata: x\n---\n"
    )
    assert text(String(data="x"), with_info=True, csv=True) == "2,3,4,5,x\n"


def test_json_is_one_object_per_line() -> None:
    message = scan(2)
    message.angle_min = float("nan")
    found = json.loads(text(message, json=True))
    assert found["ranges"] == [0.0, 1.0]
    assert found["angle_min"] is None
    assert found["header"]["frame_id"] == "laser"
    assert text(message, json=True).count("\n") == 1


def test_bytes_are_shown_as_characters() -> None:
    assert "- A" in text(ByteMultiArray(data=[b"A"])).splitlines()
    assert text(Byte(data=b"A")) == "data: A\n---\n"
    assert text(Byte(data=b"A"), no_str=True) == "data: A\n---\n"
    assert text(Byte(data=b"\x00"), csv=True) == "b'\\x00'\n"


def values(text: strategies.SearchStrategy[str]) -> strategies.SearchStrategy[dict[str, Any]]:
    scalars = text | strategies.integers() | strategies.floats() | strategies.booleans()
    names = strategies.text("abc", min_size=1)
    inner = strategies.recursive(
        scalars,
        lambda part: strategies.lists(part) | strategies.dictionaries(names, part),
        max_leaves=5,
    )
    return strategies.dictionaries(names, inner)


@hypothesis.given(values(strategies.text()))
def test_yaml_is_read_back_unchanged(value: dict[str, Any]) -> None:
    assert repr(yaml.safe_load(dump(value))) == repr(value)


UNUSUAL_BREAKS = "\x85\u2028\u2029"  # PyYAML's own emitter writes these incorrectly


@hypothesis.given(
    values(strategies.text(strategies.characters(codec="utf-8", exclude_characters=UNUSUAL_BREAKS)))
)
def test_yaml_is_that_of_pyyaml(value: dict[str, Any]) -> None:
    wanted = yaml.safe_dump(value, allow_unicode=True, sort_keys=False, width=2**31 - 1)
    assert dump(value) == wanted


def test_emoji_are_kept() -> None:
    assert text(String(data="🤖 läuft")) == "data: 🤖 läuft\n---\n"
    assert text(String(data="C:\\Users\\me")) == "data: C:\\Users\\me\n---\n"


def test_labels_of_arrays_use_the_names_of_ros2() -> None:
    shown = text(PoseArray(poses=[Pose()]), no_arr=True)
    assert "poses: '<sequence type: geometry_msgs/msg/Pose, length: 1>'" in shown
    shown = text(JointState(name=["a", "b"]), no_arr=True)
    assert "name: '<sequence type: string, length: 2>'" in shown
    shown = text(ByteMultiArray(data=[b"A"]), no_arr=True)
    assert "data: '<sequence type: octet, length: 1>'" in shown
    shown = text(SolidPrimitive(dimensions=[1.0]), no_arr=True)
    assert "dimensions: '<sequence type: double[3], length: 1>'" in shown


def test_a_covariance_is_on_one_line() -> None:
    lines = text(PoseWithCovariance()).splitlines()
    assert "covariance: [" + ", ".join(["0.0"] * 36) + "]" in lines


def test_a_selected_list_is_complete_and_on_one_line() -> None:
    shown = text(scan(200), fields=("ranges",))
    assert shown == "[" + ", ".join(f"{float(i)}" for i in range(200)) + "]\n---\n"
    assert text(scan(200), fields=("ranges[:2]",)) == "[0.0, 1.0]\n---\n"
    assert text(PoseWithCovariance(), fields=("covariance[35]",)) == "0.0\n---\n"
    assert text(String(data="x" * 200), fields=("data",)) == "x" * 200 + "\n---\n"


def test_a_list_of_messages_can_be_selected() -> None:
    message = PoseArray(poses=[Pose(), Pose()])
    message.poses[1].position.x = 1.5
    assert text(message, fields=("poses[1].position",)) == "x: 1.5\ny: 0.0\nz: 0.0\n---\n"
    assert text(message, fields=("poses[1:]",)).startswith("- position:\n    x: 1.5\n")


def test_csv_quotes_only_texts_that_need_it() -> None:
    assert text(String(data="Hello World: 54"), csv=True) == "Hello World: 54\n"
    assert text(String(data='a, "b"'), csv=True) == '"a, ""b"""\n'
    assert text(scan(3), csv=True, length=2).rstrip().endswith(",0.0,1.0,...")
    assert text(scan(3), csv=True, fields=("header.frame_id",)) == "laser\n"


def test_the_topic_is_printed_in_every_form() -> None:
    message = String(data="x")

    def from_two(**form: Any) -> str:
        return Formatter(Form(**form), with_topic=True).text("/a", message, INFO)

    assert from_two() == "# /a\ndata: x\n---\n"
    assert from_two(csv=True) == "/a,x\n"
    assert json.loads(from_two(json=True)) == {"topic": "/a", "message": {"data": "x"}}


def test_json_has_byte_arrays_of_all_types_as_base64() -> None:
    def as_json(message: Any) -> Any:
        return json.loads(text(message, json=True))

    assert as_json(UInt8MultiArray(data=b"AB"))["data"] == "QUI="
    assert as_json(ByteMultiArray(data=[b"A", b"B"]))["data"] == "QUI="
    assert as_json(UUID(uuid=list(range(16))))["uuid"] == "AAECAwQFBgcICQoLDA0ODw=="
    assert as_json(Byte(data=b"A"))["data"] == 65
    assert as_json(PoseWithCovariance())["covariance"] == [0.0] * 36


@pytest.mark.parametrize(
    "message", [UInt8MultiArray(data=b"AB"), ByteMultiArray(data=[b"A"]), scan(3), Byte(data=b"A")]
)
def test_json_can_be_published_again(message: Any) -> None:
    assert Template(type(message), text(message, json=True)).make(lambda: 0) == message


@pytest.mark.parametrize("path", ["linar", "linear.w", "linear.x.y", "linear[0]", "linear.x[1]"])
def test_an_impossible_path_is_refused_before_the_first_message(path: str) -> None:
    with pytest.raises(FieldPathError, match="Invalid field"):
        Formatter(Form(fields=(path,))).check(Twist)


@pytest.mark.parametrize("path", ["poses[3].position.x", "poses", "poses[1:2]", "header.stamp"])
def test_a_path_into_a_list_is_checked_at_the_first_message(path: str) -> None:
    Formatter(Form(fields=(path,))).check(PoseArray)


@pytest.mark.parametrize(
    ("path", "reason"),
    [
        ("data.upper", "'str' object has no attribute 'upper'"),
        ("__class__", "'String' object has no attribute '__class__'"),
        ("get_fields_and_field_types", "'String' object has no attribute 'get_fi"),
    ],
)
def test_a_path_leads_to_fields_only(path: str, reason: str) -> None:
    with pytest.raises(FieldPathError, match=reason):
        FieldPath(path).select(String())
