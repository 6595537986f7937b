from __future__ import annotations

import threading
from typing import TYPE_CHECKING

import pytest

from zbot import log
from zbot.log import LoggingSeverity, get_logger
from zbot.log.registry import LogRegistry

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.unit.log.conftest import Logged


ERROR = LoggingSeverity.ERROR


@pytest.fixture
def records() -> Iterator[list[log.Record]]:
    received: list[log.Record] = []
    sink = received.append
    log.add_sink("robot", sink)
    yield received
    log.remove_sink("robot", sink)


def test_lines_can_be_excluded_from_sinks(records: list[log.Record]) -> None:
    logger = get_logger("robot")
    with log.sinks_disabled():
        logger.info("unheard")
    logger.info("heard")
    assert [record.message for record in records] == ["heard"]


def test_sink_gets_the_lines_of_its_logger_and_children(records: list[log.Record]) -> None:
    for name in ("robot", "robot.arm", "robotic", "other"):
        get_logger(name).info(name)
    assert [record.name for record in records] == ["robot", "robot.arm"]


def test_record_has_the_place_of_the_log_call(records: list[log.Record]) -> None:
    get_logger("robot").error("text")
    record = records[0]
    assert (record.level, record.message) == (ERROR, "text")
    assert (record.file, record.function) == (
        __file__,
        test_record_has_the_place_of_the_log_call.__name__,
    )
    assert record.line == test_record_has_the_place_of_the_log_call.__code__.co_firstlineno + 1
    assert record.stamp_ns > 1_700_000_000 * 10**9


def test_sink_works_for_loggers_made_before_it() -> None:
    logger, received = get_logger("late"), list[log.Record]()
    sink = received.append
    log.add_sink("late", sink)
    logger.info("heard")
    log.remove_sink("late", sink)
    log.remove_sink("late", sink)
    logger.info("not heard")
    assert [record.message for record in received] == ["heard"]


def test_a_new_sink_does_not_renew_other_loggers() -> None:
    registry = LogRegistry()
    registry.add_sink("", id)
    states = [registry.state_of(name) for name in ("robot", "robot.arm", "robotic", "other")]
    before = [state.sinks for state in states]
    for change in (registry.add_sink, registry.remove_sink):
        change("robot", repr)
        after = [state.sinks for state in states]
        changed = [now is not then for now, then in zip(after, before, strict=True)]
        assert changed == [True, True, False, False]
    assert after == before


def test_sinks_can_be_switched_off(records: list[log.Record]) -> None:
    log.configure(rosout_enabled=False)
    get_logger("robot").info("text")
    assert records == []


def test_failing_sink_is_reported_once_and_keeps_getting_lines(
    records: list[log.Record], logged: Logged
) -> None:
    def fail(record: log.Record) -> None:
        raise OSError(f"no network for {record.message}")

    log.add_sink("robot.arm", fail)
    for number in (1, 2):
        get_logger("robot.arm").info(number)
    log.remove_sink("robot.arm", fail)
    assert logged() == [
        "1",
        "a sink of logger 'robot.arm' failed (more errors are hidden): OSError('no network for 1')",
        "2",
    ]
    assert [record.message for record in records] == ["1", "2"]


def test_lines_logged_by_a_sink_do_not_reach_sinks(logged: Logged) -> None:
    logger = get_logger("loop")

    def sink(record: log.Record) -> None:
        logger.info(f"sent {record.message}")

    log.add_sink("loop", sink)
    logger.info("text")
    log.remove_sink("loop", sink)
    assert logged() == ["text", "sent text"]


def test_a_sink_call_does_not_disable_sinks_of_other_threads() -> None:
    received: list[str] = []

    def sink(record: log.Record) -> None:
        received.append(record.message)
        if record.message == "outer":
            thread = threading.Thread(target=get_logger("busy").info, args=["inner"])
            thread.start()
            thread.join()

    log.add_sink("busy", sink)
    get_logger("busy").info("outer")
    log.remove_sink("busy", sink)
    assert received == ["outer", "inner"]
