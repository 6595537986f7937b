"""Tests of the verbs that work with files."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest

from tests.cli.bag.programs import grow, recording, text_bag
from tests.cli.command import zbot
from zbot import bag as bags

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start


@pytest.mark.usefixtures("robot")
def test_info_shows_the_recording(start: Start, bag: Path) -> None:
    program = recording(start, "/chatter", "--custom-data", "room=12", "class=4b")
    grow(bag)
    assert program.stop() == 0
    shown = zbot("bag", "info", str(bag))
    assert (shown.code, shown.err) == (0, "")
    lines = shown.out.splitlines()
    assert lines[:2] == ["", "Files:             lesson_0.mcap"]
    assert lines[9].startswith("Topic information: Topic: /chatter | Type: std_msgs/msg/String |")
    assert zbot("bag", "info", str(bag), "-t").out == "/chatter\n"
    assert "Size Contribution: " in zbot("bag", "info", str(bag), "-v").out
    single = zbot("bag", "info", str(bag / "lesson_0.mcap"))
    assert single.out.splitlines()[8:] == lines[8:]
    facts = json.loads(zbot("bag", "info", str(bag), "--json").out)
    assert facts["custom_data"] == {"room": "12", "class": "4b"}


def test_reindex_convert_and_list(bag: Path, tmp_path: Path) -> None:
    text_bag(bag, "one", "two")
    (bag / "metadata.yaml").unlink()
    assert "has no metadata.yaml" in zbot("bag", "info", str(bag)).err
    done = zbot("bag", "reindex", str(bag))
    assert (done.code, done.out) == (0, f"metadata.yaml of {bag}: 2 messages\n")
    assert zbot("bag", "info", str(bag)).err == ""
    (tmp_path / "out.yaml").write_text("output_bags: [{uri: copy, all: true}]")
    done = zbot("bag", "convert", "-i", "lesson", "mcap", "-o", "out.yaml", cwd=tmp_path)
    assert (done.code, done.out, done.err) == (0, "copy: 2 messages\n", "")
    assert [message.data for _, message, _ in bags.read(tmp_path / "copy")] == ["one", "two"]
    assert zbot("bag", "list", "storage").out == "mcap\nsqlite3\n"
    listed = json.loads(zbot("bag", "list", "storage", "--json").out)
    assert [plugin["name"] for plugin in listed] == ["mcap", "sqlite3"]
    assert zbot("bag", "list", "compressor", "-v").out.splitlines()[1] == "name: zstd"
