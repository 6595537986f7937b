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


class ForkedSessionError(SetupError, OSError):
    """Zenoh cannot be loaded again in a forked process."""

    def __init__(self, reason: str) -> None:
        self.reason = reason
        super().__init__(
            "this process is a fork of a process with nodes, and cannot have nodes itself "
            f"({reason}): start it with multiprocessing.get_context('spawn')"
        )


class RmwError(SetupError, ValueError):
    """A program chose a middleware that zbot does not support."""

    def __init__(self, name: str, known: tuple[str, ...]) -> None:
        self.name, self.known = name, known
        super().__init__(f"zbot does not speak {name!r}: choose {' or '.join(known)}")


class RouterAttemptsError(SetupError, ValueError):
    """The variable for the number of attempts to find a router is not a whole number."""

    def __init__(self, source: str, value: str) -> None:
        self.source, self.value = source, value
        super().__init__(
            f"{source} is {value!r}, but it must be a whole number: 0 waits for a router for ever, "
            "and a negative number does not look for one"
        )


class NoRouterError(SetupError, OSError):
    """No Zenoh router answers. Programs of ROS 2 need a router to find each other."""

    def __init__(self, endpoints: list[str]) -> None:
        self.endpoints = endpoints
        super().__init__(no_router_text(endpoints))


class RouterPortError(SetupError, OSError):
    """A router cannot listen on its endpoint."""

    def __init__(self, endpoints: list[str], reason: str) -> None:
        self.endpoints, self.reason = endpoints, reason
        super().__init__(
            f"cannot listen on {' and '.join(endpoints)}: {_first_part(reason)}; if a router runs "
            "there already, it is enough: a machine needs one"
        )


def no_router_text(endpoints: list[str]) -> str:
    """Return the sentence about a missing router of ROS 2."""
    return (
        f"no Zenoh router answers on {' or '.join(endpoints)}, so ROS 2 nodes are not found: start "
        "one in another terminal with `zbot hub --rmw` or `ros2 run rmw_zenoh_cpp rmw_zenohd`"
    )


class FileLimitError(SetupError, OSError):
    """The process may open too few files for a Zenoh session."""

    def __init__(self, needed: int) -> None:
        self.needed = needed
        super().__init__(
            f"the limit of open files is too low: zbot needs {needed} more files; "
            "raise the limit, for example with `ulimit -n 1024`"
        )


def _first_part(reason: str) -> str:
    """Return Zenoh's error text. Leave out the place in Zenoh's source code after the text."""
    return " ".join(reason.split(" at /", maxsplit=1)[0].split())
