"""The laptop's side: joining, leaving, and the hub that runs in between."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot import membership
from zbot.classroom import background
from zbot.classroom.address import Address, own_addresses, parse_address
from zbot.classroom.errors import AlreadyJoinedError
from zbot.classroom.hub import HubSettings
from zbot.classroom.join_code import decode, looks_like_code
from zbot.classroom.probe import first_that_answers
from zbot.classroom.serving import serve
from zbot.membership import Membership
from zbot.session import hub_endpoint

if TYPE_CHECKING:
    from collections.abc import Callable


def find_hub(target: str) -> Address:
    """Return where the hub is that a code or an address names, having knocked there.

    Raises:
        CodeError: The code has a typo.
        AddressError: The address makes no sense.
        DeadHostError: Nobody is there; `BlockedPortError` and `ClosedPortError`: see there.
    """
    if looks_like_code(target):
        return first_that_answers(decode(target, own_addresses()))
    return first_that_answers([parse_address(target)])


def join(target: str) -> Membership:
    """Link this machine to the hub at a code or address, and leave a hub running that keeps to it.

    Raises:
        AlreadyJoinedError: It has joined something.
        ClassroomError: The hub cannot be found or used; see `find_hub`.
    """
    present = membership.load()
    if present is not None:
        raise AlreadyJoinedError(f"has joined {present.class_name or present.host}")
    if background.find() is not None:
        raise AlreadyJoinedError("runs a hub")
    address = find_hub(target)
    joined = Membership("partner", address.host, address.port)
    membership.save(joined)
    try:
        background.start("partner")
    except BaseException:
        membership.forget()
        raise
    return joined


def leave() -> Membership | None:
    """End this machine's hub and forget what it had joined; return what that was."""
    try:
        present = membership.load()
    except membership.MembershipError:
        present = None
    background.stop()
    membership.forget()
    return present


def run_student(joined: Membership, on_ready: Callable[[], None]) -> None:
    """Be the hub of a machine that has joined another, until a signal comes."""
    dialled = Address(joined.host, joined.port)
    serve(joined.role, HubSettings((hub_endpoint(),), (dialled.endpoint,)), on_ready)
