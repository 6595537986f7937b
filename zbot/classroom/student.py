"""The laptop's side: joining, leaving, and the hub that runs in between."""

from __future__ import annotations

import contextlib
import secrets
import socket
from dataclasses import replace
from typing import TYPE_CHECKING

from zbot.classroom import background, teacher
from zbot.classroom.address import Address, own_addresses, parse_address
from zbot.classroom.admission import AdmissionRequest
from zbot.classroom.enrolment import knock, release
from zbot.classroom.errors import AlreadyJoinedError
from zbot.classroom.hub import HubSettings
from zbot.classroom.hub_process import serve
from zbot.classroom.join_code import decode, looks_like_code
from zbot.classroom.link import Link
from zbot.classroom.presence import Presence
from zbot.classroom.probe import first_that_answers
from zbot.classroom.state import hub_facts
from zbot.security.secret import make_private_folder, write_private
from zbot.transport import membership
from zbot.transport.session import hub_endpoint, open_hub_client

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from zbot.transport.membership import Membership

_MACHINE_BYTES = 8


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


def join(
    target: str,
    *,
    name: str | None = None,
    number: int | None = None,
    keystore: Path | None = None,
    ask_pin: Callable[[str], str | None] = lambda _class_name: None,
) -> Membership:
    """Join what is behind a code or address, and leave a hub running that keeps to it.

    Args:
        target: As the teacher shows it.
        name: The student's.
        number: The student's; the class chooses one if it is left out.
        keystore: Folder of this machine's certificate, if the hub there uses them.
        ask_pin: Returns the PIN of the class that it is given the name of.

    Raises:
        AlreadyJoinedError: This machine has joined something.
        ClassroomError: The hub cannot be found (`find_hub`) or lets nobody in (`knock`).
        SecurityError: This machine and the hub do not accept each other's certificates.
    """
    _require_alone()
    link = Link.named(keystore)
    address = find_hub(target)
    link.check_dialling(address)
    wish = AdmissionRequest(machine_id(), socket.gethostname(), name, number)
    with _without_membership():
        joined = replace(knock(address, wish, ask_pin, link), keystore=link.keystore)
    background.stop()
    membership.save(joined, [(joined.user, joined.secret)])
    try:
        background.start(joined.role)
    except BaseException:
        membership.forget()
        raise
    return joined


def _require_alone() -> None:
    """Refuse a machine that takes part in something.

    Last week's class, which is not there any more, is nothing; neither is one without a hub, as
    this machine was switched off in between.
    """
    present, hub = membership.load(), background.find()
    is_over = hub is None or not hub_facts(hub.pid).get("linked", False)
    if present is not None and (present.role == "teacher" or not is_over):
        raise AlreadyJoinedError(f"has joined {present.class_name or present.host}")
    if present is None and hub is not None:
        raise AlreadyJoinedError("runs a hub")


@contextlib.contextmanager
def _without_membership() -> Iterator[None]:
    """Speak as somebody who has joined nothing; what was joined comes back after a failure."""
    present = membership.load()
    membership.forget()
    try:
        yield
    except BaseException:
        if present is not None:
            membership.save(present, [(present.user, present.secret)])
        raise


def machine_id() -> str:
    """Return what tells this user's machine from others; random, and the same from then on."""
    path = membership.folder() / "machine"
    try:
        return path.read_text(encoding="utf-8").strip()
    except FileNotFoundError:
        made = secrets.token_hex(_MACHINE_BYTES)
        make_private_folder(membership.folder())
        write_private(path, made.encode())
        return made


def leave() -> Membership | None:
    """Give the number back, end this machine's hub and forget the class; return what that was."""
    try:
        present = membership.load()
    except membership.MembershipError:
        present = None
    if present is not None and present.role == "teacher":
        return teacher.stop()
    if present is not None and present.role == "student":
        session = open_hub_client()
        if session is not None:
            with session:
                release(session, present)
    background.stop()
    membership.forget()
    return present


def run_student(joined: Membership, on_ready: Callable[[], None]) -> None:
    """Be the hub of a machine that has joined another, until a signal comes."""
    link, dialled = Link(joined.keystore), Address(joined.host, joined.port)
    extra = link.settings
    if joined.in_class:
        extra |= {"id": joined.hub_id}
    settings = HubSettings((hub_endpoint(),), (link.endpoint(dialled),), extra)
    presence = Presence(joined) if joined.in_class else None
    serve(joined.role, lambda: settings, on_ready, presence.equip if presence else None)
