"""Tests of descriptions and conversions of bags."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import zbot.bag
from tests.unit.bag.messages import (
    write,
)
from zbot.bag import Reader, Writer
from zbot.bag.conversion import convert, read_outputs, reindex
from zbot.bag.description import SORT_KEYS, contributions, description, topic_names
from zbot.bag.errors import (
    BagReadError,
    BagValueError,
)
from zbot.bag.options import PlayOptions, RecordOptions, StorageOptions
from zbot.bag.writer import writer_for

from geometry_msgs.msg import TwistStamped, Vector3
from std_msgs.msg import Float64, String


def test_info_prints_the_lines_of_ros2(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TZ", "UTC")
    with Writer(path) as bag:
        bag.write("/turtle1/pose", TwistStamped(), 1570799349_120000000)
        bag.write("/turtle1/cmd_vel", Vector3(), 1570799397_590000000)
        bag.write("/turtle1/cmd_vel", Vector3(), 1570799397_590000000)
    with Reader(path) as read:
        lines = description(read.metadata).splitlines()
        assert topic_names(read.metadata, "count") == ["/turtle1/pose", "/turtle1/cmd_vel"]
        sizes, calls = contributions(read)
        verbose = description(read.metadata, sizes=sizes, calls=calls)
    assert lines[:2] == ["", "Files:             lesson_0.mcap"]
    assert lines[2].startswith("Bag size:          ")
    assert lines[3:6] == [
        "Storage id:        mcap",
        "ROS Distro:        kilted",
        "Duration:          48.470000000s",
    ]
    assert lines[6].startswith("Start:             Oct 1")
    assert lines[6].endswith("9.120000000 (1570799349.120000000)")
    assert lines[8:] == [
        "Messages:          3",
        f"Topic information: Topic: /turtle1/cmd_vel | Type: geometry_msgs/msg/Vector3 {count(2)}",
        f"{' ' * 19}Topic: /turtle1/pose | Type: geometry_msgs/msg/TwistStamped {count(1)}",
        "Service:           0",
        "Service information: ",
        "Actions:           0",
        "Action information: ",
    ]
    assert "| Count: 2 | Size Contribution: 56 B | Serialization" in verbose
    assert set(SORT_KEYS) == {"name", "type", "count", "serialization_format"}


def count(number: int) -> str:
    return f"| Count: {number} | Serialization Format: cdr"


def test_reindex_writes_the_same_metadata(path: Path) -> None:
    forms: list[dict[str, Any]] = [{}, {"compress_files": True}, {"max_duration_s": 0.001}]
    for number, options in enumerate(forms):
        folder = path / str(number)
        write(folder, [String(data="a"), Float64(), String()], custom_data={"a": "b"}, **options)
        before = (folder / "metadata.yaml").read_text()
        (folder / "metadata.yaml").write_text("broken")
        assert reindex(folder).message_count == 3
        assert (folder / "metadata.yaml").read_text() == before
    with pytest.raises(BagReadError, match="Must specify a bag directory"):
        reindex(path / "0" / "0_0.mcap.zstd")


def test_convert_merges_and_selects(path: Path, tmp_path: Path) -> None:
    write(tmp_path / "first", [String(data="a"), Float64(data=1.0)])
    write(tmp_path / "second", [Float64(data=2.0), String(data="b")])
    options = tmp_path / "out.yaml"
    options.write_text(
        f"output_bags:\n- {{uri: {path}, all_topics: true, exclude_topics: [/float64]}}\n"
        f"- {{uri: {tmp_path / 'late'}, regex: float, start_time_ns: 1, compression_mode: file}}\n"
    )
    with Reader(tmp_path / "first") as first, Reader(tmp_path / "second") as second:
        for output in read_outputs(options):
            convert([first, second], output)
    assert [m.data for _, m, _ in zbot.bag.read(path)] == ["a", "b"]
    assert [m.data for _, m, _ in zbot.bag.read(tmp_path / "late")] == [1.0]


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("a: 1", "the key output_bags has no list"),
        ("output_bags: []", "there is no bag"),
        ("output_bags: [{uri: a, colour: red}]", "does not know the key 'colour'"),
        ("output_bags: [{uri: a, storage_id: bag}]", "choose mcap or sqlite3"),
        ("output_bags: [{uri: a, regex: '('}]", "not a regular expression"),
        ("output_bags: [", "line 1"),
    ],
)
def test_wrong_output_options_are_one_sentence(path: Path, text: str, sentence: str) -> None:
    path.write_text(text)
    with pytest.raises(BagValueError, match=sentence):
        read_outputs(path)


def test_the_page_about_bags_has_programs_that_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    page = (Path(__file__).parents[3] / "docs" / "bags.md").read_text(encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    for block in page.split("```python\n")[1:]:
        exec(block.split("```")[0], {})
    first, second = capsys.readouterr().out.splitlines()
    assert first.startswith("/chatter hello ")
    assert second == "1.0 0.0"


def test_the_storage_settings_of_rosbag2_have_an_effect(tmp_path: Path) -> None:
    config = tmp_path / "config.yaml"
    config.write_text("compression: Gzip")
    storage = StorageOptions(str(tmp_path / "new"), storage_config_uri=str(config))
    with pytest.raises(BagValueError, match="compression cannot be 'Gzip'"):
        writer_for(storage, RecordOptions())


def test_options_without_names_select_everything() -> None:
    assert PlayOptions().selection().takes("/a", "std_msgs/msg/String")
    narrow = PlayOptions(topics_to_filter=["a"], exclude_regex_to_filter="b")
    assert [narrow.selection().takes(name, "") for name in ("/a", "/b", "/c")] == [
        True,
        False,
        False,
    ]


def test_the_last_rule_renames_a_topic() -> None:
    options = PlayOptions(topic_remapping_options=["--ros-args", "-r", "a:=b", "/a:=c"])
    assert (options.remap("/a"), options.remap("/d")) == ("/c", "/d")
