"""Errors of settings and of Zenoh sessions that a program's user can cause."""

from __future__ import annotations

from zbot.errors import SetupError


class SettingError(SetupError, ValueError, RuntimeError):
    """A setting of the transport is not allowed, or its configuration file cannot be used."""


class TransportError(SetupError, OSError):
    """The operating system does not let this process open a Zenoh session."""


def discovery_range_error(source: str, value: str) -> SettingError:
    """Return the error that a variable for the discovery range has an unknown value."""
    return SettingError(f"{source} is {value!r}: use LOCALHOST, SUBNET or OFF")


def port_error(source: str, value: str) -> SettingError:
    """Return the error that a variable for a TCP port has a value that is not a port."""
    return SettingError(f"{source} is {value!r}, but a port is a number from 1 to 65535")


def config_error(source: str, reason: str) -> SettingError:
    """Return the error that a Zenoh configuration cannot be read, or is not valid."""
    return SettingError(f"cannot use the Zenoh configuration {source}: {_first_part(reason)}")


class SessionError(SetupError, OSError):
    """Zenoh could not open a session."""

    def __init__(self, what: str, reason: str) -> None:
        self.what, self.reason = what, reason
        super().__init__(f"cannot open {what}: {_first_part(reason)}")


class NoRouterError(SetupError, OSError):
    """No Zenoh router answers. Programs of ROS 2 need a router to find each other."""

    def __init__(self, endpoints: list[str]) -> None:
        self.endpoints = endpoints
        super().__init__(no_router_text(endpoints))


def router_port_error(endpoints: list[str], reason: str) -> TransportError:
    """Return the error that a router cannot listen on its endpoint."""
    why = ", because another program uses the port" if is_in_use(reason) else f": {reason}"
    return TransportError(
        f"cannot listen on {' and '.join(endpoints)}{_first_part(why)}; if a router runs "
        "there already, it is enough: a machine needs one"
    )


def is_in_use(reason: str) -> bool:
    """Return whether Zenoh's error says that another program uses the address."""
    return "address already in use" in reason.lower() or "os error 10048" in reason  # on Windows


def no_router_text(endpoints: list[str]) -> str:
    """Return the sentence about a missing router of ROS 2."""
    return (
        f"no Zenoh router answers on {' or '.join(endpoints)}, so ROS 2 nodes are not found: start "
        "one in another terminal with `zbot hub --rmw` or `ros2 run rmw_zenoh_cpp rmw_zenohd`"
    )


def _first_part(reason: str) -> str:
    """Return Zenoh's error text. Leave out the place in Zenoh's source code after the text."""
    return " ".join(reason.split(" at /", maxsplit=1)[0].split())
