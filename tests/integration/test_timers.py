"""Tests of timers and rates in the machine's time and in simulated time."""

from __future__ import annotations

import statistics
import threading
import time
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import allowed, wait_until
from zbot.errors import ArgumentTypeError, InvalidHandleError
from zbot.executor.clock import Clock
from zbot.executor.errors import RateInterruptedError
from zbot.node.errors import InvalidPeriodError
from zbot.time import ClockType, Time

from rosgraph_msgs.msg import Clock as ClockMessage

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.conftest import MakeContext, Spin
    from zbot.executor.timer import TimerInfo
    from zbot.log.record import Record


@pytest.fixture
def node(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("clockwork", context=make_context())


@pytest.fixture
def executor(node: zbot.Node) -> Iterator[zbot.Executor]:
    with zbot.SingleThreadedExecutor(context=node.context) as made:
        made.add_node(node)
        yield made


class Simulation:
    """Node whose time is set by the test."""

    def __init__(self, context: zbot.Context) -> None:
        arguments = ["--ros-args", "-p", "use_sim_time:=true"]
        self.node = zbot.Node("simulated", context=context, cli_args=arguments)
        self.executor = zbot.SingleThreadedExecutor(context=context)
        self.executor.add_node(self.node)
        self.clock = self.node.get_clock()

    def go_to(self, seconds: float) -> None:
        """Set the time and run the due timers."""
        assert isinstance(self.clock, zbot.ROSClock)
        self.clock.set_ros_time_override(Time(seconds=seconds, clock_type=ClockType.ROS_TIME))
        for _ in range(5):
            self.executor.spin_once(timeout_sec=0)


@pytest.fixture
def simulation(make_context: MakeContext) -> Simulation:
    return Simulation(make_context())


# -- the machine's time ----------------------------------------------------------------------------


def test_a_timer_keeps_1_khz_without_drift(node: zbot.Node, executor: zbot.Executor) -> None:
    expected: list[int] = []
    node.create_timer(
        0.001,
        lambda info: expected.append(info.expected_call_time.nanoseconds),
        clock=Clock(clock_type=ClockType.STEADY_TIME),
    )

    # On a busy machine, periods are skipped now and then: wait for 50 calls without a gap.
    deadline = time.monotonic() + allowed(15)
    while len(expected) < 400 or expected[-1] - expected[-50] > 49_500_000:
        assert time.monotonic() < deadline
        executor.spin_once(timeout_sec=1)
    numbers = [(time_ns - expected[0]) / 1e6 for time_ns in expected]
    # A median: a thread may be suspended between the two clocks that a call reads.
    assert statistics.median(abs(number - round(number)) for number in numbers) < 0.01


def test_a_late_timer_skips_missed_periods(node: zbot.Node, executor: zbot.Executor) -> None:
    infos: list[TimerInfo] = []
    node.create_timer(0.01, infos.append, clock=Clock(clock_type=ClockType.STEADY_TIME))
    threading.Event().wait(0.1)
    while len(infos) < 2:
        executor.spin_once(timeout_sec=1)
    late, following = (info.expected_call_time for info in infos)
    assert (following - late).nanoseconds > 40_000_000


def test_a_timer_of_period_zero_runs_whenever_there_is_time(
    node: zbot.Node, executor: zbot.Executor
) -> None:
    calls: list[int] = []
    node.create_timer(0, lambda: calls.append(1))
    for _ in range(10):
        executor.spin_once(timeout_sec=1)
    assert len(calls) == 10


def test_the_timer_info_has_the_expected_and_the_actual_time(
    node: zbot.Node, executor: zbot.Executor
) -> None:
    infos: list[TimerInfo] = []
    begin = node.get_clock().now()
    node.create_timer(0.005, infos.append)
    executor.spin_once(timeout_sec=1)
    end = node.get_clock().now()
    assert begin <= infos[0].expected_call_time <= infos[0].actual_call_time <= end
    assert (infos[0].expected_call_time - begin).nanoseconds >= 5_000_000


@pytest.mark.parametrize("clock_type", [ClockType.SYSTEM_TIME, ClockType.STEADY_TIME])
def test_a_timer_may_use_another_clock(
    node: zbot.Node, executor: zbot.Executor, clock_type: ClockType
) -> None:
    infos: list[TimerInfo] = []
    timer = node.create_timer(0.001, infos.append, clock=Clock(clock_type=clock_type))
    executor.spin_once(timeout_sec=1)
    assert infos[0].actual_call_time.clock_type is clock_type
    assert timer.clock.clock_type is clock_type


def test_repeated_resets_of_a_timer_use_no_memory(node: zbot.Node, executor: zbot.Executor) -> None:
    timer = node.create_timer(60.0, lambda: None)
    for _ in range(1000):
        timer.reset()
        executor.spin_once(timeout_sec=0)
    assert isinstance(executor, zbot.SingleThreadedExecutor)
    assert len(executor._timers._heap) < 100


def test_a_shorter_period_wakes_a_sleeping_executor(node: zbot.Node, spin: Spin) -> None:
    called = threading.Event()
    timer = node.create_timer(60.0, called.set)
    spin(node)
    timer.timer_period_ns = 1_000_000
    assert called.wait(5)


def test_a_timer_made_while_spinning_runs(node: zbot.Node, spin: Spin) -> None:
    called = threading.Event()
    spin(node)
    node.create_timer(0.001, called.set)
    assert called.wait(5)


@pytest.mark.parametrize("period", [-1, -0.001, float("nan"), float("inf"), "1", None])
def test_an_invalid_period_is_refused(node: zbot.Node, period: float) -> None:
    with pytest.raises(InvalidPeriodError, match="period"):
        node.create_timer(period, lambda: None)


def test_a_timer_callback_with_two_arguments_is_refused(node: zbot.Node) -> None:
    with pytest.raises(RuntimeError, match="timer_info"):
        node.create_timer(1.0, lambda a, b: None)  # noqa: ARG005


def test_a_period_that_may_be_in_milliseconds_is_told(
    node: zbot.Node, logged: list[Record], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("zbot.node.state.is_program", lambda: True)
    for period in (99.9, 500):
        node.create_timer(period, print)
    text = "the first call comes after 500 seconds; for 500 milliseconds, write 0.5"
    assert [record.message for record in logged] == [f"create_timer(500): {text}"]


def test_a_timer_that_is_always_late_is_one_line(
    node: zbot.Node, spin: Spin, logged: list[Record], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("zbot.executor.timer._LATE_NS", 50_000_000)
    calls: list[int] = []

    def sleep() -> None:
        calls.append(len(calls))
        time.sleep(0.045)

    node.create_timer(0.01, sleep)
    spin(node)
    assert wait_until(lambda: len(calls) > 10)
    (text,) = [record.message for record in logged]
    assert "sleep has a period of 0.01 s, but its calls come " in text
    assert text.endswith(
        "periods apart: a callback takes too long, e.g. because it sleeps or waits"
    )


def test_an_async_timer_does_not_overtake_itself(node: zbot.Node, executor: zbot.Executor) -> None:
    gate: zbot.Future[None] = zbot.Future()
    calls: list[int] = []

    async def tick() -> None:
        calls.append(1)
        await gate

    node.create_timer(0.0, tick)
    for _ in range(5):
        executor.spin_once(timeout_sec=0.001)
    assert len(calls) == 1
    gate.set_result(None)
    executor.spin_once(timeout_sec=1)
    executor.spin_once(timeout_sec=1)
    assert len(calls) == 2


# -- simulated time --------------------------------------------------------------------------------


def test_simulated_time_comes_from_the_clock_topic(
    simulation: Simulation, node: zbot.Node, spin: Spin
) -> None:
    calls: list[int] = []
    simulation.node.create_timer(1.0, lambda: calls.append(1))
    publisher = node.create_publisher(ClockMessage, "/clock", 10)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    spin(simulation.node)
    for second in range(100, 104):
        publisher.publish(ClockMessage(clock=Time(seconds=second).to_msg()))
        expected = second * 10**9
        assert wait_until(lambda at=expected: simulation.clock.now().nanoseconds == at)  # type: ignore[misc]
        assert wait_until(lambda count=second - 99: len(calls) == count)  # type: ignore[misc]


def test_simulated_time_starts_at_zero(simulation: Simulation) -> None:
    assert simulation.clock.now() == Time(clock_type=ClockType.ROS_TIME)


def test_time_is_not_simulated_without_the_parameter(node: zbot.Node) -> None:
    assert node.count_subscribers("/clock") == 0
    assert abs(node.get_clock().now().nanoseconds - time.time_ns()) < 10**9


def test_a_simulated_timer_runs_when_its_time_comes(simulation: Simulation) -> None:
    calls: list[float] = []
    simulation.go_to(10)
    simulation.node.create_timer(1.0, lambda: calls.append(simulation.clock.now().nanoseconds))
    for tenth in range(100, 131):
        simulation.go_to(tenth / 10)
    assert calls == [11 * 10**9, 12 * 10**9, 13 * 10**9]


def test_a_clock_coarser_than_the_period_runs_the_timer_each_step(simulation: Simulation) -> None:
    calls: list[int] = []
    simulation.go_to(10)
    simulation.node.create_timer(0.1, lambda: calls.append(1))
    for second in range(11, 16):
        simulation.go_to(second)
    assert len(calls) == 5


def test_simulated_time_wakes_the_executor_only_for_a_due_timer(simulation: Simulation) -> None:
    simulation.go_to(10)
    timer = simulation.node.create_timer(1.0, lambda: None)
    wakes: list[float] = []
    simulation.node.handle.ready_queue.watch(
        timer, lambda: wakes.append(simulation.clock.now().nanoseconds / 1e9)
    )
    for tenth in range(100, 121):
        simulation.go_to(tenth / 10)
    assert wakes == [11, 12]
    simulation.go_to(5)
    timer.cancel()
    simulation.go_to(20)
    assert wakes == [11, 12, 5]


def test_a_jump_back_starts_a_new_period(simulation: Simulation) -> None:
    calls: list[int] = []
    simulation.go_to(100)
    simulation.node.create_timer(1.0, lambda: calls.append(1))
    simulation.go_to(50)
    assert calls == []
    simulation.go_to(51)
    assert calls == [1]


def test_a_canceled_timer_waits_for_its_reset(simulation: Simulation) -> None:
    calls: list[int] = []
    simulation.go_to(10)
    timer = simulation.node.create_timer(1.0, lambda: calls.append(1))
    timer.cancel()
    assert timer.is_canceled()
    assert timer.time_until_next_call() is None
    simulation.go_to(15)
    assert calls == []
    timer.reset()
    assert not timer.is_canceled()
    simulation.go_to(15.9)
    assert calls == []
    simulation.go_to(16)
    assert calls == [1]


def test_reset_begins_a_new_period(simulation: Simulation) -> None:
    calls: list[int] = []
    simulation.go_to(10)
    timer = simulation.node.create_timer(1.0, lambda: calls.append(1))
    simulation.go_to(10.8)
    assert timer.time_since_last_call() == 800_000_000
    assert timer.time_until_next_call() == 200_000_000
    timer.reset()
    simulation.go_to(11.5)
    assert calls == []
    assert not timer.is_ready()
    simulation.go_to(11.8)
    assert calls == [1]


def test_a_new_period_counts_from_the_last_call(simulation: Simulation) -> None:
    calls: list[int] = []
    simulation.go_to(10)
    timer = simulation.node.create_timer(1.0, lambda: calls.append(1))
    simulation.go_to(11)
    timer.timer_period_ns = 3 * 10**9
    assert timer.timer_period_ns == 3 * 10**9
    simulation.go_to(13.9)
    assert calls == [1]
    simulation.go_to(14)
    assert calls == [1, 1]


def test_a_timer_without_autostart_waits_for_its_first_reset(simulation: Simulation) -> None:
    calls: list[int] = []
    simulation.go_to(10)
    timer = simulation.node.create_timer(1.0, lambda: calls.append(1), autostart=False)
    simulation.go_to(15)
    assert calls == []
    timer.reset()
    simulation.go_to(16)
    assert calls == [1]


def test_a_timer_may_cancel_itself(simulation: Simulation) -> None:
    calls: list[int] = []

    def once() -> None:
        calls.append(1)
        timer.cancel()

    simulation.go_to(10)
    timer = simulation.node.create_timer(1.0, once)
    for second in range(11, 15):
        simulation.go_to(second)
    assert calls == [1]


def test_a_destroyed_timer_never_runs_again(simulation: Simulation) -> None:
    calls: list[int] = []
    simulation.go_to(10)
    timer = simulation.node.create_timer(1.0, lambda: calls.append(1))
    assert list(simulation.node.timers) == [timer]
    assert simulation.node.destroy_timer(timer)
    assert not simulation.node.destroy_timer(timer)
    simulation.go_to(15)
    assert calls == []
    with pytest.raises(InvalidHandleError, match="timer"):
        timer.reset()


def test_a_with_block_destroys_its_timer(simulation: Simulation) -> None:
    calls: list[int] = []
    simulation.go_to(10)
    with simulation.node.create_timer(1.0, lambda: calls.append(1)):
        simulation.go_to(11)
    simulation.go_to(12)
    assert calls == [1]


def test_a_timers_callback_can_be_changed(simulation: Simulation) -> None:
    calls: list[str] = []
    simulation.go_to(10)
    timer = simulation.node.create_timer(1.0, None)
    simulation.go_to(11)
    timer.callback = lambda info: calls.append(type(info).__name__)
    simulation.go_to(12)
    assert calls == ["TimerInfo"]


# -- rates -----------------------------------------------------------------------------------------


def test_a_rate_gives_a_loop_its_frequency(node: zbot.Node) -> None:
    begin = time.monotonic()
    rate = node.create_rate(200.0)
    for _ in range(20):
        rate.sleep()
    assert 0.099 <= time.monotonic() - begin < allowed(1)


def test_a_rate_shortens_the_sleep_after_a_long_turn(node: zbot.Node) -> None:
    rate = node.create_rate(100.0)
    begin = time.monotonic()
    threading.Event().wait(0.015)
    rate.sleep()
    rate.sleep()
    assert time.monotonic() - begin < allowed(1)


def test_a_rate_follows_simulated_time(simulation: Simulation) -> None:
    simulation.go_to(10)
    rate = simulation.node.create_rate(1.0)
    woke = threading.Event()

    def loop() -> None:
        rate.sleep()
        woke.set()

    thread = threading.Thread(target=loop)
    thread.start()
    simulation.go_to(10.9)
    assert not woke.is_set()
    simulation.go_to(11)
    thread.join(5)
    assert woke.is_set()


def test_shutdown_ends_a_rates_sleep(node: zbot.Node) -> None:
    rate = node.create_rate(0.01)
    threading.Timer(0.02, node.context.shutdown).start()
    with pytest.raises(RateInterruptedError):
        rate.sleep()


def test_a_destroyed_rate_raises(node: zbot.Node) -> None:
    rate = node.create_rate(1.0)
    assert node.destroy_rate(rate)
    with pytest.raises(InvalidHandleError, match="rate"):
        rate.sleep()


def test_destroying_a_rate_wakes_its_sleeping_thread(node: zbot.Node) -> None:
    rate = node.create_rate(0.001)
    sleeper = threading.Thread(target=rate.sleep)
    sleeper.start()
    assert wait_until(lambda: bool(rate._sleep_context._wakers))
    assert node.destroy_rate(rate)
    sleeper.join(5)
    assert not sleeper.is_alive()
    assert not list(node.timers)


def test_a_rate_lets_spin_once_return(node: zbot.Node, executor: zbot.Executor) -> None:
    rate = node.create_rate(100.0)
    woke = threading.Event()

    def loop() -> None:
        for _ in range(3):
            rate.sleep()
        woke.set()

    thread = threading.Thread(target=loop)
    thread.start()
    while not woke.is_set():
        executor.spin_once()
    thread.join(5)


def test_a_frequency_is_a_number(node: zbot.Node) -> None:
    wrong: Any = "1"
    with pytest.raises(ArgumentTypeError, match="frequency"):
        node.create_rate(wrong)


@pytest.mark.parametrize("frequency", [0, -1, float("nan"), float("inf")])
def test_an_invalid_frequency_is_refused(node: zbot.Node, frequency: float) -> None:
    with pytest.raises(InvalidPeriodError, match="frequency"):
        node.create_rate(frequency)
