"""Tests for the suggestions of similar names."""

from __future__ import annotations

import pytest

from zbot.errors.suggestion import did_you_mean, nearest, question, similar_names


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
