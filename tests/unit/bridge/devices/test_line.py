from __future__ import annotations

import time
from typing import Any

import pytest

from tests.conftest import allowed
from zbot.bridge.devices.errors import UnreadableError
from zbot.bridge.devices.serial.line import LineReader
from zbot.bridge.devices.topic_type import TypeTable
from zbot.interfaces.yaml_message import Word


def read(line: str, **options: Any) -> dict[str, Any]:
    found = LineReader(**options).read(line)
    return {name: value.value if isinstance(value, Word) else value for name, value, _ in found}


@pytest.mark.parametrize(
    ("line", "values"),
    [
        ("temperature: 23.5", {"temperature": 23.5}),
        ("temperature:23.5\r", {"temperature": 23.5}),
        ("temperature 23.5", {"temperature": 23.5}),
        ("temperature = 23", {"temperature": 23}),
        ("/left/distance: 12 cm", {"/left/distance": 12}),
        ("button: true", {"button": True}),
        ("state: open", {"state": "open"}),
        ("Soil moisture: 512", {"Soil moisture": 512}),
        ("t:23.5,h:41", {"t": 23.5, "h": 41}),
        ("t:23.5\th:41\tp:-1", {"t": 23.5, "h": 41, "p": -1}),
        ("Humidity: 41.00 %  Temperature: 23.50 *C", {"Humidity": 41.0, "Temperature": 23.5}),
        ('{"temperature": 23.5, "humidity": 41}', {"": {"temperature": 23.5, "humidity": 41}}),
    ],
)
def test_a_line_has_names_and_values(line: str, values: dict[str, Any]) -> None:
    assert read(line) == values


@pytest.mark.parametrize(
    "line",
    [
        "Hello",
        "Connecting to sensor",
        "Sensor ready",
        "23.5",
        "WiFi connected: 192.168.1.7, channel 3",
        "ets Jul 29 2019 12:21:46",
        "rst:0x1 (POWERON_RESET),boot:0x13 (SPI_FAST_FLASH_BOOT)",
        "configsip: 0, SPIWP:0xee",
        "mode:DIO, clock div:1",
        "load:0x3fff0030,len:1344",
        "ho 0 tail 12 room 4",
        "entry 0x400805f0",
        "http://example.org",
    ],
)
def test_other_texts_are_no_values(line: str) -> None:
    assert read(line) == {}


def test_a_bare_number_is_for_the_topic_of_the_user() -> None:
    assert read("23.5", topic="temperature") == {"temperature": 23.5}
    assert read("Hello", topic="temperature") == {}
    assert read("humidity: 41", topic="temperature") == {"humidity": 41}


@pytest.mark.parametrize("line", ["1,2.5,-3", "1 2.5 -3", "1\t2.5\t-3", "1, 2.5, -3,"])
def test_several_numbers_have_the_names_of_the_user(line: str) -> None:
    assert read(line, names=("x", "y", "z")) == {"x": 1, "y": 2.5, "z": -3}


def test_a_wrong_number_of_values_is_named() -> None:
    with pytest.raises(UnreadableError, match="the number of values is not 3"):
        read("1,2", names=("x", "y", "z"))
    assert read("started", names=("x", "y", "z")) == {}


def test_every_text_is_for_a_topic_whose_type_is_string() -> None:
    types = TypeTable.read(["state:String", "log:String"])
    assert read("state:0x1 (a), b:c", type_of=types.find) == {"state": "0x1 (a), b:c"}
    assert read("any text", topic="log", type_of=types.find) == {"log": "any text"}


@pytest.mark.parametrize(
    "text", ['{"angular_velocity": {"z": 0.5}}', "{angular_velocity: {z: 0.5}}"]
)
def test_a_line_can_name_its_type(text: str) -> None:
    (reading,) = LineReader().read(f"/imu sensor_msgs/msg/Imu {text}")
    assert (reading.name, reading.value) == ("/imu", {"angular_velocity": {"z": 0.5}})
    assert str(reading.kind) == "sensor_msgs/msg/Imu"


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ('{"a": }', "it is not valid JSON"),
        ("/imu sensor_msgs/msg/Imuu {a: 1}", "the type is not known"),
        ("/imu sensor_msgs/msg/Imu {a: [}", "it is not valid YAML"),
        ("/imu sensor_msgs/msg/Imu {1: 2}", "the message is not a dictionary"),
    ],
)
def test_a_fault_in_a_form_has_a_reason(line: str, reason: str) -> None:
    with pytest.raises(UnreadableError, match=reason):
        read(line)


@pytest.mark.parametrize("pair", ["a:1.;", "a:.5,", "a:1 ", "a:1e5 b ", "a:on;", "a:nan x;"])
def test_a_long_line_that_ends_wrong_is_read_quickly(pair: str) -> None:
    begin = time.process_time()
    assert LineReader().read(pair * 5000 + "!:") == []
    assert time.process_time() - begin < allowed(1)
