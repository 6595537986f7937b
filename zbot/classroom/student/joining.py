"""Joining and leaving a class or another machine's hub."""

from __future__ import annotations

import contextlib
import functools
import secrets
import socket
import time
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from zbot.classroom.errors import (
    ClassroomError,
    RefusedError,
    already_joined_error,
    not_joined_error,
    other_class_error,
    own_class_error,
)
from zbot.classroom.hub import running_hub
from zbot.classroom.hub.address import Address, own_addresses, parse_address
from zbot.classroom.hub.link import Link
from zbot.classroom.hub.probe import first_reachable
from zbot.classroom.hub.queries import hub_facts
from zbot.classroom.join_code import decode, looks_like_code
from zbot.classroom.join_request import JoinRequest
from zbot.classroom.student.link_problem import is_accepted
from zbot.classroom.student.lobby import release, request_membership
from zbot.security.secret import make_private_folder, write_private
from zbot.threads.deadline import Deadline, poll
from zbot.transport import membership
from zbot.transport.config import hub_port

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from zbot.classroom.student.lobby import AskPin
    from zbot.transport.membership import Membership

    AskName = Callable[[str, str], bool | None]

_LINKED_S = 20.0  # a hub usually links within 0.3 s, but thirty hubs may start together
_RESUMED_S = 3.0
_LINK_PAUSE_S = 0.05
_NOTICED_S = 5.0  # a hub notices within 4 s that a laptop is away
_PAUSE_S = 0.5
_MACHINE_BYTES = 8


class Joined(NamedTuple):
    """What `join` has joined."""

    membership: Membership
    namesakes: list[int]  #: numbers of other students who have the same name


class Left(NamedTuple):
    """What `leave` has left."""

    membership: Membership
    is_released: bool  #: whether the class knows that this machine has left


def find_hub(target: str) -> Address:
    """Connect to the hub that a code or an address means, and return the hub's address.

    Raises:
        ClassValueError: The code has a typing error, or the address is invalid.
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
) -> Joined:
    """Join the class or hub at a code or address, and start a hub in the background.

    The machine has joined when its hub is linked and the class has accepted it. If this fails, the
    machine has joined nothing, and the class frees the number.

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

    Returns:
        The membership, and the students who have the same name.

    Raises:
        ClassroomError: This machine has joined a class or hub, or runs a hub, or the hub cannot be
            found (see `find_hub`), or it refuses this machine (see `request_membership`), or the
            hub admits this machine, but is not linked with it within 20 s.
        SecurityError: This machine and the hub do not accept each other's certificates.
    """
    _check_not_joined()
    link = Link.named(keystore)
    address = find_hub(target)
    certificate = link.check_dialling(address)
    request = JoinRequest(machine_id(), socket.gethostname(), name, number, is_new)
    pin = functools.cache(ask_pin)  # a student types the PIN once

    def send(request: JoinRequest) -> Membership:
        return request_membership(address, request, pin, link, certificate)

    with _without_membership():
        admitted = _admitted(request, send, ask_name)
    admitted = replace(admitted, keystore=link.keystore, hub_port=hub_port())
    try:
        running_hub.stop()
        membership.save(admitted, [(admitted.user, admitted.secret)])
        running_hub.start(admitted.role)
        namesakes = _linked_namesakes(admitted)
    except BaseException:
        leave()
        raise
    running_hub.end_router()
    return Joined(admitted, namesakes)


def _linked_namesakes(joined: Membership) -> list[int]:
    """Wait until a class or hub has accepted this machine. Return the numbers of namesakes.

    Raises:
        ClassroomError: This machine's hub was not linked in time.
    """
    deadline = Deadline(_LINKED_S)
    while True:
        hub = running_hub.find()
        facts = hub_facts(hub.pid) if hub is not None else {}
        if is_accepted(joined, facts):
            return list((facts.get("of_class") or {}).get("namesakes") or [])
        if hub is None or deadline.is_over:
            raise ClassroomError(
                f"this machine was not linked with {joined.host}:{joined.port} in time, "
                "so it has not joined: join again"
            )
        time.sleep(_LINK_PAUSE_S)


def resume() -> None:
    """Start this machine's hub again, e.g. after the machine was switched off.

    Return as soon as the hub is linked with the class or hub that this machine has joined, or after
    3 s. The hub goes on trying. Do nothing if the hub runs.

    Raises:
        ClassroomError: This machine has not joined a class or hub, or this machine has a class of
            its own, or the hub cannot be started.
    """
    joined = membership.load()
    if joined is None:
        raise not_joined_error()
    if joined.role == "teacher":
        raise other_class_error(joined.class_name)
    if running_hub.find() is None:
        running_hub.start(joined.role)

    def has_ended_or_is_linked() -> bool:
        hub = running_hub.find()
        return hub is None or is_accepted(joined, hub_facts(hub.pid))

    poll(has_ended_or_is_linked, _RESUMED_S, _LINK_PAUSE_S)


def _admitted(
    request: JoinRequest, send: Callable[[JoinRequest], Membership], ask_name: AskName
) -> Membership:
    """Send a request to the teacher's hub. After some refusals, send a changed request."""
    deadline, known = Deadline(_NOTICED_S), request.machine
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
                if deadline.is_over:
                    request = replace(request, machine=new_machine_id())
                time.sleep(_PAUSE_S)
            else:
                raise
        else:
            if request.machine != known:
                save_machine_id(request.machine)
            return joined


def _check_not_joined() -> None:
    """Raise `ClassroomError` if this machine has opened or joined a class or runs a hub.

    A joined class counts only while this machine's hub runs and is linked with the class.
    """
    present, hub = membership.load(), running_hub.find()
    is_over = hub is None or not hub_facts(hub.pid).get("linked", False)
    if present is not None and present.role == "teacher":
        raise own_class_error(present.class_name)
    if present is not None and not is_over:
        raise already_joined_error(f"has joined {present.class_name or present.host}")
    if present is None and hub is not None:
        raise already_joined_error("runs a hub")


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


def leave() -> Left | None:
    """End this machine's hub, remove the membership, and release the number.

    The teacher's machine closes its class instead, see `teacher.opening.stop`.

    Returns:
        The former membership, or `None` if there was none.
    """
    try:
        present = membership.load()
    except membership.MembershipError:
        present = None
    running_hub.stop()
    membership.forget()
    running_hub.end_router()
    if present is None:
        return None
    is_released = present.role != "student" or release(present)
    return Left(present, is_released=is_released)


def new_machine_id() -> str:
    """Return a random identifier."""
    return secrets.token_hex(_MACHINE_BYTES)


def machine_id() -> str:
    """Return the identifier of this user's machine. It is random and stored in a file."""
    try:
        return (membership.folder() / "machine").read_text(encoding="utf-8").strip()
    except FileNotFoundError:
        made = new_machine_id()
        save_machine_id(made)
        return made


def save_machine_id(machine: str) -> None:
    """Let this machine have an identifier from now on."""
    make_private_folder(membership.folder())
    write_private(membership.folder() / "machine", machine.encode())
