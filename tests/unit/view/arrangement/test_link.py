"""An arrangement is shared by a link."""

from __future__ import annotations

import base64
import zlib
from dataclasses import replace
from pathlib import Path

import pytest

from zbot.view.arrangement.arrangement import Arrangement, DisplayChoice
from zbot.view.arrangement.errors import ArrangementError
from zbot.view.arrangement.link import link_text, read_link
from zbot.view.arrangement.rviz_file import read_rviz_file

FILE = Path(__file__).with_name("example.rviz")


def packed(text: str) -> str:
    return base64.urlsafe_b64encode(zlib.compress(text.encode())).decode()


def test_a_link_has_the_displays_the_frame_and_the_camera() -> None:
    example = read_rviz_file(FILE)
    found = read_link(link_text(example))
    own = [replace(choice, raw={}) for choice in example.displays if choice.kind]
    assert [replace(choice, raw={}) for choice in found.displays] == own
    assert replace(found, displays=(), raw={}) == replace(example, displays=(), raw={}, misfits=())


def test_a_link_names_no_file_of_the_machine() -> None:
    robot = DisplayChoice("RobotModel", "a", file="/etc/passwd")
    assert read_link(link_text(Arrangement((robot,)))).displays == ()
    text = "Class: rviz/RobotModel, Description Source: File, Description File: /etc/passwd"
    (choice,) = read_link(packed(f"Visualization Manager: {{Displays: [{{{text}}}]}}")).displays
    assert choice.file == ""


def test_a_large_arrangement_needs_a_file() -> None:
    many = tuple(DisplayChoice("Path", hex(n * 7919**3), f"/t{n**9}") for n in range(1500))
    with pytest.raises(ArrangementError, match="save it in a file"):
        link_text(Arrangement(many))


@pytest.mark.parametrize(
    "text", ["", "é", "abc", packed("a: 1"), packed(" " * 2_000_000), packed("x" * 99)[:-20]]
)
def test_other_texts_are_refused(text: str) -> None:
    with pytest.raises(ArrangementError):
        read_link(text)
