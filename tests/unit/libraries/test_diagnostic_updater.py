from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from zbot.errors import WrongTypeError
from zbot.libraries import diagnostic_updater
from zbot.libraries.diagnostic_updater import (
    CompositeDiagnosticTask,
    DiagnosedPublisher,
    DiagnosticStatusWrapper,
    FrequencyStatus,
    FrequencyStatusParam,
    FunctionDiagnosticTask,
    Heartbeat,
    TimeStampStatus,
    TimeStampStatusParam,
    Updater,
)
from zbot.time import S_TO_NS, Time

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from sensor_msgs.msg import Temperature

if TYPE_CHECKING:
    from tests.conftest import MakeContext

OK, WARN, ERROR = DiagnosticStatus.OK, DiagnosticStatus.WARN, DiagnosticStatus.ERROR


class Now:
    """Clock that a test moves."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.seconds = 1000.0
        monkeypatch.setattr(diagnostic_updater, "_now_ns", lambda: int(self.seconds * S_TO_NS))


@pytest.fixture
def now(monkeypatch: pytest.MonkeyPatch) -> Now:
    return Now(monkeypatch)


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        ((OK, "a"), (OK, "b"), (OK, "a; b")),
        ((OK, "a"), (WARN, "b"), (WARN, "b")),
        ((WARN, "a"), (OK, "b"), (WARN, "a")),
        ((ERROR, "a"), (WARN, "b"), (ERROR, "a; b")),
        ((WARN, ""), (ERROR, "b"), (ERROR, "b")),
    ],
)
def test_the_worse_summary_is_kept(first: Any, second: Any, expected: Any) -> None:
    stat = DiagnosticStatusWrapper()
    stat.summary(*first)
    stat.mergeSummary(DiagnosticStatus(level=second[0], message=second[1]))
    assert (stat.level, stat.message) == expected
    stat.clearSummary()
    assert (stat.level, stat.message) == (OK, "")


def test_values_of_any_type_are_added_as_text() -> None:
    stat = DiagnosticStatusWrapper()
    stat.add("volts", 12.5)
    stat.add("on", True)
    assert [(pair.key, pair.value) for pair in stat.values] == [
        ("volts", "12.5"),
        ("on", "True"),
    ]


@pytest.mark.parametrize(
    ("ticks", "expected"),
    [(0, (ERROR, "No events recorded.")), (8, (WARN, "Frequency too low."))]
    + [(count, (OK, "Desired frequency met")) for count in (9, 22)]
    + [(23, (WARN, "Frequency too high."))],
)
def test_a_frequency_has_limits_with_a_tolerance(now: Now, ticks: int, expected: Any) -> None:
    task = FrequencyStatus(FrequencyStatusParam({"min": 1, "max": 2}, 0.1, 2))
    now.seconds += 4
    task.run(DiagnosticStatusWrapper())
    for _ in range(ticks):
        task.tick()
    now.seconds += 6
    stat = task.run(DiagnosticStatusWrapper())
    assert (stat.level, stat.message) == expected
    assert stat.values[0].value == str(ticks)


def test_only_the_last_runs_count(now: Now) -> None:
    task = FrequencyStatus(FrequencyStatusParam({"min": 1}, 0.0, 1))
    task.tick()
    for level in (OK, ERROR):
        now.seconds += 1
        assert task.run(DiagnosticStatusWrapper()).level == level


@pytest.mark.parametrize(
    ("stamp", "message"),
    [
        (1001.5, "Timestamps too far in future seen."),
        (1000.5, "Timestamps are reasonable."),
        (Time(seconds=996), "Timestamps are reasonable."),
        (Time(seconds=994), "Timestamps too far in past seen."),
        (0.0, "Zero timestamp seen."),
        (None, "No data since last update."),
    ],
)
def test_time_stamps_must_be_near_the_present(now: Now, stamp: Any, message: str) -> None:
    assert now.seconds == 1000
    task = TimeStampStatus()
    if stamp is not None:
        task.tick(stamp)
    assert task.run(DiagnosticStatusWrapper()).message == message
    assert task.run(DiagnosticStatusWrapper()).message == "No data since last update."


class Robot(zbot.Node):
    """Node whose statuses are caught before they are published."""

    def __init__(self, context: zbot.Context, **options: Any) -> None:
        super().__init__("robot", context=context, namespace="/lab", **options)
        self.updater = Updater(self, period=60.0)
        self.updater.hwid = "serial 7"
        self.sent: list[DiagnosticArray] = []
        self.updater.publisher.publish = self.sent.append  # type: ignore[assignment,method-assign]


@pytest.fixture
def robot(make_context: MakeContext) -> Robot:
    return Robot(make_context())


def battery(stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
    stat.summary(WARN, "low")
    return stat


def test_statuses_have_the_names_of_node_and_task(robot: Robot) -> None:
    robot.updater.add("battery", battery)
    robot.updater.add(Heartbeat())
    robot.updater.force_update()
    starting, _, array = robot.sent
    assert starting.status[0].message == "Node starting up"
    found = [
        (status.name, status.level, status.message, status.hardware_id) for status in array.status
    ]
    assert found == [
        ("robot: battery", WARN, "low", "serial 7"),
        ("robot: Heartbeat", OK, "Alive", "serial 7"),
    ]
    assert robot.updater.removeByName("battery")
    assert not robot.updater.removeByName("battery")
    robot.updater.broadcast(ERROR, "going down")
    assert [(status.name, status.message) for status in robot.sent[-1].status] == [
        ("robot: Heartbeat", "going down")
    ]


def test_parameters_change_the_period_and_the_names(make_context: MakeContext) -> None:
    overrides = [
        zbot.Parameter("diagnostic_updater.period", value=7.5),
        zbot.Parameter("diagnostic_updater.use_fqn", value=True),
    ]
    robot = Robot(make_context(), parameter_overrides=overrides)
    robot.updater.broadcast(OK, "")
    robot.updater.add(Heartbeat())
    assert (robot.updater.period, robot.sent[-1].status[0].name) == (7.5, "/lab/robot: Heartbeat")
    robot.updater.period = 2.0
    assert [timer.timer_period_ns for timer in robot.timers] == [2 * S_TO_NS]


def test_an_updater_without_hardware_id_says_so_once(robot: Robot, logged: list[Any]) -> None:
    robot.updater.setHardwareID("")
    robot.updater.update()
    robot.updater.update()
    assert sum("No HW_ID was set" in record.message for record in logged) == 1


def test_a_function_without_return_is_named(robot: Robot) -> None:
    robot.updater.add("motor", lambda _: None)
    with pytest.raises(WrongTypeError, match="'motor' must end with `return stat`"):
        robot.updater.update()


def test_a_composite_task_merges_its_tasks() -> None:
    both = CompositeDiagnosticTask("both")
    both.addTask(FunctionDiagnosticTask("battery", battery))
    both.addTask(Heartbeat())
    stat = both.run(DiagnosticStatusWrapper())
    assert (stat.level, stat.message) == (WARN, "low")


def test_a_publisher_is_checked(robot: Robot, now: Now) -> None:
    publisher = robot.create_publisher(Temperature, "heat", 1)
    limits = FrequencyStatusParam({"min": 0.1, "max": 5.0})
    checked = DiagnosedPublisher(publisher, robot.updater, limits, TimeStampStatusParam())
    now.seconds += 1
    message = Temperature()
    message.header.stamp = Time(seconds=1000).to_msg()
    checked.publish(message)
    robot.updater.update()
    (status,) = robot.sent[-1].status
    assert (status.name, status.level) == ("robot: /lab/heat topic status", OK)
    assert status.message == "Desired frequency met; Timestamps are reasonable."
