from __future__ import annotations

import signal
import sys
import threading
import time
from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import allowed
from zbot.errors import ArgumentTypeError, NotInitializedError, WrongValueError, ZbotError
from zbot.executor.clock import Clock, ClockChange, JumpThreshold, ROSClock, TimeJump
from zbot.time import ClockType, Duration, Time

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

ROS, SYSTEM, STEADY = ClockType.ROS_TIME, ClockType.SYSTEM_TIME, ClockType.STEADY_TIME
FAR = Duration(seconds=3600)


def ros_time(nanoseconds: int) -> Time:
    return Time(nanoseconds=nanoseconds, clock_type=ROS)


class FakeContext:
    """Context without a session, with an event for the begin of a sleep."""

    def __init__(self) -> None:
        self.is_ok = True
        self.wakers: list[Callable[[], None]] = []
        self.is_sleeping = threading.Event()

    @property
    def is_running(self) -> bool:
        return self.is_ok

    def add_waker(self, waker: Callable[[], None]) -> None:
        self.wakers.append(waker)
        self.is_sleeping.set()

    def remove_waker(self, waker: Callable[[], None]) -> None:
        self.wakers.remove(waker)

    def shutdown(self) -> None:
        self.is_ok = False
        for waker in list(self.wakers):
            waker()


@pytest.fixture
def context() -> FakeContext:
    return FakeContext()


@pytest.fixture
def simulated() -> ROSClock:
    clock = ROSClock()
    clock.set_ros_time_override(ros_time(100))
    clock.set_ros_time_is_active(True)
    return clock


class Sleeper:
    """Sleeps in a separate thread."""

    def __init__(self, clock: Clock, until: Time, context: FakeContext) -> None:
        self.result: bool | None = None
        self._thread = threading.Thread(target=self._sleep, args=(clock, until, context))
        self._thread.start()
        assert context.is_sleeping.wait(allowed(10))

    def _sleep(self, clock: Clock, until: Time, context: FakeContext) -> None:
        self.result = clock.sleep_until(until, context)

    def wake(self) -> bool | None:
        self._thread.join(allowed(10))
        assert not self._thread.is_alive()
        return self.result

    def still_sleeps(self) -> bool:
        self._thread.join(0.02)
        return self._thread.is_alive()


# -- now -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("clock_type", "now_ns"),
    [(SYSTEM, time.time_ns), (STEADY, time.monotonic_ns), (ROS, time.time_ns)],
)
def test_now_is_the_time_of_the_clock_type(
    clock_type: ClockType, now_ns: Callable[[], int]
) -> None:
    before = now_ns()
    now = Clock(clock_type=clock_type).now()
    assert before <= now.nanoseconds <= now_ns()
    assert now.clock_type is clock_type


def test_clock_of_ros_time_is_a_ros_clock() -> None:
    assert isinstance(Clock(clock_type=ROS), ROSClock)
    assert type(Clock()) is type(Clock(clock_type=STEADY)) is Clock
    assert Clock().clock_type is SYSTEM
    assert ROSClock().clock_type is ROS


def test_repr_is_that_of_ros() -> None:
    assert repr(ROSClock()) == "Clock(clock_type=ROS_TIME)"


@pytest.mark.parametrize("clock_type", ["SYSTEM_TIME", 2, None, ClockType.UNINITIALIZED])
def test_wrong_clock_type_is_refused(clock_type: Any) -> None:
    with pytest.raises(ArgumentTypeError, match="clock_type"):
        Clock(clock_type=clock_type)


def test_ros_clock_has_no_other_type() -> None:
    with pytest.raises(ArgumentTypeError, match="ROS_TIME"):
        ROSClock(clock_type=STEADY)


# -- simulated time ------------------------------------------------------------------------------


def test_now_is_simulated_only_while_simulated_time_is_active() -> None:
    clock = ROSClock()
    clock.set_ros_time_override(ros_time(5))
    assert not clock.ros_time_is_active
    assert clock.now().nanoseconds > 5
    clock.set_ros_time_is_active(True)
    assert clock.ros_time_is_active
    assert clock.now() == ros_time(5)
    clock.set_ros_time_is_active(False)
    assert clock.now().nanoseconds > 5


def test_override_must_be_a_time(simulated: ROSClock) -> None:
    with pytest.raises(ArgumentTypeError, match="must be a Time"):
        simulated.set_ros_time_override(5)  # type: ignore[arg-type]


def test_time_change_callbacks_see_the_new_time(simulated: ROSClock) -> None:
    seen: list[int] = []
    handle = simulated.on_time_change(lambda: seen.append(simulated.now().nanoseconds))
    for nanoseconds in (150, 150, 120):
        simulated.set_ros_time_override(ros_time(nanoseconds))
    assert seen == [150, 150, 120]
    simulated.set_ros_time_is_active(False)
    assert len(seen) == 4
    handle.unregister()
    handle.unregister()
    simulated.set_ros_time_is_active(True)
    assert len(seen) == 4


