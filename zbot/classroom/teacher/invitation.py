"""Invitation to a class: what students type to join it."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.classroom.errors import no_class_error
from zbot.classroom.hub.address import Address, own_addresses
from zbot.classroom.join_code import long_code, short_code
from zbot.classroom.teacher.class_record import load_record
from zbot.transport import membership

if TYPE_CHECKING:
    from zbot.classroom.teacher.class_record import ClassRecord
    from zbot.transport.membership import Membership


@dataclass(frozen=True)
class Invitation:
    """What students need to join a class. Only the teacher's machine has an invitation."""

    class_name: str
    code: str | None  #: the shortest code, or `None` if no code can contain the port
    long_code: str | None
    host: str  #: the present address of the teacher's machine
    port: int
    pin: str | None = field(repr=False)
    former_host: str | None  #: address at the start of the class, if the address is different now

    @property
    def address(self) -> str:
        """The address with the port."""
        return str(Address(self.host, self.port))

    @property
    def command(self) -> str:
        """The command that students type."""
        return f"zbot join {self.code or self.address}"

    def document(self) -> dict[str, Any]:
        """Return the facts for `--json`."""
        facts = asdict(self)
        return {"class": facts.pop("class_name"), **facts}


def invitation_to(opened: Membership, record: ClassRecord) -> Invitation:
    """Return the invitation to a class of this machine."""
    present = own_addresses()
    has_moved = bool(present) and opened.host not in present
    address = Address(present[0] if has_moved else opened.host, opened.port)
    return Invitation(
        opened.class_name,
        short_code(address) or long_code(address),
        long_code(address),
        address.host,
        address.port,
        record.pin or None,
        opened.host if has_moved else None,
    )


def invitation() -> Invitation:
    """Return the invitation to the class that is open on this machine.

    Raises:
        ClassroomError: No class is open on this machine.
        ClassValueError: The file of the class is damaged.
    """
    opened = membership.load()
    if opened is None or opened.role != "teacher":
        raise no_class_error()
    return invitation_to(opened, load_record())
