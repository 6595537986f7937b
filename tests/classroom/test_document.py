"""Commands and configuration that docs/classroom.md shows."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import zenoh

from tests.classroom.local_machine import LocalMachine
from tests.classroom.talk import free_port
from zbot_cli.main import NOUNS
from zbot_cli.nouns import load, verbs

DOCUMENT = (Path(__file__).parents[2] / "docs" / "classroom.md").read_text("utf-8")


def test_a_zenoh_router_replaces_the_hub(tmp_path: Path) -> None:
    (text,) = re.findall(r"^```json5\n(.*?)^```", DOCUMENT, re.MULTILINE | re.DOTALL)
    port = free_port()
    config = zenoh.Config.from_json5(text.replace("0.0.0.0:7447", f"127.0.0.1:{port}"))
    laptop = LocalMachine(tmp_path)
    with zenoh.open(config):
        assert "joined 127.0.0.1" in laptop.succeed("join", f"127.0.0.1:{port}")
        assert "linked" in laptop.succeed("status")
        laptop.succeed("leave")


@pytest.mark.parametrize(
    "line", sorted(set(re.findall(r"zbot ((?:class|share) [a-z]+)", DOCUMENT)))
)
def test_every_command_in_it_exists(line: str) -> None:
    noun, verb = line.split()
    assert noun in NOUNS
    if noun == "class":
        assert verb in verbs(load(noun))
