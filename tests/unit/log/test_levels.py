from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot import log
from zbot.errors import ArgumentTypeError, InvalidNameError, ZbotError
from zbot.log import LoggingSeverity, get_logger
from zbot.log.errors import InvalidSeverityError

if TYPE_CHECKING:
    from collections.abc import Callable


DEBUG, INFO, WARN = LoggingSeverity.DEBUG, LoggingSeverity.INFO, LoggingSeverity.WARN
ERROR, FATAL, UNSET = LoggingSeverity.ERROR, LoggingSeverity.FATAL, LoggingSeverity.UNSET


def test_levels_are_inherited_by_dots() -> None:
    child = get_logger("robot").get_child("arm")
    log.set_logger_level("robot", WARN)
    assert child.name == "robot.arm"
    assert child.get_effective_level() is WARN
    assert log.get_logger_effective_level("robot.arm.hand") is WARN
    assert log.get_logger_effective_level("robotic") is INFO
    child.set_level(DEBUG)
    assert child.is_enabled_for(DEBUG)
    assert not get_logger("robot").is_enabled_for(INFO)
    child.set_level(UNSET)
    assert child.get_effective_level() is WARN


def test_own_level_is_unset_until_it_is_set() -> None:
    assert log.get_logger_level("robot") is UNSET
    assert log.get_logger_level("") is INFO
    log.set_logger_level("robot", 40)
    assert log.get_logger_level("robot") is ERROR


def test_empty_name_sets_the_level_of_all() -> None:
    log.set_logger_level("", ERROR)
    assert get_logger("anything").get_effective_level() is ERROR


def test_root_without_a_level_writes_every_line() -> None:
    log.set_logger_level("", UNSET)
    assert get_logger("anything").get_effective_level() is UNSET
    assert get_logger("anything").debug("heard")


def test_is_enabled_for_unset_is_false() -> None:
    assert not get_logger("sensor").is_enabled_for(UNSET)


def test_configure_sets_levels_and_switches(capsys: pytest.CaptureFixture[str]) -> None:
    logger = get_logger("sensor")
    log.configure({"": 40, "sensor": 10})
    assert (logger.get_effective_level(), log.get_logger_effective_level("x")) == (DEBUG, ERROR)
    log.configure(DEBUG)
    assert log.get_logger_effective_level("x") is DEBUG
    log.configure(stdout_enabled=False)
    assert logger.info("unseen") is True
    assert capsys.readouterr().err == ""


def test_clear_config_resets_levels() -> None:
    logger = get_logger("sensor")
    logger.set_level(FATAL)
    log.clear_config()
    assert logger.get_effective_level() is INFO


@pytest.mark.parametrize("text", ["info", "INFO", "Info"])
def test_severity_is_read_from_text(text: str) -> None:
    assert log.get_logging_severity_from_string(text) is INFO


@pytest.mark.parametrize(
    "call",
    [
        lambda: log.get_logging_severity_from_string("loud"),
        lambda: log.set_logger_level("sensor", 25),
        lambda: get_logger("sensor").set_level("debug"),  # type: ignore[arg-type]
        lambda: get_logger("sensor").log("text", 35),
        lambda: get_logger("sensor").is_enabled_for(-1),
        lambda: log.configure({"sensor": 1}),
    ],
)
def test_unknown_severity_is_refused(call: Callable[[], object]) -> None:
    with pytest.raises(InvalidSeverityError, match=r"use DEBUG \(10\)") as raised:
        call()
    assert isinstance(raised.value, (ValueError, RuntimeError))


@pytest.mark.parametrize(
    ("call", "error"),
    [
        (lambda: get_logger(""), InvalidNameError),
        (lambda: get_logger("sensor").get_child(""), InvalidNameError),
        (lambda: get_logger("sensor").get_child(None), InvalidNameError),  # type: ignore[arg-type]
        (lambda: get_logger(7), ArgumentTypeError),  # type: ignore[arg-type]
    ],
)
def test_logger_needs_a_name(call: Callable[[], object], error: type[ZbotError]) -> None:
    with pytest.raises(error):
        call()
