"""Tests of the command line of `zbot bridge`, without a genuine ROS 2."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot

if TYPE_CHECKING:
    from tests.cli.conftest import Command


def test_without_a_genuine_rclpy_one_sentence_says_what_to_do(zbot_command: Command) -> None:
    result = zbot_command("bridge", "dds")
    assert (result.code, result.out) == (1, "")
    assert result.err.startswith(
        "this Python cannot import ROS 2's rclpy (only zbot's own rclpy is"
    )
    assert len(result.err.splitlines()) == 1


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--topics", "/scan:up"), "cannot use '/scan:up': after the colon, write in"),
        (("--rate", "/image"), "cannot use '/image': write a topic, an equals sign"),
        (("--prefix", "1robot"), "1robot"),
    ],
)
def test_wrong_options_are_one_sentence(
    zbot_command: Command, words: tuple[str, ...], told: str
) -> None:
    result = zbot_command("bridge", "dds", *words)
    assert result.code == 1
    assert told in result.err
    assert "Traceback" not in result.err


def test_a_wrong_domain_in_the_environment_is_one_sentence(
    zbot_command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", "many")
    result = zbot_command("bridge", "dds")
    assert result.code == 1
    assert "ROS_DOMAIN_ID" in result.err


# Zenoh has no such protocol, so no name is looked up.
@pytest.mark.parametrize("address", ['pigeon/a"b', r"pigeon/a\b", "pigeon/a;b"])
def test_an_address_is_quoted_in_the_configuration(address: str) -> None:
    result = zbot("bridge", "rmw_zenoh", "--connect", address)
    assert result.code == 1
    assert f"no Zenoh router answers on {address}, so" in result.err
    assert "Traceback" not in result.err


def test_a_wrong_address_is_one_sentence(zbot_command: Command) -> None:
    result = zbot_command("bridge", "rmw_zenoh", "--connect", "robot:99999")
    assert (result.code, result.out) == (1, "")
    assert result.err == (
        "'robot:99999' is not an address: its port must be a number from 1 to 65535\n"
    )
