from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import wait_until
from tests.web.conftest import command

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

from geometry_msgs.msg import Twist
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import Float64, String

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Page

    from tests.conftest import Spinner
    from tests.web.conftest import Server, Visit


@pytest.fixture
def node(make_context: Callable[[], zbot.Context]) -> zbot.Node:
    return zbot.Node("robot", context=make_context())


def row(topic: str) -> str:
    return f".zb-list tr[data-key='{topic}']"


def test_list_shows_the_nodes_and_the_rate_of_a_topic(
    server: Server, page: Page, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_timer(0.02, lambda: publisher.publish(String(data="hello")))
    node.create_subscription(Twist, "cmd_vel", print, 10)
    spin(node)
    page.goto(f"{server.address}/topics")
    page.wait_for_selector(f"{row('/chatter')}:has-text('std_msgs/msg/String')")
    page.wait_for_selector(f"{row('/chatter')}:has-text('Hz'):has-text('hello')")
    cells = page.locator(f"{row('/cmd_vel')} td")
    expect(cells.nth(2)).to_have_text("0")
    expect(cells.nth(3)).to_have_text("1")
    page.fill("input[aria-label=Filter]", "chat")
    page.wait_for_selector(row("/cmd_vel"), state="detached")
    page.wait_for_selector(row("/chatter"))


def test_topic_appears_and_disappears_at_once(server: Server, page: Page, node: zbot.Node) -> None:
    page.goto(f"{server.address}/topics")
    page.wait_for_selector(".zb-list")
    publisher = node.create_publisher(String, "chatter", 10)
    page.wait_for_selector(row("/chatter"))
    node.destroy_publisher(publisher)
    page.wait_for_selector(row("/chatter"), state="detached")


def test_script_in_a_message_is_text(
    server: Server, page: Page, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    evil = "<script>window.pwned = 1</script><img src=x onerror='window.pwned = 2'>`${pwned=3}`"
    publisher = node.create_publisher(String, "evil", 10)
    node.create_timer(0.05, lambda: publisher.publish(String(data=evil)))
    spin(node)
    page.goto(f"{server.address}/topics?topic=/evil")
    page.wait_for_function("document.querySelector('.zb-tree')?.textContent.includes('<script>')")
    page.wait_for_function("document.querySelector('.zb-list')?.textContent.includes('<script>')")
    assert page.evaluate("window.pwned") is None
    assert page.locator(".zb-main img").count() == 0


def test_details_show_the_tree_and_open_the_plot(
    server: Server, page: Page, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    publisher = node.create_publisher(Twist, "cmd_vel", 10)
    message = Twist()
    message.linear.x = 1.25
    node.create_timer(0.05, lambda: publisher.publish(message))
    spin(node)
    page.goto(f"{server.address}/topics")
    page.click(row("/cmd_vel"))
    field = page.locator(".zb-tree tr[data-key='linear.x']")
    expect(field.locator("td").nth(1)).to_have_text("1.25")
    expect(command(page)).to_have_text("zbot topic echo /cmd_vel")
    expect(page).to_have_url(re.compile(re.escape("?topic=%2Fcmd_vel") + "$"))
    expect(field.locator("a")).to_have_attribute("href", "/plot?curve=%2Fcmd_vel.linear.x")
    page.reload()
    page.wait_for_selector(".zb-tree tr[data-key='linear.x']")


def test_details_follow_a_new_type_of_the_topic(
    server: Server, page: Page, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    text = node.create_publisher(String, "changing", 10)
    timer = node.create_timer(0.05, lambda: text.publish(String(data="old text")))
    spin(node)
    page.goto(f"{server.address}/topics?topic=/changing")
    page.wait_for_selector(".zb-tree tr[data-key='data']:has-text('old text')")
    node.destroy_timer(timer)
    node.destroy_publisher(text)
    number = node.create_publisher(Twist, "changing", 10)
    page.wait_for_selector("input[aria-label='linear.x']", state="attached")
    page.wait_for_selector(".zb-side:has-text('old text')", state="detached")
    node.create_timer(0.05, lambda: number.publish(Twist()))
    page.wait_for_selector(".zb-tree tr[data-key='linear.x']")


def test_publish_form_publishes_once_and_again(
    server: Server, page: Page, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    came: list[float] = []
    node.create_subscription(Twist, "cmd_vel", lambda message: came.append(message.linear.x), 10)
    spin(node)
    page.goto(f"{server.address}/topics?topic=/cmd_vel")
    page.fill("input[aria-label='linear.x']", "2.5")
    page.click("text=Publish once")
    assert wait_until(lambda: came == [2.5], 10)
    expect(command(page)).to_have_text(
        "zbot topic pub --once /cmd_vel geometry_msgs/msg/Twist '{linear: {x: 2.5}}'"
    )
    page.fill("input[aria-label='Rate in Hz']", "50")
    page.click("text=Repeat")
    assert wait_until(lambda: len(came) > 20, 10)
    page.fill("input[aria-label='linear.x']", "-1")
    assert wait_until(lambda: bool(came) and came[-1] == -1.0, 10)
    page.click("text=Stop")
    assert wait_until(lambda: not node.get_publishers_info_by_topic("/cmd_vel"), 10)


def test_publish_form_reports_invalid_entries(server: Server, page: Page, node: zbot.Node) -> None:
    node.create_subscription(Float64, "x", print, 10)
    page.goto(f"{server.address}/topics?topic=/x")
    page.fill("input[aria-label='data']", "1,5")
    page.wait_for_selector("text=write a point, not a comma")
    expect(page.locator("button:has-text('Publish once')")).to_be_disabled()


def test_images_and_scans_are_shown_as_pictures(
    server: Server, page: Page, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    camera = node.create_publisher(Image, "camera", 10)
    laser = node.create_publisher(LaserScan, "scan", 10)
    image = Image(width=64, height=48, encoding="rgb8", data=bytes(64 * 48 * 3))
    scan = LaserScan(
        angle_increment=0.1, range_min=0.1, range_max=10.0, ranges=[2.0, 50.0, float("nan"), 3.0]
    )

    def publish() -> None:
        camera.publish(image)
        laser.publish(scan)

    node.create_timer(0.05, publish)
    spin(node)
    page.goto(f"{server.address}/topics?topic=/camera")
    page.wait_for_function("document.querySelector('.zb-picture img')?.naturalWidth === 64")
    page.goto(f"{server.address}/topics?topic=/scan")
    page.wait_for_selector(".zb-scan-hit", state="attached")
    expect(page.locator(".zb-scan-hit")).to_have_attribute("d", re.compile("^[^M]*M[^M]*M[^M]*$"))


def test_read_only_page_has_no_form(read_only_server: Server, page: Page, node: zbot.Node) -> None:
    node.create_subscription(Float64, "x", print, 10)
    page.goto(f"{read_only_server.address}/topics?topic=/x")
    page.wait_for_selector("text=read-only")
    page.wait_for_selector(".zb-side >> text=std_msgs/msg/Float64")
    assert page.locator(".zb-publish").count() == 0


def test_reloads_and_windows_leave_no_subscription(
    server: Server, another_page: Callable[[], Page], node: zbot.Node
) -> None:
    node.create_publisher(String, "chatter", 10)
    first, second = another_page(), another_page()
    for page in (first, second):
        page.goto(f"{server.address}/topics?topic=/chatter")
        page.wait_for_selector(row("/chatter"))
    assert wait_until(lambda: node.count_subscribers("/chatter") == 1, 10)
    for _ in range(12):
        first.reload(wait_until="domcontentloaded")
    first.wait_for_selector(row("/chatter"))
    assert wait_until(lambda: node.count_subscribers("/chatter") == 1)
    for page in (first, second):
        page.close()
    # The server keeps a closed page for 10 s, but its subscriptions end at once.
    assert wait_until(lambda: node.count_subscribers("/chatter") == 0, 8)


def test_a_row_that_moves_during_a_click_is_chosen(
    server: Server, page: Page, node: zbot.Node
) -> None:
    node.create_publisher(String, "chatter", 10)
    page.goto(f"{server.address}/topics")
    box = page.locator(row("/chatter")).bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + 20, box["y"] + box["height"] / 2)
    page.mouse.down()
    for name in ("a", "b", "c"):
        node.create_publisher(String, name, 10)
        page.wait_for_selector(row(f"/{name}"))
    page.mouse.up()
    expect(page.locator(".zb-side .zb-name")).to_have_text("/chatter")


def test_nothing_is_lost_while_the_connection_is(
    server: Server, page: Page, node: zbot.Node
) -> None:
    node.create_publisher(String, "chatter", 10)
    page.goto(f"{server.address}/topics")
    page.wait_for_selector(row("/chatter"))
    page.evaluate("""() => {
        window.isSamePage = true;
        socket.io.randomizationFactor(0);
        socket.io.reconnectionDelay(5000);
        socket.io.engine.close();
    }""")
    page.wait_for_function("!socket.connected")
    page.fill("input[aria-label=Filter]", "chat")
    page.click(row("/chatter"))
    page.wait_for_function("socket.connected")
    expect(page.locator(".zb-side")).to_contain_text("/chatter")
    expect(page.get_by_label("Filter")).to_have_value("chat")
    assert page.evaluate("window.isSamePage")


def test_hidden_page_has_no_subscription(server: Server, page: Page, node: zbot.Node) -> None:
    node.create_publisher(String, "chatter", 10)
    page.goto(f"{server.address}/topics")
    page.wait_for_selector(row("/chatter"))
    assert wait_until(lambda: node.count_subscribers("/chatter") == 1, 10)
    pretend = """hidden => {
        Object.defineProperty(document, "hidden", {value: hidden, configurable: true});
        document.dispatchEvent(new Event("visibilitychange"));
    }"""
    page.evaluate(pretend, True)
    assert wait_until(lambda: node.count_subscribers("/chatter") == 0, 10)
    page.evaluate(pretend, False)
    assert wait_until(lambda: node.count_subscribers("/chatter") == 1, 10)


def test_command_can_be_copied(server: Server, visit: Callable[..., Visit]) -> None:
    window = visit(permissions=["clipboard-read", "clipboard-write"])
    window.page.goto(f"{server.address}/topics")
    window.page.click("button[aria-label=Copy]")
    window.page.wait_for_selector("text=Copied")
    assert window.page.evaluate("navigator.clipboard.readText()") == "zbot topic list -t"


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_theme_follows_the_system_until_it_is_chosen(
    server: Server, visit: Callable[..., Visit], scheme: str
) -> None:
    page = visit(color_scheme=scheme).page
    page.goto(f"{server.address}/topics")
    is_dark = "document.body.classList.contains('body--dark')"
    page.wait_for_function(f"{is_dark} === {str(scheme == 'dark').lower()}")
    page.click("button[aria-label='Light or dark']")
    page.wait_for_function(f"{is_dark} === {str(scheme != 'dark').lower()}")
    page.reload()
    page.wait_for_function(f"{is_dark} === {str(scheme != 'dark').lower()}")
    assert re.match(r"rgb\(\d+, \d+, \d+\)", page.evaluate("getComputedStyle(document.body).color"))


def test_a_hundred_topics_are_folded_by_namespace(
    server: Server, page: Page, node: zbot.Node
) -> None:
    for number in range(100):
        node.create_publisher(Float64, f"/robot{number // 20}/sensors/value_{number % 20}", 10)
    page.goto(f"{server.address}/topics")
    namespace = page.locator(row("/robot3/sensors/"))
    expect(namespace).to_contain_text("20\N{NO-BREAK SPACE}topics")
    expect(page.locator(row("/robot3/sensors/value_7"))).to_have_count(0)
    namespace.press("Enter")
    expect(page.locator(row("/robot3/sensors/value_7"))).to_be_visible()
    expect(page.locator(row("/robot4/sensors/value_7"))).to_have_count(0)
    page.fill("input[aria-label=Filter]", "value_7")
    expect(page.locator(row("/robot4/sensors/value_7"))).to_be_visible()
