"""Test of each display of the 3D view in a browser: what a node publishes is seen."""

from __future__ import annotations

import copy
import io
import math
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import zbot
from tests.conftest import wait_until
from tests.unit.view.messages import MESSAGES, framed, link
from tests.unit.view.test_interactive_markers import box, control, interactive
from tests.web.test_view import ROBOT, view
from zbot.executor.spin_thread import SpinThread
from zbot.libraries.interactive_markers import InteractiveMarkerServer
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.view.arrangement.arrangement import Arrangement, DisplayChoice
from zbot.view.arrangement.rviz_writer import rviz_text
from zbot.view.camera import Camera
from zbot.view.displays import DISPLAYS

from nav2_msgs.msg import Particle, ParticleCloud
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import InteractiveMarkerFeedback, MarkerArray

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")
pytest.importorskip("viser", reason='the view needs viser: pip install "zbot[view]"')

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from playwright.sync_api import Locator, Page

    from tests.conftest import MakeContext, Start
    from tests.web.conftest import Visit

#: The camera looks down, and shows this many pixels for each metre of the floor.
PIXELS_A_METRE = 40
WIDTH, HEIGHT = 1000, 640
COLUMNS, PITCH_M, FIRST = 5, 2.75, (-10.0, 5.5)
GREY = (48, 48, 48)
BESIDE = {"Text", "Image"}  #: shown beside the scene
WHOLE = {"TF", "Grid"}  #: shown everywhere
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
#: Displays with a place of their own in the scene.
PLACED = [one.name for one in DISPLAYS if one.name not in BESIDE | WHOLE]


def topic_of(name: str) -> str:
    return {"RobotModel": "/show/robot_description", "InteractiveMarkers": "/show/update"}.get(
        name, f"/show/{name.lower()}"
    )


def message_of(name: str) -> Any:
    """Return a message that is seen."""
    if name == "MarkerArray":
        return MarkerArray(markers=[copy.deepcopy(MESSAGES["Marker"])])
    if name == "ParticleCloud":
        return framed(ParticleCloud(particles=[Particle(weight=1.0)]))
    message = copy.deepcopy(MESSAGES[name])
    if name == "Twist":
        message.twist.linear.x = 1.0
    if name == "Accel":
        message.accel.linear.x = 1.0
    return message


def place_of(name: str) -> tuple[float, float]:
    number = PLACED.index(name)
    row, column = divmod(number, COLUMNS)
    return FIRST[0] + column * PITCH_M, FIRST[1] - row * PITCH_M


def publish_all(node: Any) -> None:
    """Publish a message for each display, each in a frame of its own."""
    links = [link("map", f"at_{name}") for name in PLACED]
    for one in links:
        place = one.transform.translation
        place.x, place.y = place_of(one.child_frame_id.removeprefix("at_"))
    robot = ROBOT.replace("base_link", "at_RobotModel")
    sent: dict[str, tuple[type[Any], Any]] = {
        "/tf_static": (TFMessage, TFMessage(transforms=links))
    }
    sent[topic_of("RobotModel")] = (String, String(data=robot))
    for kind in DISPLAYS:
        if not kind.has_topic or kind.name in {"RobotModel", "InteractiveMarkers"}:
            continue
        message = message_of(kind.name)
        if kind.name == "MarkerArray":
            framed(message.markers[0], f"at_{kind.name}")
        elif kind.name not in BESIDE:
            framed(message, f"at_{kind.name}")
        sent[topic_of(kind.name)] = (type(message), message)
    for topic, (message_type, message) in sent.items():
        node.create_publisher(message_type, topic, LATCHED).publish(message)


def arrangement(*names: str, scale: float = 1.0) -> str:
    """Return the text of a file with displays, seen from above."""
    choices = [
        DisplayChoice(
            kind.name,
            kind.name,
            topic_of(kind.name) if kind.has_topic else "",
            values={"frame": f"at_{kind.name}", "length": 1.0} if kind.name == "Axes" else {},
        )
        for kind in DISPLAYS
        if kind.name in names
    ]
    far = HEIGHT / 2 / (PIXELS_A_METRE * scale) / math.tan(math.pi / 8)
    camera = Camera(distance=far, yaw=-math.pi / 2, pitch=math.pi / 2)
    return rviz_text(Arrangement(tuple(choices), "map", camera, GREY))


def pixels(page: Page) -> Any:
    from PIL import Image  # noqa: PLC0415 - an extra

    picture = Image.open(io.BytesIO(page.screenshot(animations="disabled"))).convert("RGB")
    return np.asarray(picture, int)


def drawn(picture: Any, name: str) -> int:
    """Return the number of pixels around the place of a display that are not the background."""
    x, y = place_of(name)
    column, row = (round(WIDTH / 2 + PIXELS_A_METRE * x), round(HEIGHT / 2 - PIXELS_A_METRE * y))
    reach = round(PIXELS_A_METRE * PITCH_M / 2)
    part = picture[max(row - reach, 0) : row + reach, max(column - reach, 0) : column + reach]
    return int(np.count_nonzero(np.abs(part - np.array(GREY)).max(axis=2) > 40))


