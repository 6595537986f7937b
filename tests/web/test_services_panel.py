"""Tests of the services panel: forms, responses, feedback and cancellation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.web.conftest import command
from zbot.action import ActionServer, CancelResponse

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Locator, Page

    from tests.conftest import Program, Spin
    from tests.web.conftest import Server


@pytest.fixture
def node(make_context: Callable[[], zbot.Context]) -> zbot.Node:
    return zbot.Node("worker", context=make_context())


def row(page: Page, key: str) -> Locator:
    return page.locator(f".zb-list tr[data-key='{key}']")


def test_a_form_calls_spawn_and_a_second_turtle_is_drawn(
    turtlesim: Program, server: Server, page: Page
) -> None:
    page.goto(f"{server.address}/services")
    row(page, "/spawn").click()
    expect(page.locator(".zb-side")).to_contain_text("turtlesim/srv/Spawn")
    page.get_by_label("x", exact=True).fill("7")
    page.get_by_label("name", exact=True).fill("eve")
    expect(command(page)).to_have_text(
        'zbot service call /spawn turtlesim/srv/Spawn "{x: 7.0, name: eve}"'
    )
    page.get_by_role("button", name="Call").click()
    expect(page.locator(".zb-message")).to_contain_text("eve")
    turtlesim.wait_for("Spawning turtle [eve] at x=[7.000000]")
    page.goto(f"{server.address}/turtle")
    expect(page.locator("[data-turtle=eve]")).to_be_visible()
    expect(page.locator("[data-turtle]")).to_have_count(2)


def test_standard_services_are_shown_on_request(
    server: Server, page: Page, node: zbot.Node
) -> None:
    node.create_service(AddTwoInts, "add", lambda _, response: response)
    page.goto(f"{server.address}/services")
    expect(row(page, "/add")).to_contain_text("/worker")
    expect(row(page, "/worker/get_parameters")).to_have_count(0)
    page.get_by_text("Services of every node").click()
    expect(row(page, "/worker/get_parameters")).to_be_visible()
    page.get_by_label("Filter").fill("add")
    expect(row(page, "/worker/get_parameters")).to_have_count(0)


def test_an_exception_is_shown(server: Server, page: Page, node: zbot.Node, spin: Spin) -> None:
    def fail(_request: object, _response: object) -> AddTwoInts.Response:
        raise ValueError("the <b>numbers</b> are on strike")

    node.create_service(AddTwoInts, "add", fail)
    spin(node)
    page.goto(f"{server.address}/services?service=/add")
    page.get_by_role("button", name="Call").click()
    expect(page.locator(".zb-message")).to_contain_text("the <b>numbers</b> are on strike")


def test_an_invalid_entry_cannot_be_sent(server: Server, page: Page, node: zbot.Node) -> None:
    node.create_service(AddTwoInts, "add", lambda _, response: response)
    page.goto(f"{server.address}/services?service=/add")
    page.get_by_label("a", exact=True).fill("two")
    expect(page.get_by_text("not 'two'; a is an int64: write a: 2")).to_be_visible()
    expect(page.get_by_role("button", name="Call")).to_be_disabled()


def test_a_read_only_page_cannot_call(
    read_only_server: Server, page: Page, node: zbot.Node
) -> None:
    node.create_service(AddTwoInts, "add", lambda _, response: response)
    page.goto(f"{read_only_server.address}/services?service=/add")
    expect(page.get_by_text("This page is read-only.")).to_be_visible()
    expect(page.get_by_role("button", name="Call")).to_have_count(0)


def test_a_goal_shows_its_feedback_and_its_result(
    turtlesim: Program, server: Server, page: Page
) -> None:
    page.goto(f"{server.address}/actions")
    row(page, "/turtle1/rotate_absolute").click()
    page.get_by_label("theta", exact=True).fill("1")
    expect(command(page)).to_have_text(
        "zbot action send_goal --feedback /turtle1/rotate_absolute "
        'turtlesim/action/RotateAbsolute "{theta: 1.0}"'
    )
    page.get_by_role("button", name="Send goal").click()
    expect(page.locator(".zb-message").first).to_contain_text("remaining")
    expect(page.locator(".zb-goal-state")).to_have_text("succeeded")
    expect(page.locator(".zb-message").nth(1)).to_contain_text("delta")
    turtlesim.wait_for("Rotation goal completed successfully")


def test_a_goal_can_be_cancelled(server: Server, page: Page, node: zbot.Node, spin: Spin) -> None:
    cancelled: zbot.Future[bool] = zbot.Future()

    async def execute(goal: Any) -> Fibonacci.Result:
        goal.publish_feedback(Fibonacci.Feedback(sequence=[31]))
        await cancelled
        goal.canceled()
        return Fibonacci.Result(sequence=[47])

    def stop(_: object) -> CancelResponse:
        cancelled.set_result(True)
        return CancelResponse.ACCEPT

    ActionServer(node, Fibonacci, "count", execute, cancel_callback=stop)
    spin(node)
    page.goto(f"{server.address}/actions?action=/count")
    page.get_by_role("button", name="Send goal").click()
    expect(page.locator(".zb-message").first).to_contain_text("31")
    page.get_by_role("button", name="Cancel").click()
    expect(page.locator(".zb-goal-state")).to_have_text("canceled")
    expect(page.locator(".zb-message").nth(1)).to_contain_text("47")


def test_a_rejected_or_running_goal_is_shown(
    server: Server, page: Page, node: zbot.Node, spin: Spin
) -> None:
    ended: zbot.Future[bool] = zbot.Future()

    async def execute(goal: object) -> Fibonacci.Result:
        await ended
        goal.succeed()  # type: ignore[attr-defined] # a server's goal handle
        return Fibonacci.Result(sequence=[1, 1, 2])

    ActionServer(node, Fibonacci, "count", execute, cancel_callback=lambda _: CancelResponse.REJECT)
    spin(node)
    page.goto(f"{server.address}/actions?action=/count")
    page.get_by_role("button", name="Send goal").click()
    expect(page.locator(".zb-goal-state")).to_have_text("accepted")
    page.get_by_role("button", name="Cancel").click()
    expect(page.get_by_text("The server refused to cancel")).to_be_visible()
    expect(page.get_by_role("button", name="Cancel")).to_be_enabled()
    ended.set_result(True)
    expect(page.locator(".zb-goal-state")).to_have_text("succeeded")
    expect(page.locator(".zb-message").nth(1)).to_contain_text("sequence")


def test_a_goal_without_a_server_fails(server: Server, page: Page, node: zbot.Node) -> None:
    action: ActionServer[Any, Any, Any]
    action = ActionServer(node, Fibonacci, "count", lambda _: Fibonacci.Result())
    page.goto(f"{server.address}/actions?action=/count")
    button = page.get_by_role("button", name="Send goal")
    expect(button).to_be_enabled()
    action.destroy()
    button.click()
    expect(page.locator(".zb-message").nth(1)).to_contain_text("/count: no server is running")
    expect(page.locator(".zb-goal-state")).to_have_text("failed")
    expect(button).to_be_enabled()
