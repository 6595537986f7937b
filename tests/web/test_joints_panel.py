"""Tests of the panel Joints: sliders that move a robot, with the mouse and with keys."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any

import pytest

import zbot as library
from tests.cli.command import zbot
from tests.conftest import wait_until
from tests.web.conftest import command
from zbot_nodes.description.joint_state_publisher_gui import JointStatePublisherGui

from sensor_msgs.msg import JointState

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from playwright.sync_api import Locator, Page

    from tests.conftest import MakeContext, Spin
    from tests.web.conftest import Server, Visit


def joint(name: str, kind: str, more: str = "") -> str:
    limit = '<limit lower="-1" upper="2" effort="1" velocity="1"/>'
    return (
        f'<link name="{name}_link"/><joint name="{name}" type="{kind}"><parent link="base"/>'
        f'<child link="{name}_link"/>{"" if kind == "continuous" else limit}{more}</joint>'
    )


JOINTS = {
    "elbow": joint("elbow", "revolute"),
    "lift": joint("lift", "prismatic"),
    "wheel": joint("wheel", "continuous"),
    "finger": joint("finger", "revolute", '<mimic joint="elbow" multiplier="-0.5"/>'),
}
URDF = f'<robot name="r"><link name="base"/>{"".join(JOINTS.values())}</robot>'


class Arm:
    """Robot with sliders in a namespace, and what it publishes."""

    def __init__(
        self, context: library.Context, spin: Spin, path: Path, namespace: str = "/"
    ) -> None:
        path.write_text(URDF)
        rate = [library.Parameter("rate", value=50)]
        options: dict[str, Any] = {"context": context, "namespace": namespace}
        spin(JointStatePublisherGui(str(path), parameter_overrides=rate, **options))
        watcher = library.Node("watcher", **options)
        self.heard: list[JointState] = []
        watcher.create_subscription(JointState, "joint_states", self.heard.append, 10)
        spin(watcher)

    def at(self, name: str) -> float:
        if not self.heard:
            return math.nan
        message = self.heard[-1]
        return float(message.position[message.name.index(name)])


@pytest.fixture
def arm(make_context: MakeContext, spin: Spin, tmp_path: Path) -> Arm:
    return Arm(make_context(), spin, tmp_path / "arm.urdf")


def entry(page: Page, name: str) -> Locator:
    return page.locator(f".zb-parameter[data-name='joints.{name}']")


def test_keys_move_the_joints_within_their_limits(server: Server, page: Page, arm: Arm) -> None:
    page.goto(f"{server.address}/joints")
    # Tab reaches this part of a slider.
    track = page.get_by_role("slider", name="elbow slider").locator("[tabindex='0']")
    track.focus()

    def reaches(key: str, position: float) -> bool:
        for _ in range(10):
            page.keyboard.press(key)
        return wait_until(lambda: arm.at("elbow") == position, 0.5)

    assert wait_until(lambda: reaches("PageUp", 2.0))
    assert arm.at("finger") == -1.0
    expect(entry(page, "elbow")).to_contain_text("114.6°")
    expect(entry(page, "elbow")).to_contain_text("-1 to 2")
    expect(page.get_by_text("finger follows: -1.000")).to_be_visible()
    expect(command(page)).to_have_text("zbot param set /joint_state_publisher joints.elbow 2.0")
    track.focus()
    assert wait_until(lambda: reaches("PageDown", -1.0))
    page.keyboard.press("ArrowRight")
    assert wait_until(lambda: arm.at("elbow") > -1.0)
    lift = page.get_by_label("lift", exact=True)
    lift.fill("0.25")
    lift.press("Enter")
    assert wait_until(lambda: arm.at("lift") == 0.25)
    expect(entry(page, "lift")).to_contain_text("position in m")
    expect(entry(page, "lift")).not_to_contain_text("°")
    lift.fill("7")
    lift.press("Enter")
    expect(entry(page, "lift")).to_contain_text("out of range")
    expect(lift).to_have_value("0.25")
    expect(entry(page, "wheel")).to_contain_text("-3.14159 to 3.14159")


def test_a_value_of_another_program_does_not_replace_what_is_typed(
    server: Server, page: Page, arm: Arm
) -> None:
    page.goto(f"{server.address}/joints")
    lift = page.get_by_label("lift", exact=True)
    expect(lift).to_have_value("0.0")
    lift.fill("7")
    zbot("param", "set", "/joint_state_publisher", "joints.lift", "0.5")
    assert wait_until(lambda: arm.at("lift") == 0.5)
    slider = page.get_by_role("slider", name="lift slider")
    expect(slider).to_have_attribute("aria-valuenow", "0.5")
    expect(lift).to_have_value("7")
    lift.press("Enter")
    expect(entry(page, "lift")).to_contain_text("out of range")
    expect(lift).to_have_value("0.5")


def test_all_joints_are_centered_and_moved_at_random(server: Server, page: Page, arm: Arm) -> None:
    page.goto(f"{server.address}/joints")
    expect(page.get_by_label("elbow", exact=True)).to_have_value("0.0")
    page.get_by_role("button", name="Randomize").press("Enter")
    assert wait_until(lambda: all(arm.at(name) for name in ("elbow", "lift", "wheel")))
    expect(page.get_by_label("elbow", exact=True)).not_to_have_value("0.0")
    page.get_by_role("button", name="Center").press("Enter")
    assert wait_until(lambda: not any(arm.at(name) for name in JOINTS))
    expect(page.get_by_label("elbow", exact=True)).to_have_value("0.0")
    expect(command(page)).to_have_text(
        "zbot service call /joint_state_publisher/center std_srvs/srv/Empty"
    )


def test_values_that_other_programs_set_are_shown(server: Server, page: Page, arm: Arm) -> None:
    page.goto(f"{server.address}/joints?node=/joint_state_publisher")
    expect(page.get_by_label("elbow", exact=True)).to_have_value("0.0")
    assert zbot("param", "set", "/joint_state_publisher", "joints.elbow", "1.0").code == 0
    expect(page.get_by_label("elbow", exact=True)).to_have_value("1.0")
    expect(entry(page, "elbow")).to_contain_text("57.3°")
    assert wait_until(lambda: arm.at("elbow") == 1.0)


def test_the_user_chooses_one_of_several_robots(
    server: Server,
    page: Page,
    arm: Arm,
    make_context: MakeContext,
    spin: Spin,
    tmp_path: Path,
) -> None:
    other = Arm(make_context(), spin, tmp_path / "other.urdf", "/robot2")
    page.goto(f"{server.address}/joints")
    expect(entry(page, "elbow")).to_be_visible()
    page.get_by_label("Robot", exact=True).click()
    page.get_by_role("option", name="/robot2/joint_state_publisher").click()
    expect(page).to_have_url(re.compile(r"node=%2Frobot2|node=/robot2"))
    page.get_by_role("button", name="Randomize").click()
    assert wait_until(lambda: bool(other.at("elbow")))
    assert arm.at("elbow") == 0.0


def test_on_a_phone_all_is_on_the_screen(
    server: Server, visit: Callable[..., Visit], arm: Arm
) -> None:
    page = visit(viewport={"width": 390, "height": 844}, has_touch=True).page
    page.goto(f"{server.address}/joints")
    for name in ("elbow", "lift", "wheel"):
        box = entry(page, name).bounding_box()
        assert box is not None
        assert box["x"] + box["width"] <= 390
        slider = page.get_by_role("slider", name=f"{name} slider").bounding_box()
        assert slider is not None
        assert slider["width"] >= 120
    assert arm.at("elbow") == 0.0 or wait_until(lambda: bool(arm.heard))


def test_a_read_only_page_shows_positions(read_only_server: Server, page: Page, arm: Arm) -> None:
    page.goto(f"{read_only_server.address}/joints")
    expect(entry(page, "elbow")).to_contain_text("0.0°")
    expect(page.get_by_role("slider")).to_have_count(0)
    expect(page.get_by_role("button", name="Randomize")).to_be_hidden()
    assert wait_until(lambda: arm.at("elbow") == 0.0)


def test_without_sliders_the_page_says_what_to_start(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/joints")
    expect(page.get_by_role("status").get_by_text("No node has sliders")).to_contain_text(
        "zbot run joint_state_publisher_gui joint_state_publisher_gui"
    )
    page.goto(f"{server.address}/joints?node=/gone")
    expect(page.get_by_text("/gone does not run.")).to_be_visible()
