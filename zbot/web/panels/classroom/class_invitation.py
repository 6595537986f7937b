"""Invitation to a class, large enough for a projector, with a QR code."""

from __future__ import annotations

import base64
import io
from typing import TYPE_CHECKING

from nicegui import ui

if TYPE_CHECKING:
    from zbot.classroom.teacher.invitation import Invitation
    from zbot.web.page.panel import Page

_QUIET_ZONE = 4  # white border of a QR code, in squares of the code (ISO/IEC 18004)


class ClassInvitation:
    """Button in the toolbar, and the invitation that it shows.

    Only a browser on the teacher's machine shows the invitation, because it contains the PIN.

    Args:
        page: The page of the browser.
    """

    def __init__(self, page: Page) -> None:
        self._is_wanted = False
        self._shown: Invitation | None = None
        self._known: Invitation | None = None
        with page.toolbar:
            self._button = ui.button("Show the code", on_click=self._toggle)
            self._button.props("outline dense")
        self._card = ui.element("div").classes("zb-card zb-invitation")
        with self._card:
            self._picture = ui.element("img").props('alt="QR code of the command"')
            with ui.element("div").classes("zb-col"):
                self._command = ui.label().classes("zb-invitation-command")
                self._pin = ui.label().classes("zb-invitation-command")
                self._address = ui.label().classes("zb-muted")
        # The button is hidden until an invitation is known. Otherwise the button would appear,
        # disappear and appear again, and a fast click would be lost.
        self.show(None)

    def _toggle(self) -> None:
        self._is_wanted = not self._is_wanted
        self._button.set_text("Hide the code" if self._is_wanted else "Show the code")
        self.show(self._known)

    def show(self, invitation: Invitation | None) -> None:
        """Show an invitation if the user wants to see it. `None` means that no class is open."""
        self._known = invitation
        self._button.set_visibility(invitation is not None)
        self._card.set_visibility(self._is_wanted and invitation is not None)
        if invitation is None or invitation == self._shown:
            return
        self._shown = invitation
        self._command.set_text(invitation.command)
        self._pin.set_text(f"PIN {invitation.pin}" if invitation.pin else "")
        self._address.set_text(f"or: zbot join {invitation.address}")
        self._picture.props(f'src="{_qr_code(f"zbot join {invitation.address}")}"')


def _qr_code(text: str) -> str:
    """Return the address of a picture with a QR code."""
    import segno  # noqa: PLC0415 - only teachers need it

    svg = io.BytesIO()
    segno.make_qr(text).save(svg, kind="svg", border=_QUIET_ZONE, light="white", scale=8)
    return f"data:image/svg+xml;base64,{base64.b64encode(svg.getvalue()).decode()}"
