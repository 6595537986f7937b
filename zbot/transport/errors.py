"""Errors of settings and of Zenoh sessions that a program's user can cause."""

from __future__ import annotations

from zbot.errors import SetupError


class DomainIdError(SetupError, ValueError, RuntimeError):
    """A domain id is not an integer from 0 to the maximum."""

    def __init__(self, source: str, value: object, maximum: int) -> None:
        self.source, self.value, self.maximum = source, value, maximum
        super().__init__(
            f"{source} is {value!r}, but a domain is a whole number from 0 to {maximum}: "
            f"set such a number, for example {source}=7"
        )


class DiscoveryRangeError(SetupError, ValueError):
    """A variable for the discovery range has an unknown value."""

    def __init__(self, source: str, value: str) -> None:
        self.source, self.value = source, value
        super().__init__(f"{source} is {value!r}: use LOCALHOST, SUBNET or OFF")


class PortError(SetupError, ValueError):
    """A variable for a TCP port has a value that is not a port."""

    def __init__(self, source: str, value: str) -> None:
        self.source, self.value = source, value
        super().__init__(f"{source} is {value!r}, but a port is a number from 1 to 65535")


class ConfigError(SetupError, ValueError):
    """A Zenoh configuration file cannot be read, or is not valid."""

    def __init__(self, source: str, reason: str) -> None:
        self.source, self.reason = source, reason
        super().__init__(f"cannot use the Zenoh configuration {source}: {_first_part(reason)}")


class SessionError(SetupError, OSError):
    """Zenoh could not open a session."""

    def __init__(self, what: str, reason: str) -> None:
        self.what, self.reason = what, reason
        super().__init__(f"cannot open {what}: {_first_part(reason)}")


def _first_part(reason: str) -> str:
    """Return Zenoh's error text without the place in Zenoh's source code that follows it."""
    return " ".join(reason.split(" at /", maxsplit=1)[0].split())
