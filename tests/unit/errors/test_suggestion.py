"""Tests for the suggestions of similar names."""

from __future__ import annotations

import re
from functools import cache

import pytest
from hypothesis import given
from hypothesis import strategies as st

from zbot.errors import suggestion
from zbot.errors.suggestion import (
    KnownNames,
    did_you_mean,
    nearest,
    question,
    similar_names,
)


@pytest.mark.parametrize(
    ("name", "candidates", "expected"),
    [
        ("/temprature", ["/temperature", "/humidity"], "/temperature"),
        ("/cmd_vle", ["/cmd_vel", "/odom"], "/cmd_vel"),
        ("/turtle1/cmdvel", ["/turtle1/cmd_vel", "/turtle1/pose"], "/turtle1/cmd_vel"),
        ("topci", ["topic", "action"], "topic"),
        ("tpocis", ["topic", "action"], None),
        ("/scan", ["/scam", "/scans"], "/scam"),
        ("/robot1/scan", ["/robot2/scan"], None),
        ("/a", ["/b"], None),
        ("set_parameter", ["get_parameter", "set_parameters"], "set_parameters"),
        ("/Scan", ["/scan"], "/scan"),
        ("/scan", ["/scan"], None),
        ("/scan", ["/image_raw"], None),
        ("/scan", [], None),
    ],
)
def test_nearest_finds_typos_and_nothing_else(
    name: str, candidates: list[str], expected: str | None
) -> None:
    assert nearest(name, candidates) == expected


@given(st.text("ab1/", max_size=9), st.lists(st.text("ab1/", max_size=9), max_size=9))
def test_nearest_is_the_known_name_with_the_fewest_edits(name: str, known: list[str]) -> None:
    patterns = {text: re.sub(r"\d+", "0", text) for text in [name, *known]}
    edits = {text: edits_between(name, text) for text in known if patterns[text] != patterns[name]}
    near = [text for text in edits if edits[text] <= min(2, len(name.replace("/", "")) // 3)]
    assert nearest(name, known) == min(near, key=lambda text: (edits[text], text), default=None)


@cache
def edits_between(a: str, b: str) -> int:
    """Return the number of edits by the definition, which is slow."""
    if not a or not b:
        return len(a) + len(b)
    fewest = [
        edits_between(a[1:], b) + 1,
        edits_between(a, b[1:]) + 1,
        edits_between(a[1:], b[1:]) + (a[0] != b[0]),
    ]
    if a[:2] == b[1::-1] and len(a) > 1:
        fewest.append(edits_between(a[2:], b[2:]) + 1)
    return min(fewest)


def test_few_names_of_many_robots_are_compared_letter_by_letter(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    compared: list[str] = []

    def far(name: str, _other: str, limit: int) -> int:
        compared.append(name)
        return limit + 1

    monkeypatch.setattr(suggestion, "_edit_distance", far)
    parts = ("scan", "odom", "imu", "camera/info", "joint_states")
    known = KnownNames(f"/robot{number}/{part}" for number in range(100) for part in parts)
    for number in range(100):
        for name in ("cmd_vel", "goal_pose", "camera/info"):
            assert known.nearest(f"/robot{number}/{name}") is None
    assert len(compared) < 300  # of 150,000 pairs


@pytest.mark.parametrize(
    ("name", "known", "expected"),
    [
        ("talkers", ["walker", "talker"], ("talker", "walker")),
        ("Talker", ["talker"], ("talker",)),
        ("X", ["x", "y"], ("x",)),
        ("arg", ["name", "arguments"], ("arguments",)),
        ("executable_name", ["exec", "executable"], ("executable", "exec")),
        ("/scan", ["/odom", "/bot/scan"], ("/bot/scan",)),
        ("/bot/scan", ["/scan", "/odom"], ("/scan",)),
        ("turtle_node", ["turtlesim_node", "sensor"], ("turtlesim_node",)),
        ("/robot1/scan", ["/robot2/scan"], ()),
        ("x", ["yaw", "xacro"], ()),
        ("talker", ["talker"], ()),
        ("Wave", ["Wave", "wave"], ("wave",)),
        ("", ["talker"], ()),
    ],
)
def test_similar_names_are_typos_abbreviations_and_names_of_other_namespaces(
    name: str, known: list[str], expected: tuple[str, ...]
) -> None:
    assert similar_names(name, known, 2) == expected


def test_the_question_quotes_each_suggestion() -> None:
    assert question(["a", "b"], "; ") == "; did you mean 'a' or 'b'?"
    assert question([], "; ") == ""
    assert did_you_mean("talkr", ["talker", "walker"]) == "did you mean 'talker'?"
    assert did_you_mean("sensor", ["talker"], before="; ") == ""


@pytest.mark.parametrize("known", [("Node", "node"), ("node", "Node")])
def test_a_class_is_suggested_for_a_class_and_a_module_for_a_module(known: tuple[str, ...]) -> None:
    assert similar_names("Nod", known) == ("Node",)
    assert similar_names("nod", known) == ("node",)
