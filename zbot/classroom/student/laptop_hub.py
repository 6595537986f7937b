"""Hub of a laptop that has joined a class, or of a machine that has joined another hub."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.classroom.hub.address import Address
from zbot.classroom.hub.link import Link
from zbot.classroom.hub.process import serve
from zbot.classroom.hub.router import HubSettings
from zbot.classroom.student.laptop_report import LaptopReport
from zbot.classroom.student.link_check import LinkCheck
from zbot.classroom.student.lobby import is_member
from zbot.transport.config import domain_id
from zbot.transport.session import hub_endpoint

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.classroom.hub.process import HubProcess
    from zbot.transport.membership import Membership


def run_student(joined: Membership, on_ready: Callable[[], None]) -> None:
    """Run the hub of a machine that has joined a class or hub, until SIGTERM or SIGINT."""
    link, dialled = Link(joined.keystore), Address(joined.host, joined.port)
    extra = link.settings
    if joined.in_class:
        extra |= {"id": joined.hub_id}
    settings = HubSettings((hub_endpoint(),), (link.endpoint(dialled),), extra)
    report = LaptopReport(joined) if joined.in_class else None
    of_class = report.of_class if report is not None else None
    links = LinkCheck(domain_id(), of_class, lambda: is_member(joined))

    def attach(serving: HubProcess) -> None:
        if report is not None:
            report.attach(serving)
        links.attach(serving)

    serve(joined.role, lambda: settings, on_ready, attach)
