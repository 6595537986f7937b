"""Test of the 3D view in a browser: what is published is seen, and other sites reach nothing."""

from __future__ import annotations

import io
import signal
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

import numpy as np
import pytest

import zbot
from tests.conftest import wait_until
from tests.unit.view.messages import cloud, framed, link, scan
from tests.web.conftest import ENDED_BY_CTRL_C
from tests.web.test_security import another_site, unsafe_page
from zbot.bag import Writer
from zbot.executor.spin_thread import SpinThread
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.view.arrangement.rviz_file import read_rviz_file

from geometry_msgs.msg import PoseWithCovarianceStamped
from sensor_msgs.msg import LaserScan, PointCloud2
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")
pytest.importorskip("viser", reason='the view needs viser: pip install "zbot[view]"')

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from playwright.sync_api import Browser, Locator, Page

    from tests.conftest import MakeContext, Program, Start
    from tests.web.conftest import Visit
    from zbot.view.arrangement.arrangement import Arrangement

ROBOT = """<robot name='cube'><link name='base_link'><visual>
<geometry><box size='1.5 1.5 1.5'/></geometry><material name='m'><color rgba='0 0 1 1'/></material>
</visual></link></robot>"""
GREEN = [(x / 20, y / 20 + 2, 0.0, 0x00C000) for x in range(20) for y in range(20)]
#: More pixels than the blue axes of some frames have.
AXES = 300
#: Attempts of a page of another site; returns the result of each.
ATTACK = """async address => {
    const socket = new Promise(done => {
        const one = new WebSocket(address.replace("http", "ws"), "viser-v1.1.1");
        one.onopen = () => done("open");
        one.onerror = () => done("refused");
    });
    const read = fetch(address).then(() => "read", () => "refused");
    const frame = new Promise(done => {
        const one = document.createElement("iframe");
        one.onload = () => done(one.contentWindow.length === 0 ? "refused" : "framed");
        one.src = address;
        document.body.append(one);
    });
    return Promise.all([socket, read, frame]);
}"""


def view(start: Start, *words: str) -> tuple[Program, str]:
    program = start("zbot", "view", "--no-browser", "--port", "0", *words)
    return program, program.wait_for("zbot view: http", 30).partition("zbot view: ")[2]


def publish(node: Any, prefix: str = "") -> None:
    """Publish a robot, a scan and a cloud once, for all that join later."""
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    links = TFMessage(transforms=[link("odom", "base_link"), link("base_link", "laser")])
    for message_type, topic, message in (
        (TFMessage, "/tf_static", links),
        (String, f"{prefix}/robot_description", String(data=ROBOT)),
        (LaserScan, f"{prefix}/scan", framed(scan([2.0] * 13), "laser")),
        (PointCloud2, f"{prefix}/cloud", framed(cloud(GREEN), "camera")),
    ):
        node.create_publisher(message_type, topic, latched).publish(message)


def colors(page: Page) -> dict[str, int]:
    """Return the number of pixels of each colour in the left half of the page."""
    from PIL import Image  # noqa: PLC0415 - an extra

    picture = Image.open(io.BytesIO(page.screenshot(animations="disabled"))).convert("RGB")
    red, green, blue = np.asarray(picture.crop((0, 0, 640, 640)), int).transpose(2, 0, 1)
    return {
        "red": int(np.count_nonzero((red > green + blue) & (red > 150))),
        "green": int(np.count_nonzero((green > red + blue) & (green > 100))),
        "blue": int(np.count_nonzero((blue > red + green) & (blue > 100))),
    }


def test_what_is_published_is_seen(
    visit: Callable[..., Visit],
    start: Start,
    make_context: MakeContext,
) -> None:
    publish(zbot.Node("robot", context=make_context()))
    program, address = view(start)
    window = visit(viewport={"width": 1000, "height": 640})
    page = window.page
    page.goto(address)
    page.get_by_text("The fixed frame is odom.").wait_for()
    page.get_by_text("3 frames in one tree").wait_for()
    assert wait_until(lambda: colors(page)["red"] > 50 and colors(page)["blue"] > 1000, 60)
    assert colors(page)["green"] < 50
    # The cloud is shown when it is ticked, and says what it lacks.
    page.get_by_label("/cloud").check()
    page.get_by_text("no transform from camera to odom").wait_for()
    node = zbot.Node("camera", context=make_context())
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    transforms = [link("base_link", "camera")]
    node.create_publisher(TFMessage, "/tf_static", latched).publish(
        TFMessage(transforms=transforms)
    )
    assert wait_until(lambda: colors(page)["green"] > 200, 60)
    page.get_by_label("/cloud").uncheck()
    assert wait_until(lambda: colors(page)["green"] < 50, 60)
    hosts = {urlsplit(url).hostname for url in window.requests if url.startswith(("http", "ws"))}
    assert hosts == {"127.0.0.1"}
    assert program.stop(signal.SIGINT) == ENDED_BY_CTRL_C


LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import Node
def generate_launch_description():
    return LaunchDescription([Node(
        package="rviz2", executable="rviz2", namespace="robot_1", arguments=["-d", "my.rviz"],
    )])
"""
FILE = """
Visualization Manager:
  Displays:
    - {Class: rviz_default_plugins/LaserScan, Name: Laser, Enabled: true, Topic: {Value: scan},
       Color: 0; 255; 0, Color Transformer: FlatColor, Style: Spheres, Size (m): 0.3}
    - {Class: rviz/RobotModel, Name: Robot, Enabled: false, Topic: robot_description}
    - {Class: grid_map_rviz_plugin/GridMap, Name: Elevation, Topic: /grid_map}
  Global Options: {Fixed Frame: base_link, Background Color: 48; 48; 48}
  Views:
    Current: {Class: rviz_default_plugins/TopDownOrtho, Scale: 100, X: 0, Y: 0, Angle: 0}
"""


def test_a_launch_file_with_rviz2_opens_the_displays_of_its_file(
    visit: Callable[..., Visit],
    start: Start,
    make_context: MakeContext,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    publish(zbot.Node("robot", namespace="robot_1", context=make_context()), prefix="/robot_1")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "log"))
    (tmp_path / "a.launch.py").write_text(LAUNCH)
    (tmp_path / "my.rviz").write_text(FILE)
    program = start("zbot", "launch", "a.launch.py")
    program.wait_for("the file has parts that the view does not have: display GridMap", 30)
    address = program.wait_for("zbot view: http", 30).partition("zbot view: ")[2]
    page = visit(viewport={"width": 1000, "height": 640}).page
    page.goto(address)
    page.get_by_text("The fixed frame is base_link.").wait_for()
    page.get_by_text("that the view does not have: display GridMap").wait_for()
    page.get_by_label("Laser: /robot_1/scan").wait_for()
    assert wait_until(lambda: colors(page)["green"] > 500, 60)
    assert colors(page)["blue"] < AXES  # the robot is off


def test_two_clicks_tell_where_the_robot_is(
    visit: Callable[..., Visit], start: Start, make_context: MakeContext, tmp_path: Path
) -> None:
    node = zbot.Node("robot", context=make_context())
    publish(node)
    estimates: list[Any] = []
    executor = SpinThread(node, "test")
    node.create_subscription(PoseWithCovarianceStamped, "initialpose", estimates.append, 10)
    (tmp_path / "my.rviz").write_text(f"{FILE}\nWindow Geometry: {{Height: 640}}")
    _, address = view(start, str(tmp_path / "my.rviz"))
    page = visit(viewport={"width": 1000, "height": 640}).page
    page.goto(address)
    page.get_by_text("The fixed frame is base_link.").wait_for()
    page.get_by_role("combobox", name="Tool").click()
    page.get_by_role("option", name="2D Pose Estimate").click()
    page.get_by_text("Click where the robot is.").wait_for()
    # The file shows 100 pixels a metre. Its middle is in the middle of the page.
    page.mouse.click(400, 320)
    page.get_by_text("Click a place in front of the robot.").wait_for()
    page.mouse.click(400, 120)
    page.get_by_text("Published on /initialpose.").wait_for()
    assert wait_until(lambda: bool(estimates), 10)
    pose = estimates[0].pose.pose
    assert (pose.position.x, pose.position.y) == pytest.approx((-1, 0), abs=0.05)
    assert (pose.orientation.z, pose.orientation.w) == pytest.approx((0.707, 0.707), abs=0.02)
    assert estimates[0].header.frame_id == "base_link"
    executor.stop()


def open_folder(page: Page) -> None:
    """Open the folder View. It is closed again after the page had no connection."""
    if not page.get_by_role("link", name="Save as .rviz").is_visible():
        page.get_by_text("View", exact=True).click()


def saved(page: Page, path: Path) -> Arrangement:
    """Return the displays in the file that the page saves. This needs no websocket."""
    open_folder(page)
    with page.expect_download() as download:
        page.get_by_role("link", name="Save as .rviz").click()
    assert download.value.suggested_filename == "view.rviz"
    download.value.save_as(path)
    return read_rviz_file(path)


def link_in(page: Page) -> Locator:
    """Ask for a link. A click while the page has no connection is lost, as for a user."""
    open_folder(page)
    page.get_by_role("button", name="Make a link").click()
    return page.locator("input[value*='arrangement=']")


def test_the_displays_are_saved_and_shared_by_a_link(
    visit: Callable[..., Visit], start: Start, make_context: MakeContext, tmp_path: Path
) -> None:
    publish(zbot.Node("robot", context=make_context()))
    _, address = view(start)
    page = visit(viewport={"width": 1000, "height": 640}).page
    page.goto(address)
    page.get_by_text("The fixed frame is odom.").wait_for()

    def kinds_in_file() -> list[str]:
        page.get_by_label("/scan").uncheck()
        found = saved(page, tmp_path / "saved.rviz")
        return sorted(choice.kind for choice in found.displays if choice.is_on)

    assert wait_until(lambda: kinds_in_file() == ["Grid", "RobotModel", "TF"], 60)
    assert read_rviz_file(tmp_path / "saved.rviz").fixed_frame == "odom"
    assert wait_until(lambda: link_in(page).is_visible(), 60)
    parts = urlsplit(link_in(page).input_value())
    # In the view of another student, the same displays are on.
    _, other = view(start, "--port", "0")
    page.goto(f"{other}?{parts.query}")
    page.get_by_text("The fixed frame is odom.").wait_for()
    page.get_by_label("robot_description").wait_for()
    assert wait_until(lambda: not page.get_by_label("/scan").is_checked(), 10)
    assert page.get_by_label("robot_description").is_checked()


def test_a_bag_is_shown_with_its_timeline(
    visit: Callable[..., Visit], start: Start, tmp_path: Path
) -> None:
    robot = String(data=ROBOT)
    with Writer(tmp_path / "bag") as bag:
        for second in range(0, 101, 2):
            stamp = (1000 + second) * 10**9
            bag.write("/tf", TFMessage(transforms=[link("odom", "base_link", 0, second)]), stamp)
            if second >= 60:
                bag.write("/robot_description", robot, stamp)
    _, address = view(start, str(tmp_path / "bag"))
    page = visit(viewport={"width": 1000, "height": 640}).page
    page.goto(address)
    page.get_by_text("The fixed frame is odom.").wait_for()
    page.get_by_label("Play").uncheck()
    assert colors(page)["blue"] < AXES
    page.get_by_role("slider").first.focus()
    page.keyboard.press("End")  # the end of the bag, with the robot
    assert wait_until(lambda: colors(page)["blue"] > 1000, 60)
    page.get_by_role("slider").first.focus()
    page.keyboard.press("Home")
    assert wait_until(lambda: colors(page)["blue"] < AXES, 60)


def test_other_sites_reach_nothing(browser: Browser, start: Start) -> None:
    _, address = view(start)
    with another_site() as evil, unsafe_page(browser) as page:
        page.goto(evil)
        assert page.evaluate(ATTACK, address) == ["refused"] * 3


def test_other_machines_need_the_token(browser: Browser, start: Start) -> None:
    _, address = view(start, "--host", "0.0.0.0")
    parts = urlsplit(address)
    bare = f"http://127.0.0.1:{parts.port}/"
    with unsafe_page(browser) as page:
        answer = page.goto(bare)
        assert answer is not None
        assert answer.status == 403
        assert "the token is missing" in page.inner_text("body")
    with unsafe_page(browser) as page:
        page.goto(f"{bare}?{parts.query}")
        page.get_by_text("There are no frames yet.").wait_for()  # came through the websocket
        assert "token" not in page.url
