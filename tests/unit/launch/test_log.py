"""Tests of `launch.logging`: the outputs and the format of a launch's log lines."""

from __future__ import annotations

import importlib
import logging
from pathlib import Path
from typing import TYPE_CHECKING
from unittest.mock import patch

import pytest

import zbot.compat
from zbot.launch import log
from zbot.launch.errors import LaunchUsageError
from zbot.launch.log_writer import LogWriter, OutputLines

if TYPE_CHECKING:
    from collections.abc import Iterator


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "base"))
    log.reset()
    log.launch_config.log_dir = str(tmp_path)
    yield tmp_path
    log.reset()


def _file(folder: Path, name: str = "launch.log") -> list[str]:
    log.launch_config.close()
    return (folder / name).read_text().splitlines()


def test_a_logger_writes_to_the_screen_and_to_the_file(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    logger = log.get_logger("driver")
    assert log.get_logger("driver") is logger
    logger.info("port %d", 3)
    logger.debug("hidden")
    assert capsys.readouterr().out == "[INFO] [driver]: port 3\n"
    [line] = _file(folder)
    assert line.endswith(" [INFO] [driver]: port 3")
    float(line.split()[0])


def test_a_logger_without_a_name_is_called_root_and_gets_no_library_lines(
    capsys: pytest.CaptureFixture[str],
) -> None:
    log.get_logger().warning("mine")
    logging.getLogger("some.library").warning("not mine")
    assert capsys.readouterr().out == "[WARNING] [root]: mine\n"


def test_the_level_applies_to_loggers_without_a_level(capsys: pytest.CaptureFixture[str]) -> None:
    first, second = log.get_logger("first"), log.get_logger("second")
    second.setLevel(logging.ERROR)
    log.launch_config.level = logging.DEBUG
    first.debug("seen")
    second.warning("hidden")
    LogWriter().debug("launch", "seen, too")
    assert capsys.readouterr().out == "[DEBUG] [first]: seen\n[DEBUG] [launch]: seen, too\n"


def test_the_launch_has_the_set_format(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log.launch_config.set_screen_format("{name} says {message}")
    log.launch_config.set_log_format("%(levelname)s|%(message)s", log_style="%")
    log.launch_config.log_file_name = "mine.log"
    LogWriter().warning("launch", "100% done")
    assert capsys.readouterr().out == "launch says 100% done\n"
    assert _file(folder, "mine.log") == ["WARNING|100% done"]


def test_a_factory_makes_the_handlers_of_files() -> None:
    written: list[tuple[str, str]] = []

    class Kept(log.handlers.Handler):  # type: ignore[name-defined, misc, unused-ignore]
        def __init__(self, path: str, encoding: str) -> None:
            super().__init__()
            self.path, self.encoding = path, encoding

        def emit(self, record: logging.LogRecord) -> None:
            written.append((Path(self.path).name, self.format(record)))

    log.launch_config.log_handler_factory = Kept
    stdout, _ = log.get_output_loggers("talker-1", {"stdout": ["log", "own_log"]})
    stdout.info("hello")
    assert written[0][0] == "launch.log"
    assert written[0][1].endswith(" hello")
    assert written[1] == ("talker-1-stdout.log", "hello")


@pytest.mark.parametrize("config", ["everywhere", {"stdin": "log"}, {"both": {"printer"}}])
def test_an_unknown_output_is_refused(config: object) -> None:
    with pytest.raises(LaunchUsageError):
        log.get_output_loggers("talker-1", config)  # type: ignore[arg-type]


def test_output_of_a_program_is_in_one_file_and_in_a_file_per_stream(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    stdout, stderr = log.get_output_loggers("talker-1", "full")
    stdout.info("out")
    stderr.info("err")
    assert capsys.readouterr().out == "out\nerr\n"
    assert _file(folder, "talker-1.log") == ["out", "err"]
    assert _file(folder, "talker-1-stdout.log") == ["out"]
    assert [line.split()[1] for line in _file(folder)] == ["out", "err"]


def test_only_a_form_without_a_name_has_a_style() -> None:
    with pytest.raises(ValueError, match="style"):
        log.launch_config.set_screen_format("default_with_timestamp", screen_style="%")


def test_the_folder_must_exist(folder: Path) -> None:
    with pytest.raises(ValueError, match="is not a directory"):
        log.launch_config.log_dir = str(folder / "nowhere")


def test_the_folder_is_made_in_the_place_of_the_environment(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    log.launch_config.log_dir = None
    made = Path(log.launch_config.log_dir)
    assert made.parent == folder / "base"
    log.get_logger("launch").info("here")
    monkeypatch.setenv("ZBOT_LOG_DIR", str(folder / "other"))
    log.get_logger("launch").info("there")
    assert len(_file(made)) == 1
    assert len(_file(folder / "other" / "latest")) == 1


def test_a_folder_that_cannot_be_made_is_reported_once(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "file").touch()
    monkeypatch.setenv("ZBOT_LOG_DIR", str(folder / "file"))
    log.launch_config.log_dir = None
    writer = LogWriter()
    writer.info("launch", "one")
    writer.info("launch", "two")
    said = capsys.readouterr().out
    assert said.count("cannot write log files to") == 1
    assert said.endswith("[INFO] [launch]: one\n[INFO] [launch]: two\n")
    assert writer.folder is None


def test_launch_logging_is_this_module() -> None:
    zbot.compat.install_names()
    assert importlib.import_module("launch.logging") is log
    assert importlib.import_module("launch.logging.handlers") is log.handlers
    with patch("launch.logging._make_unique_log_dir", return_value="/a/fake"):
        log.launch_config.log_dir = None
        assert log.launch_config.log_dir == "/a/fake"
    log.launch_config.log_dir = None


def test_output_in_many_parts_becomes_lines(capsys: pytest.CaptureFixture[str]) -> None:
    sinks = {"stdout": frozenset({"screen"}), "stderr": frozenset[str](), "both": frozenset[str]()}
    lines = OutputLines("a", sinks, LogWriter(), "{line}")
    for data in (b"on", b"", b"e\r\ntwo\nthr", b"\xc3", b"\xa9e", b"\n", b"\nfive"):
        lines.feed(1, data)
    lines.close()
    assert capsys.readouterr().out.splitlines() == ["one", "two", "thrée", "", "five"]
