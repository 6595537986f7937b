"""Errors of settings and of Zenoh sessions."""

from __future__ import annotations

from zbot.errors import SetupError


class DomainIdError(SetupError, ValueError, RuntimeError):
    """A domain id is no integer in range."""

    def __init__(self, source: str, value: object, maximum: int) -> None:
        self.source, self.value, self.maximum = source, value, maximum
        super().__init__(
            f"{source} is {value!r}, but a domain is a whole number from 0 to {maximum}: "
            f"set it to one, for example {source}=7"
        )


class DiscoveryRangeError(SetupError, ValueError):
    """A discovery range variable holds an unknown word."""

    def __init__(self, source: str, value: str) -> None:
        self.source, self.value = source, value
        super().__init__(f"{source} is {value!r}: use LOCALHOST, SUBNET or OFF")


class PortError(SetupError, ValueError):
    """A variable that should hold a TCP port holds something else."""

    def __init__(self, source: str, value: str) -> None:
        self.source, self.value = source, value
        super().__init__(f"{source} is {value!r}, but a port is a number from 1 to 65535")


class ConfigError(SetupError, ValueError):
    """A Zenoh configuration file cannot be read or understood."""

    def __init__(self, source: str, reason: str) -> None:
        self.source, self.reason = source, reason
        # Zenoh adds the place in its own source code, which helps nobody here.
        told = " ".join(reason.split(" at /", maxsplit=1)[0].split())
        super().__init__(f"cannot use the Zenoh configuration {source}: {told}")


class SessionError(SetupError, OSError):
    """Zenoh could not open a session."""

    def __init__(self, what: str, reason: str) -> None:
        self.what, self.reason = what, reason
        super().__init__(
            f"cannot open {what}: {' '.join(reason.split(' at /', maxsplit=1)[0].split())}"
        )
