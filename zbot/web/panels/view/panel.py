"""Panel of the 3D view, which shows the view's own page in a frame."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nicegui import background_tasks, ui

from zbot.errors import ZbotError
from zbot.observer.serving.address import address
from zbot.web.page.command_line import command_line
from zbot.web.page.panel import Page, Panel
from zbot.web.page.service_call import run_in_thread
from zbot.web.panels.view.shared_view import shared_view
from zbot.web.panels.view.student import student_domain

if TYPE_CHECKING:
    from zbot.web.panels.view.shared_view import SharedView

_HZ = 1.0
_NO_HTTPS = "The 3D view works only on a page without https: zbot web view"
#: What the page in the frame may do. It has another origin, so it cannot reach this page.
_SANDBOX = "allow-scripts allow-same-origin allow-downloads allow-pointer-lock"


class _View:
    def __init__(self, page: Page) -> None:
        self.page = page
        self.student = page.query.get("student", "")
        self.view: SharedView | None = None
        self.is_shown = False
        self.is_starting = False
        with ui.element("div").classes("zb-fill zb-view"):
            self.said = ui.label().classes("zb-empty").props("role=status")
            with ui.element("div").classes("zb-row zb-view-again") as self.again:
                ui.button("Start the view", on_click=self.start).props("unelevated dense")
            self.frame = ui.element("iframe").props(f'title="3D view" sandbox="{_SANDBOX}"')
        domain = ["--domain", self.student] if self.student else []
        page.show_command(command_line(*domain, "view"))
        page.live(self.look, _HZ)
        self.start()

    def start(self) -> None:
        """Start the view in the background, and show it then."""
        if self.page.server.scheme == "https":
            self.say(_NO_HTTPS)  # the view has no https, and browsers do not mix both
            return
        if self.is_starting:
            return  # a second click: the page would hold the view twice and release it once
        self.is_starting = True
        self.say("The 3D view starts.")
        background_tasks.create(self.show(), name="zbot view")

    async def show(self) -> None:
        """Show the view, or say why that is not possible."""
        try:
            view = self.view or await self.open()
            port, token = await run_in_thread(view.address)
        except ZbotError as error:
            self.say(str(error), may_start=True)
            return
        finally:
            self.is_starting = False
        self.is_shown = True
        self.said.set_visibility(False)
        self.frame.set_visibility(True)
        shown = address(self.page.host_name, port, "/", token)
        self.page.call("zbot.showView", self.frame.id, shown)

    async def open(self) -> SharedView:
        """Open the view of the page's domain, or that of a student.

        Raises:
            ZbotError: The class has no such student, or there is no class.
        """
        domain = self.page.system.domain_id
        if self.student:
            domain = await run_in_thread(student_domain, self.student)
        self.view = shared_view(self.page.system, self.page.server, domain)
        self.view.open()
        return self.page.keep(self.view)

    def look(self) -> None:
        """Say that the view has ended."""
        if self.is_shown and self.view is not None and self.view.has_ended:
            self.say("The 3D view has ended.", may_start=True)

    def say(self, text: str, *, may_start: bool = False) -> None:
        """Show a sentence in place of the view."""
        self.is_shown = False
        self.said.set_text(text)
        self.said.set_visibility(True)
        self.again.set_visibility(may_start)
        self.frame.set_visibility(False)


def _build(page: Page) -> None:
    _View(page)


PANEL = Panel("/view", "View", "view_in_ar", _build)
