"""Tests of the sensors of a browser, which another process receives."""

from __future__ import annotations

import math
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.web.conftest import ARGUMENTS, Visit, chromium, command

from sensor_msgs.msg import CameraInfo, CompressedImage, Imu, NavSatFix
from std_msgs.msg import Float32

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from playwright.sync_api import Browser, Page

    from tests.conftest import MakeContext, Spin
    from tests.web.conftest import Server

FAKE_MEDIA = ["--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream"]
#: A phone that lies on its back and is turned by 45 degrees to the left.
TURNED = {"x": 0.0, "y": 0.0, "z": math.sin(math.pi / 8), "w": math.cos(math.pi / 8)}
READINGS: dict[str, dict[str, Any]] = {
    "gyroscope": {"xyz": {"x": 0.1, "y": 0.2, "z": -0.3}},
    "accelerometer": {"xyz": {"x": 1.0, "y": 0.0, "z": 9.8}},
    "linear-acceleration": {"xyz": {"x": 1.0, "y": 0.0, "z": 0.0}},
    "relative-orientation": {"quaternion": TURNED},
    "absolute-orientation": {"quaternion": TURNED},
}
PHONE = {"width": 390, "height": 844}


class Listener:
    """Node of this process, which is another one than that of the page, and its messages."""

    def __init__(self, context: zbot.Context, spin: Spin) -> None:
        self.node = zbot.Node("listener", context=context)
        self.heard: dict[str, list[Any]] = {}
        spin(self.node)

    def listen(self, msg_type: Any, topic: str) -> list[Any]:
        heard = self.heard[topic] = []
        self.node.create_subscription(msg_type, topic, heard.append, 10)
        return heard


@pytest.fixture
def listener(make_context: MakeContext, spin: Spin, domain: int) -> Listener:  # noqa: ARG001
    return Listener(make_context(), spin)


@pytest.fixture
def media_page(browser: Browser) -> Iterator[Page]:
    """Return a page of a browser whose camera and microphone are Chromium's own inventions."""
    arguments = [*ARGUMENTS, *FAKE_MEDIA]
    with_media = browser.browser_type.launch(executable_path=chromium(), args=arguments)
    visit = Visit(with_media)
    yield visit.page
    with_media.close()
    assert visit.new_errors() == []


def switch(page: Page, name: str) -> Any:
    return page.get_by_role("switch", name=name)


def test_the_camera_is_published_with_its_size(
    server: Server, media_page: Page, listener: Listener
) -> None:
    images = listener.listen(CompressedImage, "/laptop/camera/image_raw/compressed")
    infos = listener.listen(CameraInfo, "/laptop/camera/camera_info")
    media_page.goto(f"{server.address}/sensors")
    switch(media_page, "Camera").click()
    assert wait_until(lambda: len(images) > 2 and len(infos) > 2)
    image, info = images[-1], infos[-1]
    assert image.format == "jpeg"
    assert bytes(image.data[:3]) == b"\xff\xd8\xff"
    assert image.header.frame_id == info.header.frame_id == "laptop_camera_optical"
    assert (info.width, info.height) == (640, 480)
    assert info.k[0] == 0  # not calibrated
    expect(command(media_page)).to_contain_text("zbot topic hz /laptop/camera/image_raw/compressed")
    expect(media_page.get_by_text("published")).to_be_visible()


def test_the_microphone_is_published_as_a_level(
    server: Server, media_page: Page, listener: Listener
) -> None:
    levels = listener.listen(Float32, "/laptop/microphone/level")
    media_page.goto(f"{server.address}/sensors")
    switch(media_page, "Microphone level").click()
    assert wait_until(lambda: len(levels) > 5)
    assert wait_until(lambda: any(level.data > 0 for level in levels))  # Chromium beeps
    assert all(0 <= level.data <= 1 for level in levels)


@contextmanager
def emulated(page: Page, readings: dict[str, dict[str, Any]]) -> Iterator[None]:
    # Chromium asks nobody. Its headless shell refuses what is not granted.
    page.context.grant_permissions(["accelerometer", "gyroscope", "magnetometer"])
    session = page.context.new_cdp_session(page)
    for name, reading in readings.items():
        session.send("Emulation.setSensorOverrideEnabled", {"enabled": True, "type": name})
        session.send("Emulation.setSensorOverrideReadings", {"type": name, "reading": reading})
    yield
    session.detach()


def test_motion_is_published_as_imu_in_the_units_of_ros(
    visit: Callable[..., Visit], server: Server, listener: Listener
) -> None:
    messages = listener.listen(Imu, "/phone/imu")
    page = visit(viewport=PHONE, is_mobile=True, has_touch=True, user_agent="Mobile").page
    with emulated(page, READINGS):
        page.goto(f"{server.address}/sensors")
        switch(page, "Orientation and acceleration").tap()
        assert wait_until(lambda: len(messages) > 5)
    message = messages[-1]
    assert message.header.frame_id == "phone_imu"
    assert message.orientation.z == pytest.approx(TURNED["z"], abs=0.01)
    assert message.orientation.w == pytest.approx(TURNED["w"], abs=0.01)
    rate = message.angular_velocity
    assert (rate.x, rate.y, rate.z) == pytest.approx((0.1, 0.2, -0.3), abs=0.002)
    acceleration = message.linear_acceleration
    assert (acceleration.x, acceleration.z) == pytest.approx((1.0, 9.8), abs=0.06)
    assert message.orientation_covariance[0] == message.angular_velocity_covariance[0] == 0


