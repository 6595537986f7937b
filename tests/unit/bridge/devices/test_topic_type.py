from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from zbot.bridge.devices.errors import DeviceError, UnreadableError
from zbot.bridge.devices.message_maker import MessageMaker, text_of
from zbot.bridge.devices.text_value import word_of
from zbot.bridge.devices.topic_subscriptions import Wanted
from zbot.bridge.devices.topic_type import TopicType, TypeTable, type_of_value

from builtin_interfaces.msg import Time
from geometry_msgs.msg import Twist, Vector3
from std_msgs.msg import Bool, Float32, String

if TYPE_CHECKING:
    from pathlib import Path


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("23.5", "Float32"),
        ("nan", "Float32"),
        ("23", "Int32"),
        ("4000000000", "Int64"),
        ("9999999999999999999", "Float64"),
        ("on", "Bool"),
        ("open", "String"),
    ],
)
def test_the_first_value_decides_the_type(text: str, name: str) -> None:
    assert str(type_of_value(word_of(text))) == f"std_msgs/msg/{name}"


def test_lists_of_numbers_have_types_and_other_lists_do_not() -> None:
    assert str(type_of_value([1, 2])) == "std_msgs/msg/Int32MultiArray"
    assert str(type_of_value([1, 2.5])) == "std_msgs/msg/Float32MultiArray"
    assert type_of_value(["a"]) is None
    assert type_of_value([]) is None


@pytest.mark.parametrize(
    ("text", "name", "field"),
    [
        ("Float32", "std_msgs/msg/Float32", "data"),
        ("std_msgs/Bool", "std_msgs/msg/Bool", "data"),
        ("sensor_msgs/msg/Imu", "sensor_msgs/msg/Imu", ""),
        ("sensor_msgs/Temperature.temperature", "sensor_msgs/msg/Temperature", "temperature"),
        ("geometry_msgs/msg/Twist.linear.x", "geometry_msgs/msg/Twist", "linear.x"),
    ],
)
def test_a_type_may_be_short_and_may_have_a_field(text: str, name: str, field: str) -> None:
    assert TopicType.parse(text) == TopicType(name, field)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Flaot32", "there is no type std_msgs/msg/Flaot32"),
        ("no_msgs/msg/A", "there is no type no_msgs/msg/A"),
        ("a b", "'a b' is not a type"),
        ("geometry_msgs/msg/Twist.liner", "Invalid field 'liner'"),
    ],
)
def test_a_wrong_type_is_one_sentence(text: str, told: str) -> None:
    with pytest.raises(DeviceError, match=told) as caught:
        TopicType.parse(text)
    assert caught.value.hint or "write" in str(caught.value)


def test_types_come_from_options_and_a_file(tmp_path: Path) -> None:
    file = tmp_path / "types.yaml"
    file.write_text("temperature: Float64\n/home/*/light: Bool\n")
    table = TypeTable.read(["/temperature:Int32"], str(file))
    assert str(table.find("temperature")) == "std_msgs/msg/Int32"
    assert str(table.find("/home/kitchen/light")) == "std_msgs/msg/Bool"
    assert table.find("humidity") is None


@pytest.mark.parametrize("text", ["[a]", "a: [1]", "a: {b: c}", "5", "{", "a: Flaot32"])
def test_a_wrong_file_is_one_sentence(tmp_path: Path, text: str) -> None:
    file = tmp_path / "types.yaml"
    file.write_text(text)
    with pytest.raises(DeviceError):
        TypeTable.read([], str(file))
    with pytest.raises(DeviceError, match=r"cannot read .*No such file"):
        TypeTable.read([], str(tmp_path / "no.yaml"))


def maker(text: str) -> MessageMaker:
    return MessageMaker(TopicType.parse(text), lambda: Time(sec=5))


@pytest.mark.parametrize(
    ("kind", "text", "data"),
    [
        ("Float32", "23", 23.0),
        ("Bool", "1", True),
        ("Bool", "off", False),
        ("String", "23.50", "23.50"),
        ("Int32", "23.0", 23),
        ("Float32", "23.5 C", 23.5),
    ],
)
def test_a_value_is_fitted_to_the_type(kind: str, text: str, data: Any) -> None:
    assert maker(kind).make(word_of(text)).data == data


@pytest.mark.parametrize(
    ("kind", "text"), [("Int32", "23.5"), ("Bool", "2"), ("Float32", "open"), ("UInt8", "256")]
)
def test_a_value_that_does_not_fit_is_refused(kind: str, text: str) -> None:
    with pytest.raises(UnreadableError, match=f"the value is no std_msgs/msg/{kind}"):
        maker(kind).make(word_of(text))


def test_a_header_without_a_time_gets_the_present_time() -> None:
    message = maker("sensor_msgs/Temperature.temperature").make(word_of("23.5"))
    assert (message.temperature, message.header.stamp.sec) == (23.5, 5)
    given = maker("sensor_msgs/Imu").make({"header": {"stamp": {"sec": 9}}})
    assert given.header.stamp.sec == 9


def test_one_value_is_no_message_with_several_fields() -> None:
    with pytest.raises(UnreadableError, match="one value is no geometry_msgs/msg/Twist"):
        maker("geometry_msgs/msg/Twist").make(word_of("5"))


def test_messages_become_texts() -> None:
    assert text_of(Bool(data=True), "data", ("0", "1")) == "1"
    assert text_of(Float32(data=0.5), "data", ("0", "1")) == "0.5"
    assert text_of(String(data="a b"), "data", ("0", "1")) == "a b"
    twist = Twist(linear=Vector3(x=0.5))
    assert text_of(twist, "linear.x", ("0", "1")) == "0.5"
    assert text_of(twist.linear, "", ("0", "1")) == '{"x":0.5,"y":0.0,"z":0.0}'


def test_topics_for_a_device_are_parsed() -> None:
    assert Wanted.parse("led") == Wanted("/led")
    bool_type = TopicType("std_msgs/msg/Bool", "data")
    assert Wanted.parse("/led:std_msgs/msg/Bool=cmnd/lamp/POWER") == Wanted(
        "/led", bool_type, "cmnd/lamp/POWER"
    )
    assert Wanted.parse("/robot/*").is_pattern


@pytest.mark.parametrize("text", ["", "a b", "/led:Bol", "/a*=b"])
def test_a_wrong_topic_for_a_device_is_one_sentence(text: str) -> None:
    with pytest.raises(DeviceError):
        Wanted.parse(text)