def test_time_set_while_inactive_calls_no_callback() -> None:
    clock, told = ROSClock(), list[str]()
    clock.on_time_change(lambda: told.append("change"))
    clock.set_ros_time_override(ros_time(5))
    clock.set_ros_time_is_active(False)
    assert told == []


# -- jumps ---------------------------------------------------------------------------------------

ON, OFF = (ClockChange.ROS_TIME_ACTIVATED, 0), (ClockChange.ROS_TIME_DEACTIVATED, 0)
FORWARD = (ClockChange.ROS_TIME_NO_CHANGE, 10)
BACKWARD = (ClockChange.ROS_TIME_NO_CHANGE, -10)


@pytest.mark.parametrize(
    ("forward_ns", "backward_ns", "on_clock_change", "expected"),
    [
        (10, None, True, [ON, FORWARD, OFF]),
        (10, None, False, [FORWARD]),
        (11, None, True, [ON, OFF]),
        (None, -10, False, [BACKWARD]),
        (None, -11, True, [ON, OFF]),
        (10, -10, True, [ON, FORWARD, BACKWARD, OFF]),
        (None, None, True, [ON, OFF]),
    ],
)
def test_jump_callbacks_are_called_from_their_threshold_on(
    forward_ns: int | None,
    backward_ns: int | None,
    on_clock_change: bool,
    expected: list[tuple[ClockChange, int]],
) -> None:
    clock, told = ROSClock(), list[TimeJump]()
    threshold = JumpThreshold(
        min_forward=None if forward_ns is None else Duration(nanoseconds=forward_ns),
        min_backward=None if backward_ns is None else Duration(nanoseconds=backward_ns),
        on_clock_change=on_clock_change,
    )
    clock.set_ros_time_override(ros_time(100))
    clock.create_jump_callback(threshold, post_callback=told.append)
    clock.set_ros_time_is_active(True)
    for nanoseconds in (100, 109, 119, 110, 100):
        clock.set_ros_time_override(ros_time(nanoseconds))
    clock.set_ros_time_is_active(False)
    assert [(jump.clock_change, jump.delta.nanoseconds) for jump in told] == expected


def test_callbacks_see_the_time_before_and_after(simulated: ROSClock) -> None:
    seen: list[tuple[str, int]] = []
    simulated.create_jump_callback(
        JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None),
        pre_callback=lambda: seen.append(("before", simulated.now().nanoseconds)),
        post_callback=lambda _: seen.append(("after", simulated.now().nanoseconds)),
    )
    simulated.set_ros_time_override(ros_time(200))
    assert seen == [("before", 100), ("after", 200)]


def test_jump_handle_ends_with_its_block(simulated: ROSClock) -> None:
    told: list[TimeJump] = []
    threshold = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None)
    with simulated.create_jump_callback(threshold, post_callback=told.append) as handle:
        simulated.set_ros_time_override(ros_time(200))
    simulated.set_ros_time_override(ros_time(300))
    handle.unregister()
    assert len(told) == 1


def test_exception_of_a_jump_callback_is_raised_where_the_time_is_set(simulated: ROSClock) -> None:
    def fail(_: TimeJump) -> None:
        raise KeyError("boom")

    told: list[str] = []
    threshold = JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=None)
    simulated.create_jump_callback(threshold, post_callback=fail)
    simulated.create_jump_callback(threshold, post_callback=lambda _: told.append("jump"))
    simulated.on_time_change(lambda: told.append("change"))
    with pytest.raises(KeyError, match="boom"):
        simulated.set_ros_time_override(ros_time(200))
    assert simulated.now() == ros_time(200)
    assert told == ["change"]


def test_jump_callback_may_set_the_time_again(simulated: ROSClock) -> None:
    simulated.create_jump_callback(
        JumpThreshold(min_forward=None, min_backward=Duration(nanoseconds=-50)),
        post_callback=lambda _: simulated.set_ros_time_override(ros_time(60)),
    )
    simulated.set_ros_time_override(ros_time(1))
    assert simulated.now() == ros_time(60)


@pytest.mark.parametrize(
    ("call", "error", "text"),
    [
        (
            lambda: JumpThreshold(min_forward=Duration(), min_backward=None),
            WrongValueError,
            "min_forward must be a positive duration",
        ),
        (
            lambda: JumpThreshold(min_forward=None, min_backward=Duration(seconds=1)),
            WrongValueError,
            "min_backward must be a negative duration",
        ),
        (
            lambda: JumpThreshold(min_forward=None, min_backward=None, on_clock_change=False),
            WrongValueError,
            "at least one",
        ),
        (
            lambda: Clock().create_jump_callback(
                JumpThreshold(min_forward=None, min_backward=None)
            ),
            WrongValueError,
            "pre_callback or post_callback",
        ),
        (
            lambda: Clock().create_jump_callback(
                JumpThreshold(min_forward=None, min_backward=None),
                post_callback="no",  # type: ignore[arg-type]
            ),
            WrongValueError,
            "post_callback must be callable",
        ),
        (lambda: TimeJump(2, Duration()), ArgumentTypeError, "clock_change"),  # type: ignore[arg-type]
    ],
)
def test_wrong_jump_is_refused(
    call: Callable[[], object], error: type[ZbotError], text: str
) -> None:
    with pytest.raises(error, match=text):
        call()


