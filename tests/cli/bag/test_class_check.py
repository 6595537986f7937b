"""Tests of `zbot class check --bag`: assignments that were handed in as bags."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from zbot.bag import Writer

from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from pathlib import Path

EXPECTED = "publishes std_msgs/String on /student_id at >= 1 Hz"


def handed_in(path: Path, rate_hz: float, topic: str = "/student_id") -> Path:
    with Writer(path) as bag:
        for number in range(10):
            bag.write(topic, String(data="S1"), int(number / rate_hz * 1e9))
    return path


def test_handed_in_bags_are_marked(tmp_path: Path) -> None:
    handed_in(tmp_path / "ana", 1.0)
    handed_in(tmp_path / "ben", 0.5)
    handed_in(tmp_path / "cem", 1.0, "/student_ID")
    bags = ["--bag", "ana", "ben", "cem"]
    done = zbot("class", "check", EXPECTED, *bags, cwd=tmp_path)
    assert (done.code, done.err) == (1, "")
    assert done.out.splitlines() == [
        "ok    ana",
        "FAIL  ben  /student_id has 0.50 Hz, not >= 1 Hz",
        "FAIL  cem  nobody publishes /student_id; did you mean '/student_ID'?",
        "1 of 3 pass",
    ]
    verdicts = json.loads(zbot("class", "check", EXPECTED, *bags, "--json", cwd=tmp_path).out)
    assert [verdict["passes"] for verdict in verdicts] == [True, False, False]
    assert zbot("class", "check", EXPECTED, "--bag", "ana", cwd=tmp_path).code == 0


def test_a_bag_of_the_class_has_the_students_number_and_name(tmp_path: Path) -> None:
    facts = {"student_number": "17", "student_name": "Ana"}
    with Writer(tmp_path / "17_Ana", custom_data=facts) as bag:
        bag.write("/student_id", Int32(data=1), 0)
    done = zbot("class", "check", EXPECTED, "--bag", "17_Ana", cwd=tmp_path)
    assert done.out.splitlines() == [
        "FAIL   17  Ana  /student_id has type std_msgs/msg/Int32, not std_msgs/msg/String",
        "0 of 1 pass",
    ]


def test_recorded_calls_show_a_service(tmp_path: Path) -> None:
    with Writer(tmp_path / "bag") as bag:
        bag.write("/lamp/_service_event", SetBool.Event(), 1)
    expected = "serves std_srvs/SetBool on /lamp"
    assert zbot("class", "check", expected, "--bag", "bag", cwd=tmp_path).code == 0


@pytest.mark.parametrize(
    ("expected", "sentence"),
    [
        ("runs /talker", "`runs` cannot be checked in a bag"),
        ("subscribes std_msgs/String on /a", "`subscribes` cannot be checked in a bag"),
        (EXPECTED, "Bag path 'none' does not exist!"),
    ],
)
def test_what_a_bag_does_not_show_is_one_sentence(
    tmp_path: Path, expected: str, sentence: str
) -> None:
    done = zbot("class", "check", expected, "--bag", "none", cwd=tmp_path)
    assert done.code == 1
    assert sentence in done.err
