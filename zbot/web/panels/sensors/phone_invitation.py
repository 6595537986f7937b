"""QR code that opens the panel on a phone, or a sentence that says how to get one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nicegui import ui

from zbot.observer.serving.address import is_loopback
from zbot.observer.serving.port import addresses_of
from zbot.web.page.qr_code import qr_code

if TYPE_CHECKING:
    from zbot.web.page.panel import Page

_NO_HTTPS = (
    "Sensors of a phone: start `zbot web --https sensors`. This page then shows a code for the "
    "camera of the phone, which must be in the same network."
)
_HINT = (
    "Sensors of a phone in the same network: point its camera at the code. The phone warns once, "
    "because the certificate is this machine's own: choose to go on."
)


def add_phone_invitation(page: Page) -> None:
    """Add the invitation to the current element.

    Only a browser on this machine shows it, because the code contains the token.
    """
    if not page.is_local:
        return
    addresses = _addresses(page)
    with ui.element("div").classes("zb-card zb-row zb-phone-invitation"):
        if not addresses:
            ui.label(_NO_HTTPS).classes("zb-muted")
            return
        picture = ui.element("img").props('alt="QR code of the address for a phone"')
        picture.props(f'src="{qr_code(addresses[0])}"')
        with ui.element("div").classes("zb-col zb-grow"):
            ui.label(_HINT).classes("zb-muted")
            for address in addresses:
                ui.label(address).classes("zb-mono zb-name")


def _addresses(page: Page) -> list[str]:
    """Return the addresses for other machines, if the page uses https."""
    server = page.server
    if server.scheme != "https" or is_loopback(server.host):
        return []
    all_of_them = addresses_of(
        server.host, server.port, "/sensors", server.token, scheme=server.scheme
    )
    return [address for address in all_of_them if "//127.0.0.1:" not in address]
