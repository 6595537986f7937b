"""Tests of driving on the page: sticks, keys, a gamepad, and above all the stop."""

from __future__ import annotations

import os
import signal
import statistics
import time
from contextlib import closing
from functools import partial
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

import pytest

import zbot
from tests.conftest import allowed, wait_until
from tests.web.conftest import ARGUMENTS, chromium, command
from tests.web.relay import Relay

from geometry_msgs.msg import Twist, TwistStamped
from sensor_msgs.msg import Image, Joy

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Browser, Page

    from tests.conftest import MakeContext, Spin
    from tests.web.conftest import Server, Visit

#: How often each way to lose the user is tried. With 50 and `pytest -s`, the times are measured.
TIMES = int(os.environ.get("ZBOT_DRIVE_STOPS", "2"))
LIMIT_S = 0.3
#: Longer than the pause between two commands, and than the silence that stops the robot.
SILENCE_S = 0.4


class Robot:
    """Node that receives commands, and notes when each arrived."""

    def __init__(self, context: zbot.Context, spin: Spin, msg_type: Any, topic: str) -> None:
        self.node = zbot.Node("robot", context=context)
        self.heard: list[tuple[float, Any]] = []
        self.node.create_subscription(msg_type, topic, self._hear, 10)
        spin(self.node)

    def _hear(self, message: Any) -> None:
        self.heard.append((time.monotonic(), message))

    @property
    def latest(self) -> Any:
        """The newest message, or None."""
        return self.heard[-1][1] if self.heard else None

    def drives(self) -> bool:
        return bool(self.heard) and is_moving(self.latest)

    def stops_after(
        self, act: Callable[[], object], began: Callable[[], float] | None = None
    ) -> float:
        """Return the seconds from the begin of an act to the zero, which the last message is.

        `began` may return when it began, in seconds since the epoch.
        """
        begin = time.monotonic()
        act()
        assert wait_until(lambda: not self.drives(), 5)
        stopped_s = self.heard[-1][0]
        count = len(self.heard)
        time.sleep(SILENCE_S)  # nothing must come
        assert len(self.heard) == count
        assert is_moving(self.heard[-2][1]), "more than one zero"
        if began is not None:
            begin = began() - time.time() + time.monotonic()
        return max(0.0, stopped_s - begin)


def is_moving(message: Any) -> bool:
    if isinstance(message, Joy):
        return any(message.axes) or any(message.buttons)
    return bool(message != type(message)())


@pytest.fixture
def robot(make_context: MakeContext, spin: Spin, domain: int) -> Robot:  # noqa: ARG001
    return Robot(make_context(), spin, Twist, "/cmd_vel")


@pytest.fixture
def gamepad_node(make_context: MakeContext, spin: Spin, domain: int) -> Robot:  # noqa: ARG001
    return Robot(make_context(), spin, Joy, "/joy")


def hold(page: Page, label: str = "Stick", x: float = 0.0, y: float = -60.0) -> None:
    """Press the mouse in the middle of a stick, and move it by some pixels."""
    box = page.get_by_label(label, exact=True).bounding_box()
    assert box is not None
    at_x, at_y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(at_x, at_y)
    page.mouse.down()
    page.mouse.move(at_x + x, at_y + y)


def press_until(
    drives: Callable[[], bool], press: Callable[[], object], release: Callable[[], object]
) -> None:
    """Press until the robot drives as asked. On a busy machine, the page or the server may stop it.

    Then the user must let go, and press again.
    """

    def is_driving() -> bool:
        release()
        press()
        return wait_until(drives, 1)

    assert wait_until(is_driving)


def drive(page: Page, robot: Robot) -> None:
    """Hold the stick until the robot drives."""
    expect(page.get_by_label("Stick", exact=True)).to_be_visible()
    press_until(robot.drives, partial(hold, page), page.mouse.up)


def test_a_drag_drives_and_its_end_stops(server: Server, page: Page, robot: Robot) -> None:
    page.goto(f"{server.address}/drive")
    expect(command(page)).to_contain_text("zbot topic echo /cmd_vel")
    expect(page.get_by_label("Stick", exact=True)).to_be_visible()
    press_until(
        lambda: (
            robot.drives()
            and robot.latest.linear.x > 0.4
            and robot.latest.angular.z == pytest.approx(0, abs=0.05)
        ),
        partial(hold, page),
        page.mouse.up,
    )
    assert robot.stops_after(page.mouse.up) < allowed(LIMIT_S)
    press_until(  # left is positive, and the stick's circle is the limit
        lambda: (
            robot.latest.angular.z == pytest.approx(1.0)
            and robot.latest.linear.x == pytest.approx(0, abs=0.05)
        ),
        partial(hold, page, x=-200, y=0),
        page.mouse.up,
    )
    page.mouse.up()
    assert wait_until(lambda: not robot.drives())


