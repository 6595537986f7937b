"""The teacher's side: opening a class, and the hub that runs until it is over."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot import membership
from zbot.classroom import background
from zbot.classroom.address import Address, own_addresses
from zbot.classroom.errors import AlreadyJoinedError, NoClassError
from zbot.classroom.hub import HubSettings
from zbot.classroom.serving import serve
from zbot.membership import Membership
from zbot.session import LOOPBACK

if TYPE_CHECKING:
    from collections.abc import Callable

EVERYWHERE = "0.0.0.0"  # noqa: S104 - a class is there to be reached


def start(name: str, port: int) -> Membership:
    """Open a class: leave a hub running that students can join.

    A class whose hub has died, with its machine say, is opened again.

    Raises:
        AlreadyJoinedError: This machine takes part in something.
        HubStartError: The port is taken.
    """
    present = membership.load()
    has_died = present is not None and present.role == "teacher" and background.find() is None
    if (present is not None and not has_died) or background.find() is not None:
        what = present.class_name or present.host if present else "something"
        raise AlreadyJoinedError(f"has joined {what}")
    host = next(iter(own_addresses()), LOOPBACK)
    opened = Membership("teacher", host, port, class_name=name)
    membership.save(opened)
    try:
        background.start("teacher")
    except BaseException:
        membership.forget()
        raise
    return opened


def stop() -> Membership:
    """Close the class that is open on this machine.

    Raises:
        NoClassError: There is none.
    """
    present = membership.load()
    if present is None or present.role != "teacher":
        raise NoClassError
    background.stop()
    membership.forget()
    return present


def run_teacher(opened: Membership, on_ready: Callable[[], None]) -> None:
    """Be the hub of a class until a signal comes."""
    serve("teacher", HubSettings((Address(EVERYWHERE, opened.port).endpoint,)), on_ready)