# -- sleep ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("clock_type", [SYSTEM, STEADY, ROS])
def test_sleep_lasts_as_long_as_asked(clock_type: ClockType, context: FakeContext) -> None:
    clock = Clock(clock_type=clock_type)
    until = clock.now() + Duration(seconds=0.02)
    assert clock.sleep_until(until, context) is True
    late = clock.now() - until
    assert Duration() <= late < Duration(seconds=allowed(10))
    assert context.wakers == []


def test_sleep_until_the_past_returns_at_once(context: FakeContext, simulated: ROSClock) -> None:
    assert Clock(clock_type=STEADY).sleep_for(Duration(seconds=-1), context) is True
    assert simulated.sleep_for(Duration(), context) is True


@pytest.mark.parametrize("clock_type", [SYSTEM, STEADY, ROS])
def test_shutdown_ends_a_sleep(clock_type: ClockType, context: FakeContext) -> None:
    clock = Clock(clock_type=clock_type)
    sleeper = Sleeper(clock, clock.now() + FAR, context)
    context.shutdown()
    assert sleeper.wake() is False
    assert context.wakers == []


def test_shutdown_ends_a_sleep_on_simulated_time(context: FakeContext, simulated: ROSClock) -> None:
    sleeper = Sleeper(simulated, ros_time(101), context)
    context.shutdown()
    assert sleeper.wake() is False


def test_simulated_sleep_ends_at_its_time(context: FakeContext, simulated: ROSClock) -> None:
    sleeper = Sleeper(simulated, ros_time(200), context)
    for nanoseconds in (199, 5, 150):
        simulated.set_ros_time_override(ros_time(nanoseconds))
        assert sleeper.still_sleeps()
    simulated.set_ros_time_override(ros_time(200))
    assert sleeper.wake() is True


@pytest.mark.parametrize("states", [[True, False], [False, True], [False, True, False]])
def test_simulation_switched_on_or_off_ends_a_sleep(
    states: list[bool], context: FakeContext
) -> None:
    clock = ROSClock()
    clock.set_ros_time_is_active(states[0])
    sleeper = Sleeper(clock, clock.now() + FAR, context)
    for is_active in states[1:]:
        clock.set_ros_time_is_active(is_active)
    assert sleeper.wake() is False


def test_sleep_refuses_a_time_of_another_clock(context: FakeContext) -> None:
    with pytest.raises(WrongValueError, match=r"type does not match.*STEADY_TIME.*SYSTEM_TIME"):
        Clock().sleep_until(Time(clock_type=STEADY), context)


def test_sleep_needs_a_time(context: FakeContext) -> None:
    with pytest.raises(ArgumentTypeError, match="until must be a Time"):
        Clock().sleep_until(2.0, context)  # type: ignore[arg-type]


def test_sleep_needs_a_context_that_is_not_shut_down(context: FakeContext) -> None:
    context.shutdown()
    with pytest.raises(NotInitializedError):
        Clock().sleep_for(FAR, context)


@pytest.fixture
def alarm() -> Iterator[Callable[[Callable[[], None]], None]]:
    """Return a function that lets a signal handler call a given function 20 ms later."""
    before = signal.getsignal(signal.SIGALRM)

    def set_alarm(action: Callable[[], None]) -> None:
        signal.signal(signal.SIGALRM, lambda _number, _frame: action())
        signal.setitimer(signal.ITIMER_REAL, 0.02)

    yield set_alarm
    signal.setitimer(signal.ITIMER_REAL, 0)
    signal.signal(signal.SIGALRM, before)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no interval timer")
@pytest.mark.parametrize("is_simulated", [False, True])
def test_signal_handler_can_end_the_sleep_it_interrupts(
    is_simulated: bool, context: FakeContext, alarm: Callable[[Callable[[], None]], None]
) -> None:
    clock = ROSClock()
    clock.set_ros_time_is_active(is_simulated)
    alarm(context.shutdown)
    assert clock.sleep_for(FAR, context) is False


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no interval timer")
def test_exception_of_a_signal_handler_ends_a_sleep(
    context: FakeContext, alarm: Callable[[Callable[[], None]], None]
) -> None:
    def interrupt() -> None:
        raise KeyboardInterrupt

    alarm(interrupt)
    with pytest.raises(KeyboardInterrupt):
        Clock().sleep_for(FAR, context)
    assert context.wakers == []


def test_rclpys_private_name_switches_simulated_time() -> None:
    clock = ROSClock()
    clock._set_ros_time_is_active(True)
    assert clock.ros_time_is_active
