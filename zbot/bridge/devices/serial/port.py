"""Serial ports of this machine: which there are, and what is wrong with one that does not open."""

from __future__ import annotations

import contextlib
import errno
import importlib
import os
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from zbot.bridge.devices.errors import DeviceError, DeviceSetupError
from zbot.errors import MissingPackageError

if TYPE_CHECKING:
    from collections.abc import Sequence

#: A read that gets no byte ends after this time, so that the loop sees the end of the program.
READ_TIMEOUT_S = 0.2
_WRITE_TIMEOUT_S = 1.0
_HELD = frozenset({errno.EBUSY, errno.EWOULDBLOCK, errno.EAGAIN})
_GONE = frozenset({errno.ENOENT, errno.ENODEV, errno.ENXIO, errno.EIO, errno.ENOTDIR})


@dataclass(frozen=True)
class PortInfo:
    """A serial port of this machine."""

    device: str  #: what to open: `/dev/ttyACM0`, `COM3`
    description: str  #: as the system describes it: `Arduino Uno`
    is_usb: bool
    identity: str = ""  #: the same for a board that comes back under another name


class PortHeldError(DeviceError):
    """Another program uses a port."""

    def __init__(self, device: str) -> None:
        super().__init__(
            f"another program uses {device}: close it, e.g. the Serial Monitor of the Arduino IDE, "
            "Thonny, or another `zbot serial`"
        )


class NoPortError(DeviceError):
    """There is no such port, or no board at all."""


def serial_library() -> Any:
    """Return pyserial's module `serial`.

    Raises:
        MissingPackageError: pyserial is not installed.
    """
    try:
        return importlib.import_module("serial")
    except ImportError:
        raise MissingPackageError("zbot serial", "pyserial", "serial") from None


def all_ports() -> list[PortInfo]:
    """Return the serial ports of this machine. Those on USB come first."""
    serial_library()
    found = [
        PortInfo(
            port.device,
            " ".join(filter(None, (port.manufacturer, port.product))) or port.description,
            port.vid is not None,
            f"{port.vid}:{port.pid}:{port.serial_number}" if port.vid is not None else "",
        )
        for port in importlib.import_module("serial.tools.list_ports").comports()
    ]
    return sorted(found, key=lambda port: (not port.is_usb, port.device))


def only_board(ports: Sequence[PortInfo]) -> PortInfo:
    """Return the only board on USB.

    Raises:
        NoPortError: There is none.
        DeviceError: There are several.
    """
    boards = [port for port in ports if port.is_usb]
    if len(boards) == 1:
        return boards[0]
    if boards:
        names = ", ".join(f"{board.device} ({board.description})" for board in boards)
        raise DeviceError(
            f"there are {len(boards)} boards: {names}",
            hint=f"name one: zbot serial {boards[0].device}; another terminal can have another one",
        )
    others = f"; other ports are {', '.join(port.device for port in ports)}" if ports else ""
    raise NoPortError(
        f"no board is on USB{others}",
        hint="plug it in with a cable that carries data: some cables only charge",
    )


def read_port(name: str) -> tuple[PortInfo, bool]:
    """Return the port with a name, and whether it was found because the name is empty.

    Raises:
        DeviceError: No name is given, and there is not exactly one board.
    """
    found = all_ports()
    if not name:
        return only_board(found), True
    known = {info.device: info for info in found}
    return known.get(name, PortInfo(name, "", is_usb=False)), False


def open_port(device: str, baud: int) -> Any:
    """Open a port for this program alone, and return pyserial's object.

    Raises:
        NoPortError: There is no such port.
        PortHeldError: Another program uses it.
        DeviceSetupError: This user may not open it.
        DeviceError: The system refuses the port or the baud rate.
    """
    serial = serial_library()
    try:
        return serial.Serial(
            device, baud, timeout=READ_TIMEOUT_S, write_timeout=_WRITE_TIMEOUT_S, exclusive=True
        )
    except (OSError, ValueError, OverflowError) as error:
        raise _open_error(device, baud, error) from error


def _open_error(device: str, baud: int, error: Exception) -> DeviceError:
    number = getattr(error, "errno", None)
    text = str(error)
    if (
        number in _HELD
        or "exclusively lock" in text
        or (sys.platform == "win32" and "PermissionError" in text)
    ):
        return PortHeldError(device)
    if number in {errno.EACCES, errno.EPERM}:
        return DeviceSetupError(f"you may not use {device}: {_permission_advice(device)}")
    if number in _GONE or "FileNotFoundError" in text:
        return NoPortError(
            f"there is no port {device}", hint="`zbot serial --list` shows the ports"
        )
    if isinstance(error, (ValueError, OverflowError)):
        return DeviceError(f"{device} does not know the baud rate {baud}: try 115200 or 9600")
    return DeviceError(f"{device} does not open: {text}")


def _permission_advice(device: str) -> str:
    group = "dialout"
    if sys.platform != "win32":
        import grp  # noqa: PLC0415 - Windows has none

        with contextlib.suppress(OSError, KeyError):
            group = grp.getgrgid(Path(device).stat().st_gid).gr_name
    if group == "root":
        group = "dialout"
    user = os.environ.get("USER", "$USER")
    return f"type `sudo usermod -a -G {group} {user}`, then log out and log in again"