@pytest.fixture
def robot(make_context: MakeContext) -> Iterator[Any]:
    node = zbot.Node("robot", context=make_context())
    executor = SpinThread(node, "test")
    yield node
    executor.stop()


def opened(visit: Callable[..., Visit], start: Start, path: Path, text: str) -> Page:
    """Return a page with an arrangement, without the notice that WebGL runs in software."""
    path.write_text(text)
    _, address = view(start, str(path))
    page = visit(viewport={"width": WIDTH, "height": HEIGHT}).page
    page.goto(address)
    page.get_by_text("The fixed frame is map.").wait_for()
    page.add_style_tag(content=".mantine-Notification-root { display: none }")
    return page


def test_each_display_is_seen(
    visit: Callable[..., Visit], start: Start, robot: Any, tmp_path: Path
) -> None:
    publish_all(robot)
    server = InteractiveMarkerServer(robot, "/show")
    marker = interactive(box(), control("MOVE_AXIS"), x=0.0)
    server.insert(framed(marker, "at_InteractiveMarkers"))
    server.applyChanges()
    names = [kind.name for kind in DISPLAYS if kind.name not in WHOLE]
    page = opened(visit, start, tmp_path / "all.rviz", arrangement(*names))

    def missing() -> list[str]:
        picture = pixels(page)
        return [name for name in PLACED if drawn(picture, name) < 10]

    assert wait_until(lambda: not missing(), 90), missing()
    page.get_by_text("21.5").first.wait_for()  # of the thermometer
    page.get_by_alt_text("picture").first.wait_for()
    for name in names:
        topic = topic_of(name)
        labels = [f"{name}: {topic}", topic, name]
        switch = next(
            found
            for label in labels
            if (found := page.get_by_label(label, exact=True).first).count()
        )
        turn_off(switch)
    assert wait_until(lambda: len(missing()) == len(PLACED), 90), missing()


def turn_off(switch: Locator) -> None:
    """Click a switch until it stays off. The page sets it back if it was not connected."""

    def is_off() -> bool:
        if switch.is_checked():
            switch.click()
            switch.page.wait_for_timeout(200)
        return not switch.is_checked()

    assert wait_until(is_off)


@pytest.mark.parametrize("name", sorted(WHOLE))
def test_the_frames_and_the_grid_are_seen(
    visit: Callable[..., Visit], start: Start, robot: Any, tmp_path: Path, name: str
) -> None:
    links = TFMessage(transforms=[link("map", "at_x", 1.0)])
    robot.create_publisher(TFMessage, "/tf_static", LATCHED).publish(links)
    page = opened(visit, start, tmp_path / "one.rviz", arrangement(name))

    def is_seen() -> bool:
        picture = pixels(page)[200:440, 380:620]
        return bool(np.count_nonzero(np.abs(picture - np.array(GREY)).max(axis=2) > 40) > 20)

    assert wait_until(is_seen, 60)
    page.get_by_label(name, exact=True).first.uncheck()
    assert wait_until(lambda: not is_seen(), 60)


def test_a_user_moves_a_marker_with_the_mouse(
    visit: Callable[..., Visit], start: Start, robot: Any, tmp_path: Path
) -> None:
    robot.create_publisher(TFMessage, "/tf_static", LATCHED).publish(
        TFMessage(transforms=[link("map", "base")])
    )
    heard: list[Any] = []
    server = InteractiveMarkerServer(robot, "/show")
    marker = framed(interactive(box(), control("MOVE_AXIS", "x"), x=0.0))
    server.insert(marker, feedback_callback=heard.append)
    server.applyChanges()
    text = arrangement("InteractiveMarkers", scale=2.5)
    page = opened(visit, start, tmp_path / "one.rviz", text)

    def is_seen() -> bool:
        return bool(np.count_nonzero(pixels(page)[300:340, 480:520, 0] > 150) > 100)

    assert wait_until(is_seen, 60)

    def moved_m() -> float:
        present = server.get("m")
        return 0.0 if present is None else present.pose.position.x

    def drag() -> bool:
        """Drag the arrow, which begins beside the box, by one metre. It may not be there yet."""
        page.mouse.move(545, 320, steps=5)
        page.mouse.down()
        page.mouse.move(645, 320, steps=10)
        page.mouse.up()
        return wait_until(lambda: moved_m() > 0.5, 3)

    assert wait_until(drag, 60)
    assert wait_until(lambda: abs(moved_m() - 1.0) < 0.2), moved_m()  # the end may come later
    kinds = {feedback.event_type for feedback in heard}
    assert {InteractiveMarkerFeedback.MOUSE_DOWN, InteractiveMarkerFeedback.POSE_UPDATE} <= kinds
    assert wait_until(lambda: heard[-1].event_type == InteractiveMarkerFeedback.MOUSE_UP)
    # A click with the tool Interact is sent too.
    page.get_by_role("combobox", name="Tool").click()
    page.get_by_role("option", name="Interact", exact=True).click()
    page.get_by_text("Click an interactive marker.").wait_for()
    page.mouse.click(round(500 + 100 * moved_m()) - 15, 310)
    page.get_by_text("m was clicked.").wait_for()
    click = InteractiveMarkerFeedback.BUTTON_CLICK
    assert wait_until(lambda: heard[-1].event_type == click)
