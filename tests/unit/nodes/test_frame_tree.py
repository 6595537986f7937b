"""Tests of the drawing of frames."""

from __future__ import annotations

import time
from xml.etree import ElementTree as ET

import pytest

from tests.conftest import allowed
from zbot.errors import WrongValueError
from zbot.tf2 import BufferCore
from zbot_nodes.frames.frame_tree import FrameTree

from geometry_msgs.msg import TransformStamped


def tree(*pairs: str) -> FrameTree:
    buffer = BufferCore()
    for pair in pairs:
        parent, child = pair.split()
        frame = TransformStamped(child_frame_id=child)
        frame.header.frame_id = parent
        frame.header.stamp.sec = 5
        frame.transform.rotation.w = 1.0
        buffer.set_transform(frame, "a <robot>")
    return FrameTree.of(buffer.all_frames_as_yaml(), 7.5)


def test_a_tree_is_written_for_graphviz() -> None:
    dot = tree("map odom", "odom base", "odom arm").to_dot()
    assert '"odom" -> "base"[label=" Broadcaster: a <robot>\\n' in dot
    assert '}->"map";' in dot
    assert "Recorded at time: 7.5" in dot
    assert "No tf data received" in tree().to_dot()


def test_a_tree_is_drawn_with_children_below_their_parent() -> None:
    root = ET.fromstring(tree("map odom", "odom base", "odom arm", "x y").to_svg())
    texts = {element.text: element for element in root.iter("{http://www.w3.org/2000/svg}text")}
    assert {"map", "odom", "base", "arm", "x", "y", "from a <robot>"} <= set(texts)
    place = {
        name: (float(texts[name].get("x", 0)), float(texts[name].get("y", 0))) for name in texts
    }
    assert place["map"][1] < place["odom"][1] < place["base"][1] == place["arm"][1]
    assert place["arm"][0] < place["odom"][0] < place["base"][0]
    assert "No tf data received" in tree().to_svg()


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("a: {", "line 1"),
        ("- a", "it has no frames"),
        ("a: {parent: b}", "a fact about the frame 'a' is missing"),
    ],
)
def test_a_text_that_is_no_list_of_frames_is_refused(text: str, reason: str) -> None:
    with pytest.raises(WrongValueError, match=reason):
        FrameTree.of(text, 0.0)


def test_several_roots_are_found() -> None:
    assert tree("map odom", "x y").roots == ["map", "x"]


def test_a_long_chain_is_drawn() -> None:
    chain = tree(*(f"f{number} f{number + 1}" for number in range(1500)))
    assert chain.to_svg().count("<rect") == 1501


def test_thousands_of_frames_of_one_parent_are_drawn_quickly() -> None:
    keys = ("broadcaster", "rate", "buffer_length", "most_recent_transform")
    facts = dict.fromkeys((*keys, "oldest_transform"), 1) | {"parent": "root"}
    found = FrameTree({f"frame{number}": facts for number in range(20_000)}, 0.0)
    begin = time.process_time()
    assert found.to_svg().count("<line") == 20_000
    assert time.process_time() - begin < allowed(3)