def test_keys_drive_within_limits_that_the_browser_keeps(
    server: Server, page: Page, robot: Robot
) -> None:
    page.goto(f"{server.address}/drive")
    speed = page.get_by_label("Limit of the speed, m/s")
    speed.fill("0.2")
    speed.press("Enter")

    def press(*codes: str) -> None:
        for code in codes:
            page.keyboard.down(code)

    def release() -> None:
        for code in ("w", "ArrowLeft"):
            page.keyboard.up(code)

    def turns(speed_m_s: float) -> bool:
        linear_m_s = robot.latest.linear.x if robot.heard else None
        return linear_m_s == pytest.approx(speed_m_s) and robot.latest.angular.z == 1.0

    def press_both_and_release_one() -> None:
        press("w", "ArrowLeft")
        wait_until(partial(turns, 0.2), 1)
        page.keyboard.up("w")

    press_until(partial(turns, 0.2), partial(press, "w", "ArrowLeft"), release)
    press_until(partial(turns, 0.0), press_both_and_release_one, release)
    assert robot.stops_after(lambda: page.keyboard.up("ArrowLeft")) < allowed(LIMIT_S)
    page.reload()
    expect(speed).to_have_value("0.2")
    page.evaluate("localStorage.clear()")


def test_a_robot_that_moves_sideways_has_a_second_stick(
    server: Server, page: Page, robot: Robot
) -> None:
    page.goto(f"{server.address}/drive")
    expect(page.get_by_label("Turn", exact=True)).to_be_hidden()
    page.get_by_text("sideways", exact=True).click()
    expect(page.get_by_label("Turn", exact=True)).to_be_visible()
    press_until(
        lambda: robot.drives() and robot.latest.linear.y == pytest.approx(0.5),
        partial(hold, page, x=-200, y=0),
        page.mouse.up,
    )
    assert not any(message.angular.z for _, message in robot.heard)
    press_until(
        lambda: robot.latest.angular.z == pytest.approx(-1.0),
        partial(hold, page, "Turn", x=200, y=0),
        page.mouse.up,
    )
    page.mouse.up()
    assert wait_until(lambda: not robot.drives())
    page.evaluate("localStorage.clear()")


def test_a_gamepad_drives_while_a_shoulder_button_is_held(
    server: Server, another_page: Callable[[], Page], robot: Robot
) -> None:
    page = another_page()
    page.add_init_script(
        "window.pad = { connected: true, axes: [0, -1, 0, 0], buttons: Array(12).fill({}) };"
        "navigator.getGamepads = () => [null, window.pad];"
    )
    page.goto(f"{server.address}/drive")
    expect(page.get_by_label("Stick", exact=True)).to_be_visible()
    page.wait_for_timeout(200)
    assert not robot.heard

    press, release = (
        partial(page.evaluate, f"window.pad.buttons[4] = {{ pressed: {is_pressed} }}")
        for is_pressed in ("true", "false")
    )

    def let_go() -> None:
        release()
        page.wait_for_timeout(200)

    press_until(
        lambda: robot.drives() and robot.latest.linear.x == pytest.approx(0.5), press, let_go
    )
    unplug = "window.dispatchEvent(new Event('gamepaddisconnected'))"
    assert robot.stops_after(lambda: page.evaluate(unplug)) < allowed(LIMIT_S)
    press_until(robot.drives, press, let_go)
    assert robot.stops_after(release) < allowed(LIMIT_S)


def test_a_stamped_twist_has_a_stamp_and_a_frame(
    server: Server, page: Page, make_context: MakeContext, spin: Spin
) -> None:
    robot = Robot(make_context(), spin, TwistStamped, "/base/velocity")
    page.goto(f"{server.address}/drive")
    page.get_by_label("Stick", exact=True).wait_for()
    page.keyboard.down("ArrowUp")
    assert wait_until(lambda: bool(robot.heard))
    message = robot.heard[0][1]
    page.keyboard.up("ArrowUp")
    assert message.twist.linear.x == pytest.approx(0.5)
    assert message.header.frame_id == "base_link"
    assert abs(message.header.stamp.sec - time.time()) < 60
    assert wait_until(lambda: robot.latest.twist == Twist())