def test_what_a_phone_does_not_measure_has_the_covariance_minus_one(
    visit: Callable[..., Visit], server: Server, listener: Listener
) -> None:
    messages = listener.listen(Imu, "/laptop/imu")
    page = visit().page
    with emulated(page, {"relative-orientation": READINGS["relative-orientation"]}):
        page.goto(f"{server.address}/sensors")
        switch(page, "Orientation and acceleration").click()
        assert wait_until(lambda: bool(messages))
    assert messages[-1].orientation_covariance[0] == 0
    assert messages[-1].angular_velocity_covariance[0] == -1
    assert messages[-1].linear_acceleration_covariance[0] == -1


def test_the_position_is_published_with_its_accuracy(
    visit: Callable[..., Visit], server: Server, listener: Listener
) -> None:
    messages = listener.listen(NavSatFix, "/laptop/fix")
    place = {"latitude": 46.5, "longitude": 6.6, "accuracy": 24.477}
    page = visit(geolocation=place, permissions=["geolocation"]).page
    page.goto(f"{server.address}/sensors")
    switch(page, "Position").click()
    assert wait_until(lambda: bool(messages))
    message = messages[-1]
    assert (message.latitude, message.longitude) == (46.5, 6.6)
    assert message.status.status == message.status.STATUS_FIX
    assert message.position_covariance[0] == pytest.approx(100)
    assert message.position_covariance_type == message.COVARIANCE_TYPE_APPROXIMATED
    assert math.isnan(message.altitude)


def test_a_refusal_of_the_browser_is_one_sentence(
    visit: Callable[..., Visit], server: Server
) -> None:
    page = visit().page
    page.goto(f"{server.address}/sensors")
    switch(page, "Orientation and acceleration").click()
    expect(page.get_by_text("this device may have no such sensor")).to_be_visible()
    expect(switch(page, "Orientation and acceleration")).not_to_be_checked()
    forbidding = visit(permissions=[]).page
    forbidding.goto(f"{server.address}/sensors")
    switch(forbidding, "Position").click()
    expect(forbidding.get_by_text("You did not allow it. Allow the position")).to_be_visible()
    switch(forbidding, "Orientation and acceleration").click()
    expect(forbidding.get_by_text("Allow the motion sensor for this page")).to_be_visible()
    switch(forbidding, "Camera").click()
    expect(forbidding.get_by_text("camera").last).to_be_visible()
    expect(switch(forbidding, "Camera")).not_to_be_checked()


def test_two_browsers_have_different_names_and_a_closed_page_stops(
    visit: Callable[..., Visit], server: Server, listener: Listener
) -> None:
    place = {"latitude": 46.5, "longitude": 6.6, "accuracy": 10}
    first, second = (visit(geolocation=place, permissions=["geolocation"]).page for _ in range(2))
    for page in (first, second):
        page.goto(f"{server.address}/sensors")
        switch(page, "Position").click()
        expect(page.get_by_text("published")).to_be_visible()
    assert wait_until(lambda: listener.node.count_publishers("/laptop_2/fix") == 1)
    name = second.get_by_label("Name", exact=True)
    name.fill("laptop")  # taken
    expect(second.get_by_text("Another browser publishes /laptop/fix")).to_be_visible()
    first.close()
    assert wait_until(lambda: listener.node.count_publishers("/laptop/fix") == 0)
    switch(second, "Position").click()
    assert wait_until(lambda: listener.node.count_publishers("/laptop/fix") == 1)


def test_settings_stay_in_the_browser(visit: Callable[..., Visit], server: Server) -> None:
    page = visit().page
    page.goto(f"{server.address}/sensors")
    page.get_by_label("Name", exact=True).fill("ana")
    page.get_by_label("Topic of Position").fill("gps/fix")
    page.get_by_label("Rate of Camera, Hz").fill("2")
    kept = "localStorage.getItem('zbot-sensors') ?? ''"
    wanted = ('"ana"', '"gps/fix"', '"hz":2')
    assert wait_until(lambda: all(word in page.evaluate(kept) for word in wanted))
    page.reload()
    expect(page.get_by_label("Name", exact=True)).to_have_value("ana")
    expect(page.get_by_label("Topic of Position")).to_have_value("gps/fix")
    expect(switch(page, "Position")).not_to_be_checked()


def test_a_wrong_topic_name_is_one_sentence(visit: Callable[..., Visit], server: Server) -> None:
    place = {"latitude": 46.5, "longitude": 6.6, "accuracy": 10}
    page = visit(geolocation=place, permissions=["geolocation"]).page
    page.goto(f"{server.address}/sensors")
    switch(page, "Position").click()
    expect(page.get_by_text("published")).to_be_visible()
    page.get_by_label("Topic of Position").fill("my fix")
    expect(page.locator(".zb-sensor").filter(has_text="Position")).to_contain_text("my fix")
    expect(switch(page, "Position")).not_to_be_checked()


def test_a_read_only_page_publishes_nothing(read_only_server: Server, page: Page) -> None:
    page.goto(f"{read_only_server.address}/sensors")
    expect(page.get_by_text("This page is read-only: it cannot publish.")).to_be_visible()
    expect(page.get_by_role("switch")).to_have_count(0)
