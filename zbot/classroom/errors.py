"""What can go wrong between machines, each in a sentence that says what to do."""

from __future__ import annotations

from zbot.errors import SetupError


class ClassroomError(SetupError):
    """Root of what can go wrong between machines."""


class AddressError(ClassroomError, ValueError):
    """Something that should name a machine does not."""

    def __init__(self, text: str, reason: str) -> None:
        self.text, self.reason = text, reason
        super().__init__(f"{text!r} is no address: {reason}")


class CodeError(ClassroomError, ValueError):
    """A join code was mistyped."""

    def __init__(self, text: str, reason: str) -> None:
        self.text, self.reason = text, reason
        super().__init__(f"the code {text!r} has a typo: {reason}; compare it with the teacher's")


class DeadHostError(ClassroomError, ConnectionError):
    """Nobody answers at an address at all."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(
            f"nobody answers at {host}:{port}: are you in the same network, and is that machine on?"
        )


class BlockedPortError(ClassroomError, ConnectionError):
    """A machine is there, but its port cannot be reached."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(
            f"{host} is there but its port {port} is blocked: "
            f"allow TCP {port} in the firewall of that machine"
        )


class ClosedPortError(ClassroomError, ConnectionError):
    """A machine is there, and no program listens on its port."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(
            f"{host} is there, but no class and no hub is open on its port {port}: "
            "start it there with `zbot class start` or `zbot hub`"
        )


class NoHubError(ClassroomError, ConnectionError):
    """Something listens on a port, and it is no hub."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(
            f"what answers at {host}:{port} is no zbot hub, or one that lets nobody in without a "
            "certificate: ask the teacher"
        )


class HubPortError(ClassroomError, OSError):
    """A hub cannot listen where it should."""

    def __init__(self, endpoint: str, reason: str) -> None:
        self.endpoint, self.reason = endpoint, reason
        super().__init__(
            f"cannot listen on {endpoint}: {reason}; another hub or Zenoh router may run here "
            "(`zbot status`, `zbot leave`)"
        )


class HubStartError(ClassroomError, OSError):
    """The hub in the background ended before it was ready."""

    def __init__(self, log: str, last_line: str) -> None:
        self.log, self.last_line = log, last_line
        super().__init__(f"the hub did not start: {last_line or 'no reason given'} (see {log})")


class AlreadyJoinedError(ClassroomError):
    """This machine takes part in something already."""

    def __init__(self, what: str) -> None:
        self.what = what
        super().__init__(f"this machine {what}: leave first with `zbot leave`")


class NotJoinedError(ClassroomError):
    """This machine takes part in nothing."""

    def __init__(self) -> None:
        super().__init__("this machine has not joined anything: `zbot join CODE` does")


class NoClassError(ClassroomError):
    """No class is open on this machine."""

    def __init__(self) -> None:
        super().__init__("no class is open on this machine: `zbot class start` opens one")


class PinNeededError(ClassroomError, PermissionError):
    """A class asks for a PIN, and nobody can be asked for it."""

    def __init__(self) -> None:
        super().__init__(
            "the class asks for a PIN: run `zbot join` in a terminal, or set ZBOT_PIN for it"
        )


class RefusedError(ClassroomError, PermissionError):
    """The class does not let this machine in; the sentence is the class's own."""

    def __init__(self, kind: str, sentence: str) -> None:
        self.kind = kind
        super().__init__(sentence)


class SilentHubError(ClassroomError, TimeoutError):
    """A hub was reached and its class does not answer."""

    def __init__(self, host: str, port: int) -> None:
        self.host, self.port = host, port
        super().__init__(f"the class at {host}:{port} does not answer: try again in a moment")


class ClassCommandError(ClassroomError):
    """The class cannot do what its teacher asks; the sentence says why."""
