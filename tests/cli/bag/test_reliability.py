"""Tests of recordings that end badly."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

import pytest

from tests.cli.bag.programs import grow, recording
from tests.cli.command import zbot
from zbot import bag as bags

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start


@pytest.mark.usefixtures("robot")
def test_a_killed_recording_can_be_read(start: Start, bag: Path) -> None:
    program = recording(start, "-a")
    grow(bag)
    grow(bag)
    program.process.kill()
    program.wait()
    numbers = [int(message.data) for _, message, _ in bags.read(bag, ["/chatter"])]
    assert len(numbers) > 5
    shown = zbot("bag", "info", str(bag))
    assert shown.code == 0
    assert "the file has no end" in shown.err
    assert f"Topic: /chatter | Type: std_msgs/msg/String | Count: {len(numbers)} " in shown.out


@pytest.mark.usefixtures("robot")
def test_a_removed_folder_ends_the_recording_with_one_sentence(start: Start, bag: Path) -> None:
    program = recording(start, "/chatter")
    grow(bag)
    if sys.platform == "win32":
        pytest.skip("Windows does not remove an open file")
    bag.rename(bag.with_name("moved"))
    assert program.wait() == 1
    assert program.lines[-1] == "cannot write the bag 'lesson': its folder was removed"
    assert list(bags.read(bag.with_name("moved")))


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX limits")
@pytest.mark.usefixtures("robot")
def test_a_full_disk_ends_the_recording_with_one_sentence(start: Start, bag: Path) -> None:
    record = f"{sys.executable} -m zbot_cli bag record -o lesson --topics /chatter /scan"
    limited = f"ulimit -f 32; exec {record} --storage-preset-profile none"
    program = start("bash", "-c", limited)
    assert program.wait(30) == 1
    assert program.lines[-1] == "cannot write the bag 'lesson': File too large"
    numbers = [int(message.data) for _, message, _ in bags.read(bag, ["/chatter"])]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    assert len(numbers) > 5
