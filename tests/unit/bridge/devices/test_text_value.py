from __future__ import annotations

import math
import time

import pytest

from zbot.bridge.devices.text_value import json_word, topic_name, word_of


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("23", 23),
        ("-7", -7),
        ("23.50", 23.5),
        (".5", 0.5),
        ("1e3", 1000.0),
        ("true", True),
        ("OFF", False),
        ("23.5 C", 23.5),
        ("41%", 41),
        ("1013 hPa", 1013),
        ("open", "open"),
        ("12:30", "12:30"),
        ("1_000", "1_000"),
        ("\u0663", "\u0663"),
        ("", ""),
    ],
)
def test_a_text_is_a_number_a_bool_or_a_word(text: str, value: object) -> None:
    word = word_of(text)
    assert (word.value, type(word.value), word.text) == (value, type(value), text)


@pytest.mark.parametrize("text", ["9" * 60_000 + "x", "9" * 60_000 + "\n"])
def test_a_long_number_is_read_in_a_time_that_grows_with_its_length(text: str) -> None:
    began_s = time.thread_time()
    assert word_of(text).text == text
    assert time.thread_time() - began_s < 0.5  # it was 100 s


def test_a_sensor_without_a_value_prints_nan() -> None:
    assert math.isnan(word_of("nan").value)


def test_on_and_off_in_json_are_bools() -> None:
    assert [json_word(value).value for value in ("ON", "off", "open", 5, True)] == [
        *(True, False, "open", 5, True)
    ]


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("temperature", "temperature"),
        ("/imu", "/imu"),
        ("home/living-room/temp", "home/living_room/temp"),
        ("Soil moisture", "Soil_moisture"),
        ("home//1/a/", "home/_1/a"),
        ("2nd", "_2nd"),
        ("\u00e9t\u00e9", "_t_"),
        ("-", ""),
        ("", ""),
    ],
)
def test_a_text_becomes_a_valid_topic_name(text: str, name: str) -> None:
    assert topic_name(text) == name
