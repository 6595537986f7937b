"""Errors of a teacher's classes and of hubs. Each message says what to do."""

from __future__ import annotations

from zbot.errors import SetupError
from zbot.errors.suggestion import did_you_mean


class ClassroomError(SetupError):
    """Root of the errors of classes and hubs."""


class AddressError(ClassroomError, ValueError):
    """A text is not the address of a machine."""

    def __init__(self, text: str, reason: str) -> None:
        self.text, self.reason = text, reason
        super().__init__(f"{text!r} is not an address: {reason}")


class CodeError(ClassroomError, ValueError):
    """A join code has a typing error."""

    def __init__(self, text: str, reason: str) -> None:
        self.text, self.reason = text, reason
        super().__init__(f"the code {text!r} has a typo: {reason}; compare it with the teacher's")


class UnreachableHostError(ClassroomError, ConnectionError):
    """No machine answers at an address."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(
            f"no machine answers at {host}:{port}: check that it is on and in the same network"
        )


class BlockedPortError(ClassroomError, ConnectionError):
    """A machine answers, but its port cannot be reached."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(
            f"{host} answers, but its port {port} is blocked: "
            f"allow TCP {port} in the firewall of that machine"
        )


class ClosedPortError(ClassroomError, ConnectionError):
    """A machine answers, but no program listens on its port."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(
            f"{host} answers, but no class and no hub is open on its port {port}: "
            "start one on that machine with `zbot class start` or `zbot hub`"
        )


class NoHubError(ClassroomError, ConnectionError):
    """The program that listens on a port is not a hub, or does not answer.

    Attributes:
        is_silent: Whether the program accepted the connection and did not answer.
    """

    def __init__(self, host: str, port: int, *, is_silent: bool = False) -> None:
        self.host, self.port, self.is_silent = host, port, is_silent
        super().__init__(
            f"the program at {host}:{port} does not answer: it is busy or suspended, or it is not "
            "a zbot hub: try again in a moment, or ask the teacher"
            if is_silent
            else f"the program at {host}:{port} is not a zbot hub, or is a hub that requires a "
            "certificate: ask the teacher"
        )


class HubPortError(ClassroomError, OSError):
    """A hub cannot listen on its endpoint."""

    def __init__(self, endpoint: str, reason: str) -> None:
        self.endpoint, self.reason = endpoint, reason
        super().__init__(
            f"cannot listen on {endpoint}: {reason}; if `zbot status` shows a hub, stop it with "
            "`zbot leave`; otherwise stop the program that listens there"
        )


class HubStartError(ClassroomError, OSError):
    """The hub in the background ended before it was ready."""

    def __init__(self, log: str, last_line: str) -> None:
        self.log, self.last_line = log, last_line
        super().__init__(f"the hub did not start: {last_line or 'it gave no reason'} (see {log})")


class AlreadyJoinedError(ClassroomError):
    """This machine has already joined a class or hub, or already runs a hub."""

    def __init__(self, what: str) -> None:
        self.what = what
        super().__init__(f"this machine {what}: leave first with `zbot leave`")


class NotJoinedError(ClassroomError):
    """This machine has not joined a class or hub."""

    def __init__(self) -> None:
        super().__init__("this machine has not joined anything: join with `zbot join CODE`")


class RobotError(ClassroomError, LookupError):
    """The class has no such robot."""

    def __init__(self, robot: str, connected: list[str]) -> None:
        self.robot, self.connected = robot, connected
        advice = did_you_mean(robot, connected)
        if not connected:
            advice = "connect one with `zbot class start --robot dds`"
        advice = advice or f"the robots are {', '.join(connected)}"
        super().__init__(f"no robot {robot!r} is connected; {advice}")


class NoClassError(ClassroomError):
    """No class is open on this machine."""

    def __init__(self) -> None:
        super().__init__("no class is open on this machine: open one with `zbot class start`")


class OtherClassError(ClassroomError):
    """Another class is open on this machine, or was open when the machine was switched off."""

    def __init__(self, class_name: str) -> None:
        self.class_name = class_name
        super().__init__(
            f'this machine has the class "{class_name}": `zbot class start` shows or continues it, '
            "and `zbot class stop` closes it"
        )


class OpenClassError(ClassroomError):
    """The class on this machine has other options than the teacher wants."""

    def __init__(self, class_name: str, reason: str) -> None:
        self.class_name, self.reason = class_name, reason
        super().__init__(
            f'the class "{class_name}" {reason}: `zbot class start` without options shows or '
            "continues it; to change it, close it with `zbot class stop`, and start it again"
        )


class ConfirmationError(ClassroomError):
    """A command would close a class, but cannot ask the teacher to confirm this."""

    def __init__(self, class_name: str) -> None:
        self.class_name = class_name
        super().__init__(
            f'leaving closes the class "{class_name}" for all students: type `zbot class stop`, '
            "or `zbot leave --yes`"
        )


class PinNeededError(ClassroomError, PermissionError):
    """A class requires a PIN, and no PIN was given."""

    def __init__(self) -> None:
        super().__init__("the class requires a PIN: run `zbot join` in a terminal, or set ZBOT_PIN")


class RefusedError(ClassroomError, PermissionError):
    """The class refuses this machine. The message comes from the class.

    Attributes:
        kind: Kind of the reason, e.g. `taken`.
        known: A similar name in the teacher's list of students, or an empty text.
        wait_s: Seconds after which the machine may ask again, or `None`.
    """

    def __init__(
        self, kind: str, sentence: str, known: str = "", wait_s: float | None = None
    ) -> None:
        self.kind, self.known, self.wait_s = kind, known, wait_s
        super().__init__(sentence)


class ReopeningError(ClassroomError):
    """The hub of the class is opened again before it accepts this laptop.

    Attributes:
        wait_s: Seconds after which the laptop may ask again.
    """

    def __init__(self) -> None:
        self.wait_s = 0.5
        super().__init__("the class is being opened again: try again in a moment")


class SilentHubError(ClassroomError, TimeoutError):
    """A hub was reached, but its class does not answer."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(f"the class at {host}:{port} does not answer: try again in a moment")


class UnlinkedError(ClassroomError, TimeoutError):
    """A class or hub admitted this machine, but the two hubs were not linked in time."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(
            f"this machine was not linked with {host}:{port} in time, so it has not joined: join "
            "again"
        )


class ClassCommandError(ClassroomError):
    """The class cannot carry out a command of its teacher. The message says why."""
