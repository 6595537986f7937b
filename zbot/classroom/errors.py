"""Errors of a teacher's classes and of hubs. Each message says what to do."""

from __future__ import annotations

from zbot.errors import SetupError
from zbot.errors.suggestion import did_you_mean
from zbot.transport.config import port_of
from zbot.transport.errors import is_in_use


class ClassroomError(SetupError):
    """Root of the errors of classes and hubs."""


class ClassValueError(ClassroomError, ValueError):
    """A text or a file for a class is not valid: an address, a code, a list of students."""


def address_error(text: str, reason: str) -> ClassValueError:
    """Return the error that a text is not the address of a machine."""
    return ClassValueError(f"{text!r} is not an address: {reason}")


def code_error(text: str, reason: str) -> ClassValueError:
    """Return the error that a join code has a typing error."""
    return ClassValueError(f"the code {text!r} has a typo: {reason}; compare it with the teacher's")


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


def hub_port_error(endpoint: str, reason: str) -> ClassroomError:
    """Return the error that a hub cannot listen on its endpoint."""
    if not is_in_use(reason):
        return ClassroomError(f"cannot listen on {endpoint}: {reason}")
    port = min(int(port_of(endpoint)) + 1, 65535)
    return ClassroomError(
        f"cannot listen on {endpoint}, because another program of this machine uses the port, "
        "perhaps the hub of another user: stop that program, or choose another port, e.g. "
        f"`zbot class start --port {port}` or `zbot hub --listen 0.0.0.0:{port}`"
    )


def hub_start_error(log: str, last_line: str) -> ClassroomError:
    """Return the error that the hub in the background ended before it was ready."""
    return ClassroomError(f"the hub did not start: {last_line or 'it gave no reason'} (see {log})")


def already_joined_error(what: str) -> ClassroomError:
    """Return the error that this machine has joined a class or hub, or runs a hub."""
    return ClassroomError(f"this machine {what}: leave first with `zbot leave`")


def own_class_error(name: str) -> ClassroomError:
    """Return the error that a teacher's machine joins a class, while its own class is open."""
    return ClassroomError(
        f"this machine has opened the class {name}, which students join from their own machines: "
        "end it with `zbot class stop` to join another class"
    )


def not_joined_error() -> ClassroomError:
    """Return the error that this machine has not joined a class or hub."""
    return ClassroomError("this machine has not joined anything: join with `zbot join CODE`")


def robot_error(robot: str, connected: list[str]) -> ClassroomError:
    """Return the error that the class has no such robot."""
    advice = did_you_mean(robot, connected)
    if not connected:
        advice = "connect one with `zbot class start --robot dds`"
    advice = advice or f"the robots are {', '.join(connected)}"
    return ClassroomError(f"no robot {robot!r} is connected; {advice}")


def no_class_error() -> ClassroomError:
    """Return the error that no class is open on this machine."""
    return ClassroomError("no class is open on this machine: open one with `zbot class start`")


def other_class_error(class_name: str) -> ClassroomError:
    """Return the error that this machine has another class, which is open or was not ended."""
    return ClassroomError(
        f'this machine has the class "{class_name}": `zbot class start` shows or continues it, '
        "and `zbot class stop` closes it"
    )


def open_class_error(class_name: str, reason: str) -> ClassroomError:
    """Return the error that the class on this machine has other options than the teacher wants."""
    return ClassroomError(
        f'the class "{class_name}" {reason}: `zbot class start` without options shows or '
        "continues it; to change it, close it with `zbot class stop`, and start it again"
    )


class RefusedError(ClassroomError, PermissionError):
    """The class refuses a machine. The teacher's machine sends the error, and the laptop raises it.

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


class SilentHubError(ClassroomError, TimeoutError):
    """A hub was reached, but its class does not answer."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(f"the class at {host}:{port} does not answer: try again in a moment")


class ClassCommandError(ClassroomError):
    """The class cannot carry out a command of its teacher. The message says why."""
