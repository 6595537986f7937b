"""Class that runs in the process of the teacher's hub. It answers laptops and the teacher."""

from __future__ import annotations

import contextlib
import threading
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.classroom.errors import RefusedError
from zbot.classroom.hub.address import EVERYWHERE, Address
from zbot.classroom.hub.link import Link, certificate_identity, own_identities
from zbot.classroom.hub.router import HubSettings
from zbot.classroom.keys import ADMISSION_KEY, COMMAND_KEY, NOTICES_KEY
from zbot.classroom.teacher.accepted_identities import AcceptedIdentities
from zbot.classroom.teacher.commands import ClassCommands
from zbot.classroom.teacher.join_service import JoinService
from zbot.classroom.teacher.laptops import Laptops
from zbot.classroom.teacher.robots import Robots
from zbot.classroom.teacher.student import user_of
from zbot.classroom.teacher.student_number import NUMBERS
from zbot.security.access import Share, teacher_access
from zbot.threads.foreign_call import called_by_zenoh
from zbot.transport import membership

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.classroom.hub.process import HubProcess
    from zbot.classroom.join_request import Document
    from zbot.classroom.teacher.class_record import ClassRecord

# A laptop ends its hub before it releases its number. If the hub of a former owner is still linked
# after this time, it does not end by itself.
_LEAVING_S = 2.0
_REOPENING_S = 0.5  # after this time, a laptop may ask a hub again that was opened again


class RunningClass:
    """An open class of students.

    Args:
        record: The class's data, which are stored in a file.
        port: TCP port of the hub.
    """

    def __init__(self, record: ClassRecord, port: int) -> None:
        self._record = record
        self._port = port
        self._students = record.students
        self._laptops = Laptops(record.students)
        self._robots = Robots()
        self._lock = threading.RLock()  # each of the three queryables has a thread
        self._serving: HubProcess | None = None
        self._accepted = AcceptedIdentities(record.students, has_pin=bool(record.pin))
        self._fingerprint = ""
        self._join_service = JoinService(
            record.name,
            record.pin,
            record.students,
            is_own_hub=self._is_own_hub,
            credentials=self._credentials,
            changed=self._on_change,
        )
        self._commands = ClassCommands(
            record, self._laptops, self._robots, self._lock, apply=self._apply
        )

    def settings(self) -> HubSettings:
        """Return the endpoints and access rules of a hub that is opened now. Write its users."""
        link = Link(self._record.keystore)
        listen = link.listening(Address(EVERYWHERE, self._port))
        with self._lock:
            self._accepted = AcceptedIdentities(self._students, has_pin=bool(self._record.pin))
            if self._record.pin:
                membership.save_users(self._accepted.users())
            settings = teacher_access(
                {user_of(number): number for number in NUMBERS},
                shared_is_open=self._record.is_open,
                shares=[Share(owner, user_of(reader)) for owner, reader in self._record.shares],
                drivers={user_of(number): name for name, number in self._robots.drivers.items()},
            )
            self._accepted.apply(settings["access_control"])
        return HubSettings(listen, extra=settings | link.settings)

    def attach(self, serving: HubProcess) -> None:
        """Begin to answer laptops and the teacher through a hub that was opened."""
        self._serving = serving
        self._fingerprint = Link(self._record.keystore).fingerprint()
        self._commands.attach(serving)
        serving.answer_queries(ADMISSION_KEY, self._answer_lobby)
        serving.answer_queries(COMMAND_KEY, self._commands.answer)
        serving.answer_queries(NOTICES_KEY, self._answer_student)
        self._laptops.attach(serving)
        events = called_by_zenoh(self._on_transport)
        serving.keep(serving.session.info.declare_transport_events_listener(events, history=True))

    def _on_transport(self, event: Any) -> None:
        """Reopen the hub if a former owner of a number has connected."""
        if event.kind == zenoh.SampleKind.PUT:
            self._reject_former({str(event.transport.zid)})

    def _reject_former(self, connected: set[str]) -> None:
        if self._serving is not None and connected & self._accepted.former_hub_ids():
            self._serving.reopen()

    def _reject_former_links(self) -> None:
        """Reopen the hub if a former owner of a number is still connected."""
        assert self._serving is not None
        with contextlib.suppress(zenoh.ZError):  # the hub is being reopened
            transports = self._serving.session.info.transports()
            self._reject_former({str(transport.zid) for transport in transports})

    def _answer_lobby(self, question: Document) -> Document:
        with self._lock:
            for number in self._students.free_never_linked():
                self._on_change(number)
            return self._join_service.answer(question)

    def _answer_student(self, question: Document) -> Document:
        """Return the notices. The owner of a number also gets the names of its nodes."""
        found: Document = {
            "notices": self._record.notices,
            "sensors": self._record.has_sensors,
        }
        student = self._students.owner(question, "nodes")
        if student is not None:
            self._students.note_linked(student.number)
            found["nodes"] = self._laptops.nodes.listed(student.number)[0]
            found["here"] = self._students.laptop(student.number).is_here
            found["namesakes"] = self._students.namesakes(student)
        return found

    def _is_own_hub(self, dialled: str) -> bool:
        """Return whether a laptop is connected to this hub itself.

        Return false if the laptop is connected to a program that forwards to this hub. In a class
        without a PIN, return true, because such a program can join by itself.
        """
        assert self._serving is not None
        if not self._record.pin:
            return True
        if self._fingerprint and dialled == certificate_identity(self._fingerprint):
            return True
        return dialled in own_identities(self._serving.session)

    def _on_change(self, number: int) -> None:
        """Save the list, and watch the laptop of a number if the number has an owner."""
        if self._students.student(number) is None:
            self._laptops.forget(number)
        else:
            self._laptops.watch(number)
            if self._accepted.former_hub_ids():
                self._later(self._reject_former_links)
        self._record.save()

    @staticmethod
    def _later(work: Callable[[], None]) -> None:
        timer = threading.Timer(_LEAVING_S, work)
        timer.daemon = True
        timer.start()

    def _credentials(self, number: int) -> dict[str, str]:
        """Return the credentials of a number's owner.

        Raises:
            RefusedError: The hub accepts them only after it was reopened. It is reopened now.
        """
        if not self._accepted.accepts(number):
            self._apply()
            text = "the class is being opened again: try again in a moment"
            raise RefusedError("wait", text, wait_s=_REOPENING_S)
        given = self._students.identity(number)
        # Without a PIN, the hub's id is enough, because a Zenoh program then needs no secret.
        return given._asdict() if self._record.pin else {"hub_id": given.hub_id}

    def _apply(self) -> None:
        """Save the data and reopen the hub, because Zenoh reads rules when a session opens."""
        assert self._serving is not None
        self._record.save()
        self._serving.reopen()
