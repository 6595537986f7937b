"""Test of a whole robot that is driven with the stick of the page."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until

from nav_msgs.msg import Odometry

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

if TYPE_CHECKING:
    from playwright.sync_api import Page

    from tests.conftest import MakeContext, Spin, Start
    from tests.web.conftest import Server

ROVER = Path(__file__).parents[1] / "programs" / "rover"


def test_the_stick_of_the_page_drives_the_robot(
    server: Server,
    page: Page,
    start: Start,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    make_context: MakeContext,
    spin: Spin,
) -> None:
    pytest.importorskip("xacro", reason="an extra: pip install 'zbot[robot]'")
    shutil.copytree(ROVER / "src", tmp_path / "src")
    monkeypatch.setenv("ZBOT_LOG_DIR", str(tmp_path / "log"))
    program = start("zbot", "launch", "rover_bringup", "rover.launch.py", "gazebo:=false")
    program.wait_for("Configured and activated arm_controller", 60)
    odometry: list[Any] = []
    node = zbot.Node("watcher", context=make_context())
    node.create_subscription(Odometry, "/base_controller/odom", odometry.append, 10)
    spin(node)

    def x() -> float:
        page.wait_for_timeout(20)  # handles the browser's events
        return odometry[-1].pose.pose.position.x if odometry else 0.0

    page.goto(f"{server.address}/stick?topic=/joy")
    button = page.get_by_role("button", name="4", exact=True)
    box = page.get_by_label("Left stick").bounding_box()
    assert box is not None

    def hold() -> None:
        page.mouse.up()
        if button.get_attribute("aria-pressed") != "true":
            button.click()
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        page.mouse.down()
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + 20, steps=4)

    def has_driven() -> bool:
        if page.locator(".zb-drive-said").inner_text():
            hold()  # the machine is so busy that the robot was stopped, and all was released
        return x() > 0.2

    hold()
    assert wait_until(has_driven, 60)
    page.mouse.up()
    assert wait_until(lambda: x() > 0.2 and odometry[-1].twist.twist.linear.x == 0, 30)
    page.goto(f"{server.address}/topics?topic=/base_controller/odom")
    page.get_by_text("/base_controller/odom").first.wait_for()
    assert program.stop(timeout=20) == 0