def test_the_user_chooses_one_of_several_robots(
    server: Server, page: Page, robot: Robot, make_context: MakeContext, spin: Spin
) -> None:
    other = Robot(make_context(), spin, Twist, "/robot2/cmd_vel")
    page.goto(f"{server.address}/drive")
    chooser = page.get_by_label("Topic", exact=True)
    expect(page.get_by_text("/cmd_vel (Twist)", exact=True)).to_be_visible()
    chooser.click()
    page.get_by_role("option", name="/robot2/cmd_vel (Twist)").click()
    expect(command(page)).to_contain_text("zbot topic echo /robot2/cmd_vel")
    drive(page, other)
    page.mouse.up()
    assert wait_until(lambda: not other.drives())
    assert not robot.heard
    page.goto(f"{server.address}/drive?topic=/robot3/cmd_vel")
    expect(page.get_by_text("No node subscribes to /robot3/cmd_vel now.")).to_be_visible()
    expect(page.get_by_label("Stick", exact=True)).to_have_count(0)


def test_without_a_robot_the_page_says_what_to_start(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/drive")
    expect(page.get_by_text("No robot listens")).to_contain_text("zbot run robot_base")


def test_on_a_phone_a_finger_drives_below_the_picture_of_the_camera(
    server: Server, visit: Callable[..., Visit], robot: Robot
) -> None:
    camera = robot.node.create_publisher(Image, "/camera/image_raw", 1)
    image = Image(width=64, height=48, encoding="mono8", step=64, data=bytes(64 * 48))
    page = visit(viewport={"width": 390, "height": 844}, has_touch=True).page
    page.goto(f"{server.address}/drive")
    picture = page.get_by_alt_text("The last image")
    picture.wait_for()

    def is_loaded() -> bool:
        camera.publish(image)
        page.wait_for_timeout(50)
        return bool(picture.evaluate("image => image.naturalWidth"))

    assert wait_until(is_loaded)
    above, stick = picture.bounding_box(), page.get_by_label("Stick", exact=True).bounding_box()
    assert above is not None
    assert stick is not None
    assert above["y"] + above["height"] < stick["y"]
    assert stick["y"] + stick["height"] < 760  # on the screen without scrolling
    session = page.context.new_cdp_session(page)

    def touch(event: str, *points: tuple[float, float]) -> None:
        places = [{"x": x, "y": y} for x, y in points]
        session.send("Input.dispatchTouchEvent", {"type": event, "touchPoints": places})

    x, y = stick["x"] + stick["width"] / 2, stick["y"] + stick["height"] / 2
    touches: list[str] = []

    def lift() -> None:
        if touches:
            touch("touchEnd")
            touches.clear()

    def push() -> None:
        touch("touchStart", (x, y))
        touch("touchMove", (x, y - 60))
        touches.append("finger")

    press_until(lambda: robot.drives() and robot.latest.linear.x > 0.4, push, lift)
    assert robot.stops_after(lift) < allowed(LIMIT_S)


def test_a_read_only_page_cannot_drive(read_only_server: Server, page: Page, robot: Robot) -> None:
    page.goto(f"{read_only_server.address}/drive")
    expect(page.get_by_text("This page is read-only: it cannot drive.")).to_be_visible()
    expect(page.get_by_label("Stick", exact=True)).to_have_count(0)
    assert not robot.heard


# -- the stop ------------------------------------------------------------------------------------


def report(way: str, times: list[float]) -> None:
    """Check the times, and print them."""
    print(f"{way}: {len(times)} stops, median {statistics.median(times):.3f} s, ", end="")
    print(f"longest {max(times):.3f} s")
    assert max(times) < allowed(LIMIT_S), times


def test_closing_the_page_stops_the_robot(
    server: Server, another_page: Callable[[], Page], robot: Robot
) -> None:
    times = []
    for _ in range(TIMES):
        page = another_page()
        page.goto(f"{server.address}/drive")
        drive(page, robot)
        times.append(robot.stops_after(page.close))
    report("page closed", times)


def test_hiding_the_tab_stops_the_robot(server: Server, page: Page, robot: Robot) -> None:
    page.goto(f"{server.address}/drive")
    times = []
    for _ in range(TIMES):
        drive(page, robot)
        times.append(robot.stops_after(lambda: set_hidden(page, is_hidden=True)))
        set_hidden(page, is_hidden=False)
    report("tab hidden", times)


def set_hidden(page: Page, *, is_hidden: bool) -> None:
    # Chromium without a window shows all tabs, so the test says what a browser says.
    page.evaluate(
        """(hidden) => {
            Object.defineProperty(document, "hidden", { value: hidden, configurable: true });
            document.dispatchEvent(new Event("visibilitychange"));
        }""",
        is_hidden,
    )


def test_cutting_the_network_stops_the_robot(
    server: Server, another_page: Callable[[], Page], robot: Robot
) -> None:
    port = urlsplit(server.address).port
    assert port is not None
    times = []
    with closing(Relay(port)) as relay:
        page = another_page()
        page.goto(f"http://127.0.0.1:{relay.port}/drive")
        for _ in range(TIMES):
            drive(page, robot)
            times.append(robot.stops_after(relay.cut))
            count = len(robot.heard)
            relay.mend()  # what the browser said meanwhile arrives now, and does not drive
            expect(page.locator(".zb-drive-said")).not_to_be_empty()
            assert len(robot.heard) == count
            page.mouse.up()
        page.close()
    report("network cut", times)


def test_a_page_that_hangs_stops_the_robot(server: Server, page: Page, robot: Robot) -> None:
    page.goto(f"{server.address}/drive")
    times = []
    hang = """setTimeout(() => {
        window.hung = Date.now();
        while (Date.now() < window.hung + 1200);
    })"""
    for _ in range(TIMES):
        drive(page, robot)
        # On a busy machine, the page may hang much later than it was told.
        began = partial(page.evaluate, "window.hung / 1000")
        times.append(robot.stops_after(lambda: page.evaluate(hang), began))
        expect(page.locator(".zb-drive-said")).not_to_be_empty()
        page.mouse.up()
    report("page hangs", times)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGKILL")
def test_killing_the_browser_stops_the_robot(
    server: Server, browser: Browser, robot: Robot
) -> None:
    times = []
    for _ in range(TIMES):
        victim = browser.browser_type.launch(executable_path=chromium(), args=ARGUMENTS)
        session = victim.new_browser_cdp_session()
        processes = session.send("SystemInfo.getProcessInfo")["processInfo"]
        (number,) = (process["id"] for process in processes if process["type"] == "browser")
        page = victim.new_page()
        page.goto(f"{server.address}/drive")
        drive(page, robot)
        times.append(robot.stops_after(partial(os.kill, number, signal.SIGKILL)))
        victim.close()
    report("browser killed", times)


# -- the gamepad on the screen -------------------------------------------------------------------


def test_the_former_address_shows_a_gamepad_for_its_topic(
    server: Server, page: Page, gamepad_node: Robot
) -> None:
    page.goto(f"{server.address}/stick?topic=/joy")
    expect(command(page)).to_contain_text("zbot topic echo /joy")
    press_until(
        lambda: (
            gamepad_node.drives()
            and gamepad_node.latest.axes[1] > 0.5  # left and up are positive
            and gamepad_node.latest.axes[0] > 0.2
        ),
        partial(hold, page, "Left stick", x=-30, y=-60),
        page.mouse.up,
    )
    assert len(gamepad_node.latest.buttons) == 11
    assert gamepad_node.stops_after(page.mouse.up) < allowed(LIMIT_S)


def test_buttons_stay_pressed_until_the_page_is_left(
    server: Server, page: Page, gamepad_node: Robot
) -> None:
    page.goto(f"{server.address}/drive?topic=/joy&type=sensor_msgs/msg/Joy")
    button = page.get_by_role("button", name="5", exact=True)

    def release() -> None:
        if button.get_attribute("aria-pressed") == "true":
            button.click()

    press_until(
        lambda: gamepad_node.drives() and gamepad_node.latest.buttons[5] == 1, button.click, release
    )
    assert gamepad_node.stops_after(button.click) < allowed(LIMIT_S)
    press_until(gamepad_node.drives, button.click, release)
    hide = "window.dispatchEvent(new Event('blur'))"
    assert gamepad_node.stops_after(lambda: page.evaluate(hide)) < allowed(LIMIT_S)
    expect(button).to_have_attribute("aria-pressed", "false")
