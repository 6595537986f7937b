"""Tests of joy_node, teleop_twist_joy and twist_mux."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot_nodes.driving import gamepad
from zbot_nodes.driving.gamepad import without_deadzone
from zbot_nodes.driving.joy_linux_node import JoyLinuxNode
from zbot_nodes.driving.joy_node import JoyNode
from zbot_nodes.driving.teleop_twist_joy import TeleopTwistJoy
from zbot_nodes.driving.teleop_twist_keyboard import TeleopTwistKeyboard
from zbot_nodes.driving.twist_mux import TwistMux
from zbot_nodes.startup.program import ParameterError

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Twist, TwistStamped
from sensor_msgs.msg import Joy, JoyFeedback
from std_msgs.msg import Bool

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.conftest import Start
    from tests.nodes.conftest import Bench


class Pad:
    """Gamepad of a test."""

    name = "pad"

    def __init__(self) -> None:
        self.axes, self.buttons = [0.0, 0.0], [0, 0, 0]
        self.is_attached = True
        self.rumbles: list[float] = []

    def read(self) -> tuple[list[float], list[int]]:
        return list(self.axes), list(self.buttons)

    def rumble(self, intensity: float, seconds: float) -> None:
        self.rumbles.append(intensity * seconds)


@pytest.fixture
def pad(monkeypatch: pytest.MonkeyPatch) -> Pad:
    plugged = Pad()
    monkeypatch.setattr(
        gamepad, "find_gamepad", lambda *_: plugged if plugged.is_attached else None
    )
    return plugged


# -- joy -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("value", "deadzone", "expected"),
    [(0.04, 0.05, 0), (-0.05, 0.05, 0), (1, 0.05, 1), (-1, 0.5, -1), (0.75, 0.5, 0.5), (1, 1, 0)],
)
def test_an_axis_is_smooth_outside_of_the_dead_zone(
    value: float, deadzone: float, expected: float
) -> None:
    assert without_deadzone(value, deadzone) == pytest.approx(expected)


def test_the_defaults_of_joy_are_those_of_the_genuine_node(bench: Bench, pad: Pad) -> None:
    assert pad.is_attached
    node = bench.run(JoyNode)
    expected = {
        "device_id": 0,
        "device_name": "",
        "deadzone": 0.05,
        "autorepeat_rate": 20.0,
        "sticky_buttons": False,
        "coalesce_interval_ms": 1,
    }
    assert {name: node.get_parameter(name).value for name in expected} == expected
    node = bench.run(JoyLinuxNode, {"dev": "/dev/input/js3"})
    assert isinstance(node, JoyLinuxNode)
    assert node.device() == (3, "")
    with pytest.raises(ParameterError, match=r"autorepeat_rate must be between 0.0 and 1000.0"):
        bench.run(JoyNode, {"autorepeat_rate": 1001.0})


def test_changes_are_published_at_once_and_repeated(bench: Bench, pad: Pad) -> None:
    heard = bench.watch(Joy, "/joy")
    bench.run(JoyNode, {"autorepeat_rate": 20.0})
    assert wait_until(lambda: len(heard) > 3)
    pad.axes[1], pad.buttons[2] = 1.0, 1
    assert wait_until(
        lambda: list(heard[-1].axes) == [0, 1] and list(heard[-1].buttons) == [0, 0, 1]
    )
    assert heard[-1].header.frame_id == "joy"
    assert heard[-1].header.stamp.sec > 0


def test_without_repetition_only_changes_are_published(bench: Bench, pad: Pad) -> None:
    heard = bench.watch(Joy, "/joy")
    bench.run(JoyNode, {"autorepeat_rate": 0.0})
    assert wait_until(lambda: len(heard) == 1)
    pad.axes[0] = -1.0
    assert wait_until(lambda: len(heard) == 2)
    assert heard[-1].axes[0] == -1


def test_a_sticky_button_changes_with_each_press(bench: Bench, pad: Pad) -> None:
    heard = bench.watch(Joy, "/joy")
    node = bench.run(JoyNode, {"sticky_buttons": True})
    assert isinstance(node, JoyNode)
    assert wait_until(lambda: bool(heard))
    for pressed, expected in ((1, 1), (0, 1), (1, 0), (0, 0)):
        pad.buttons[0] = pressed
        assert wait_until(lambda now=pressed: node.pressed[0] == now)  # type: ignore[misc]
        assert wait_until(lambda one=expected: heard[-1].buttons[0] == one)  # type: ignore[misc]
        assert node.published[1][0] == expected


def test_feedback_shakes_the_gamepad(bench: Bench, pad: Pad) -> None:
    bench.run(JoyNode)
    publisher = bench.publisher(JoyFeedback, "/joy/set_feedback")
    publisher.publish(JoyFeedback(type=JoyFeedback.TYPE_RUMBLE, intensity=2.0))
    publisher.publish(JoyFeedback(type=JoyFeedback.TYPE_RUMBLE, intensity=0.5))
    assert wait_until(lambda: pad.rumbles == [0.5])


def test_without_a_gamepad_the_stick_of_the_page_is_named(
    bench: Bench, monkeypatch: pytest.MonkeyPatch, logged: list[Any]
) -> None:
    monkeypatch.setitem(sys.modules, "pygame", None)
    bench.run(JoyNode)
    monkeypatch.setattr(gamepad, "find_gamepad", lambda *_: None)
    bench.run(JoyNode)
    text = "\n".join(record.message for record in logged)
    assert 'pip install "zbot[gamepad]"; the page has a stick on the screen' in text
    assert "No gamepad is connected; the page has a stick on the screen: zbot web" in text


# -- teleop_twist_joy ----------------------------------------------------------------------------


def joy(axes: list[float], *pressed: int) -> Joy:
    return Joy(axes=axes, buttons=[int(number in pressed) for number in range(8)])


def test_an_enable_button_drives_and_its_release_stops_once(bench: Bench) -> None:
    heard = bench.watch(Twist, "/cmd_vel")
    settings = {"axis_linear.x": 1, "axis_angular.yaw": 0, "enable_button": 2}
    bench.run(TeleopTwistJoy, {**settings, "enable_turbo_button": 3, "scale_angular.yaw": 0.4})
    publisher = bench.publisher(Joy, "/joy")
    for message in (
        joy([1.0, 0.5], 2),
        joy([1.0, 0.5], 2, 3),
        joy([1.0, 0.5]),
        joy([1.0, 0.5]),
        joy([-1.0], 2),
    ):
        publisher.publish(message)
    assert wait_until(lambda: len(heard) == 4)
    found = [(message.linear.x, message.angular.z) for message in heard]
    assert found == [
        (0.25, pytest.approx(0.4)),
        (0.5, 1.0),
        (0.0, 0.0),
        (0.0, pytest.approx(-0.4)),
    ]


def test_all_axes_can_drive_and_messages_can_have_a_stamp(bench: Bench) -> None:
    heard = bench.watch(TwistStamped, "/cmd_vel")
    names = ("linear.x", "linear.y", "linear.z", "angular.yaw", "angular.pitch", "angular.roll")
    settings: dict[str, Any] = {f"axis_{name}": number for number, name in enumerate(names)}
    settings |= {f"scale_{name}": 2.0 for name in names}
    settings |= {"require_enable_button": False, "publish_stamped_twist": True, "frame": "base"}
    bench.run(TeleopTwistJoy, {**settings, "inverted_reverse": True})
    bench.publisher(Joy, "/joy").publish(joy([-0.25, 0.5, 0.75, 1.0, -0.5, -1.0]))
    assert wait_until(lambda: len(heard) == 1)
    twist = heard[0].twist
    assert (twist.linear.x, twist.linear.y, twist.linear.z) == (-0.5, 1.0, 1.5)
    assert (twist.angular.z, twist.angular.y, twist.angular.x) == (-2.0, -1.0, -2.0)
    assert heard[0].header.frame_id == "base"


def test_the_defaults_of_teleop_are_those_of_the_genuine_node(bench: Bench) -> None:
    node = bench.run(TeleopTwistJoy)
    expected = {
        "require_enable_button": True,
        "enable_button": 5,
        "enable_turbo_button": -1,
        "axis_linear.x": 5,
        "axis_linear.y": -1,
        "axis_angular.yaw": 2,
        "scale_linear.x": 0.5,
        "scale_linear_turbo.x": 1.0,
        "scale_angular.yaw": 0.5,
        "scale_angular_turbo.yaw": 1.0,
        "publish_stamped_twist": False,
        "frame": "teleop_twist_joy",
        "inverted_reverse": False,
    }
    assert {name: node.get_parameter(name).value for name in expected} == expected
    node.set_parameters([zbot.Parameter("scale_linear.x", value=0.25)])
    assert not node.set_parameters([zbot.Parameter("enable_button", value=1.5)])[0].successful


# -- twist_mux -----------------------------------------------------------------------------------


def source(group: str, name: str, timeout: float, priority: int) -> dict[str, Any]:
    settings = {"topic": name, "timeout": timeout, "priority": priority}
    return {f"{group}.{name}.{key}": value for key, value in settings.items()}


def test_the_highest_priority_drives_until_it_is_silent(bench: Bench) -> None:
    heard = bench.watch(Twist, "/cmd_vel_out")
    settings = {**source("topics", "joy_vel", 100, 100), **source("topics", "nav_vel", 100, 10)}
    node = bench.run(TwistMux, {**settings, "use_stamped": False})
    assert isinstance(node, TwistMux)
    stick, plan = (bench.publisher(Twist, f"/{name}") for name in ("joy_vel", "nav_vel"))

    def send(publisher: Any, speed: float) -> None:
        twist = Twist()
        twist.linear.x = speed
        publisher.publish(twist)

    send(plan, 1.0)
    assert wait_until(lambda: [message.linear.x for message in heard] == [1.0])
    send(stick, 2.0)
    assert wait_until(lambda: len(heard) == 2)
    source_of = {velocity.name: velocity for velocity in node.velocities}
    received_ns = source_of["nav_vel"].received_ns
    send(plan, 3.0)
    assert wait_until(lambda: source_of["nav_vel"].received_ns != received_ns)

    def let_the_stick_expire() -> None:
        source_of["joy_vel"].received_ns -= 200 * 10**9  # the timeout of 100 s is over

    assert node.executor is not None
    assert wait_until(node.executor.create_task(let_the_stick_expire).done)  # in its thread
    send(plan, 4.0)
    assert wait_until(lambda: len(heard) == 3)
    assert [message.linear.x for message in heard] == [1.0, 2.0, 4.0]


def test_a_lock_stops_sources_below_its_priority(bench: Bench) -> None:
    heard = bench.watch(TwistStamped, "/cmd_vel_out")
    reports = bench.watch(DiagnosticArray, "/diagnostics")
    settings = {**source("topics", "high", 0, 200), **source("topics", "low", 0, 10)}
    node = bench.run(TwistMux, {**settings, **source("locks", "stop", 0.0, 100)})
    assert isinstance(node, TwistMux)
    low = bench.publisher(TwistStamped, "/low")
    bench.publisher(Bool, "/stop").publish(Bool(data=True))
    assert wait_until(lambda: node.lock_priority() == 100)
    low.publish(TwistStamped())
    bench.publisher(TwistStamped, "/high").publish(TwistStamped())
    assert wait_until(lambda: len(heard) == 1)

    def values() -> dict[str, str]:
        return {pair.key: pair.value for pair in reports[-1].status[0].values} if reports else {}

    assert wait_until(lambda: values().get("current priority") == "100")
    assert "masked (listening to low @ 0.000000s with priority #10)" in values()["velocity low"]
    assert " locked" in values()["lock stop"]
    assert reports[-1].status[0].name == "twist_mux: Twist mux status"


def test_without_a_choice_the_type_is_that_of_the_others(bench: Bench, logged: list[Any]) -> None:
    settings = source("topics", "joy_vel", 0, 100)
    heard = bench.watch(Twist, "/cmd_vel_out")
    publisher = bench.watcher.create_publisher(Twist, "/joy_vel", 10)
    bench.run(TwistMux, {**settings, "use_sim_time": True})  # the time stands still
    assert wait_until(
        lambda: any("the other nodes use Twist" in record.message for record in logged), 10
    )

    def arrives() -> bool:
        publisher.publish(Twist())
        return bool(heard)

    assert wait_until(arrives, 10)


def test_a_chosen_type_stays(bench: Bench) -> None:
    bench.watch(Twist, "/cmd_vel_out")
    node = bench.run(TwistMux, {**source("topics", "a", 0, 1), "use_stamped": True})
    assert isinstance(node, TwistMux)
    assert not wait_until(lambda: node.kind is Twist, 1.5)


def test_a_silent_lock_with_a_timeout_is_in_force(bench: Bench) -> None:
    settings = source("topics", "low", 0.5, 10)
    node = bench.run(TwistMux, {**settings, **source("locks", "heart", 0.5, 100)})
    assert isinstance(node, TwistMux)
    assert node.lock_priority() == 100
    assert node.active() is None


@pytest.mark.parametrize(
    ("parameters", "reason"),
    [
        ({"topics.a.topic": "a", "topics.a.timeout": 1}, "topics.a.priority is missing"),
        ({**source("topics", "a", 1, 1), "topics.a.timeout": "x"}, "must be numbers"),
    ],
)
def test_sources_that_cannot_be_used_are_refused(
    bench: Bench, parameters: dict[str, Any], reason: str
) -> None:
    with pytest.raises(ParameterError, match=reason):
        bench.run(TwistMux, parameters)


def test_the_programs_are_found_by_their_packages(start: Start) -> None:
    start("zbot", "run", "teleop_twist_joy", "teleop_node").wait_for("Teleop enable button 5.")
    start("zbot", "run", "twist_mux", "twist_mux").wait_for("No source is set")
    for package, executable in (("joy", "joy_node"), ("joy_linux", "joy_linux_node")):
        program = start("zbot", "run", package, executable, env={"PYGAME_DETECT_AVX2": "1"})
        program.wait_for("amepad")
        assert program.stop() == -2


def test_the_launch_files_of_the_packages_run(start: Start) -> None:
    program = start("zbot", "launch", "twist_mux", "twist_mux_launch.py")
    program.wait_for("Topic handler 'pause' subscribed to topic 'pause_navigation'")
    assert program.stop() == 0
    program = start("zbot", "launch", "teleop_twist_joy", "teleop-launch.py", "joy_config:=xbox")
    program.wait_for("Turbo on button 5.")
    assert program.stop() == 0


# -- teleop_twist_keyboard -----------------------------------------------------------------------


def test_keys_drive_and_every_other_key_stops(
    bench: Bench, capsys: pytest.CaptureFixture[str]
) -> None:
    messages = bench.watch(Twist, "/cmd_vel")
    node: Any = bench.run(TeleopTwistKeyboard)
    assert wait_until(lambda: node.publisher.get_subscription_count() > 0, 10)
    for key in "i.Jbwc ":
        node.press(key)
    assert wait_until(lambda: len(messages) == 7, 10)
    found = [(m.linear.x, m.linear.y, m.linear.z, m.angular.z) for m in messages]
    assert found == [
        (0.5, 0, 0, 0),
        (-0.5, 0, 0, 1),
        (0, 0.5, 0, 0),
        (0, 0, -0.5, 0),
        (0, 0, -0.55, 0),  # a key for the speeds keeps the direction
        (0, 0, -0.55, 0),
        (0, 0, 0, 0),
    ]
    assert capsys.readouterr().out.splitlines()[-1] == "speed 0.55 m/s, turn 0.9 rad/s"


def test_the_messages_of_keys_may_have_a_stamp(bench: Bench) -> None:
    messages = bench.watch(TwistStamped, "/cmd_vel")
    parameters = {"stamped": True, "frame_id": "base_link"}
    node: Any = bench.run(TeleopTwistKeyboard, parameters)
    assert wait_until(lambda: node.publisher.get_subscription_count() > 0, 10)
    node.press("l")
    assert wait_until(lambda: bool(messages), 10)
    assert (messages[0].header.frame_id, messages[0].twist.angular.z) == ("base_link", -1)
    assert messages[0].header.stamp.sec > 0


def test_ctrl_c_stops_the_robot(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    node: Any = TeleopTwistKeyboard(context=bench.context)
    pressed: list[str] = []

    def keys(_: Any) -> Iterator[str]:
        yield "i"
        raise KeyboardInterrupt

    monkeypatch.setattr(node, "press", pressed.append)
    monkeypatch.setattr("zbot_nodes.driving.teleop_twist_keyboard.pressed_keys", keys)
    node.read_keys()
    assert pressed == ["i", ""]
