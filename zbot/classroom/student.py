"""Student's side of a class: functions to join and leave it, and to run the laptop's hub."""

from __future__ import annotations

import contextlib
import functools
import secrets
import socket
import time
from dataclasses import replace
from typing import TYPE_CHECKING

from zbot.classroom import background, teacher
from zbot.classroom.address import Address, own_addresses, parse_address
from zbot.classroom.admission import AdmissionRequest
from zbot.classroom.enrolment import release, request_admission
from zbot.classroom.errors import AlreadyJoinedError, RefusedError
from zbot.classroom.hub import HubSettings
from zbot.classroom.hub_process import serve
from zbot.classroom.join_code import decode, looks_like_code
from zbot.classroom.link import Link
from zbot.classroom.presence import Presence
from zbot.classroom.probe import first_reachable
from zbot.classroom.state import hub_facts
from zbot.security.secret import make_private_folder, write_private
from zbot.transport import membership
from zbot.transport.config import hub_port
from zbot.transport.session import hub_endpoint, open_hub_client

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from zbot.classroom.enrolment import AskPin
    from zbot.transport.membership import Membership

    AskName = Callable[[str, str], bool | None]

_MACHINE_BYTES = 8
_NOTICED_S = 5.0  # a hub notices within 4 s that a laptop is away
_PAUSE_S = 0.5


def find_hub(target: str) -> Address:
    """Connect to the hub that a code or an address means, and return the hub's address.

    Raises:
        CodeError: The code has a typing error.
        AddressError: The address is invalid.
        UnreachableHostError: No machine answers.
        BlockedPortError: A machine answers, but its port is blocked.
        ClosedPortError: A machine answers, but no program listens on its port.
    """
    if looks_like_code(target):
        return first_reachable(decode(target, own_addresses()))
    return first_reachable([parse_address(target)])


def join(
    target: str,
    *,
    name: str | None = None,
    number: int | None = None,
    is_new: bool = False,
    keystore: Path | None = None,
    ask_pin: AskPin = lambda _class_name: None,
    ask_name: AskName = lambda _given, _known: None,
) -> Membership:
    """Join the class or hub at a code or address, and start a hub in the background.

    Args:
        target: Code or address, as the teacher gives it.
        name: The student's name.
        number: The student's number. If it is `None`, the class chooses a number.
        is_new: Whether the student is not in the teacher's list. If this is false and the list has
            a similar name, `ask_name` is called.
        keystore: Folder of this machine's certificate. `None` means plain TCP.
        ask_pin: Takes the name of the class and returns its PIN, or `None` if it is unknown.
        ask_name: Takes the given name and a similar name in the teacher's list. Returns whether the
            similar name is meant, or `None` if nobody can be asked.

    Raises:
        AlreadyJoinedError: This machine has joined a class or hub, or runs a hub.
        ClassroomError: The hub cannot be found (see `find_hub`), or it refuses this machine
            (see `request_admission`).
        SecurityError: This machine and the hub do not accept each other's certificates.
    """
    _check_not_joined()
    link = Link.named(keystore)
    address = find_hub(target)
    certificate = link.check_dialling(address)
    request = AdmissionRequest(machine_id(), socket.gethostname(), name, number, is_new)
    pin = functools.cache(ask_pin)  # a student types the PIN once

    def send(request: AdmissionRequest) -> Membership:
        return request_admission(address, request, pin, link, certificate)

    with _without_membership():
        joined = _admitted(request, send, ask_name)
    joined = replace(joined, keystore=link.keystore, hub_port=hub_port())
    background.stop()
    membership.save(joined, [(joined.user, joined.secret)])
    try:
        background.start(joined.role)
    except BaseException:
        membership.forget()
        raise
    background.end_router()
    return joined


def _admitted(
    request: AdmissionRequest, send: Callable[[AdmissionRequest], Membership], ask_name: AskName
) -> Membership:
    """Send a request to the teacher's hub. After some refusals, send a changed request."""
    deadline, known = time.monotonic() + _NOTICED_S, request.machine
    while True:
        try:
            joined = send(request)
        except RefusedError as refusal:
            if refusal.kind == "similar" and not request.is_new:
                is_meant = ask_name(request.name or "", refusal.known)
                if is_meant is None:
                    raise
                name = refusal.known if is_meant else request.name
                request = replace(request, name=name, is_new=True)
            elif refusal.kind == "copied" and request.machine == known:
                # The hub sees a connected laptop with the same id. This may be this laptop itself,
                # if the hub has not noticed yet that it was away.
                if time.monotonic() > deadline:
                    request = replace(request, machine=secrets.token_hex(_MACHINE_BYTES))
                time.sleep(_PAUSE_S)
            else:
                raise
        else:
            if request.machine != known:
                _write_machine_id(request.machine)
            return joined


def _check_not_joined() -> None:
    """Raise `AlreadyJoinedError` if this machine has opened or joined a class or runs a hub.

    A joined class counts only while this machine's hub runs and is linked with the class.
    """
    present, hub = membership.load(), background.find()
    is_over = hub is None or not hub_facts(hub.pid).get("linked", False)
    if present is not None and (present.role == "teacher" or not is_over):
        raise AlreadyJoinedError(f"has joined {present.class_name or present.host}")
    if present is None and hub is not None:
        raise AlreadyJoinedError("runs a hub")


@contextlib.contextmanager
def _without_membership() -> Iterator[None]:
    """Remove the membership at the start of a `with` block. Restore it if the block raises."""
    present = membership.load()
    membership.forget()
    try:
        yield
    except BaseException:
        if present is not None:
            membership.save(present, [(present.user, present.secret)])
        raise


def machine_id() -> str:
    """Return the identifier of this user's machine. It is random and stored in a file."""
    try:
        return (membership.folder() / "machine").read_text(encoding="utf-8").strip()
    except FileNotFoundError:
        made = secrets.token_hex(_MACHINE_BYTES)
        _write_machine_id(made)
        return made


def _write_machine_id(machine: str) -> None:
    make_private_folder(membership.folder())
    write_private(membership.folder() / "machine", machine.encode())


def leave() -> Membership | None:
    """Release the number, end this machine's hub, and remove and return the membership.

    On the teacher's machine, this closes the class.
    """
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
    background.end_router()
    return present


def run_student(joined: Membership, on_ready: Callable[[], None]) -> None:
    """Run the hub of a machine that has joined a class or hub, until SIGTERM or SIGINT."""
    link, dialled = Link(joined.keystore), Address(joined.host, joined.port)
    extra = link.settings
    if joined.in_class:
        extra |= {"id": joined.hub_id}
    settings = HubSettings((hub_endpoint(),), (link.endpoint(dialled),), extra)
    presence = Presence(joined) if joined.in_class else None
    serve(joined.role, lambda: settings, on_ready, presence.attach if presence else None)
